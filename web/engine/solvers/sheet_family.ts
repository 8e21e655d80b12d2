/** The common part of the generic families with a material: the parameters of a thin sheet, the same on every mesh. */

import { meshIndependent, withEdge } from './profile';
import type { NativeParameter, SolverProfile } from './profile';
import { plateConstants, plateOf } from './plate';

export const DAMPING: NativeParameter = {
  name: 'damping',
  unit: '1/s',
  min: 0,
  max: 1000,
  words: 'rate at which velocities decay',
  role: 'damping',
  scaling: meshIndependent,
};

/** Contacts of the generic families. */
export const CONTACT: readonly NativeParameter[] = [
  {
    name: 'friction',
    unit: '',
    min: 0,
    max: 10,
    words: "Coulomb's coefficient",
    role: 'friction',
    scaling: meshIndependent,
  },
  {
    name: 'self_distance',
    unit: 'm',
    min: 0,
    max: 1e6,
    words: 'distance that parts of the body keep from each other',
    role: 'selfCollisionDistance',
    scaling: withEdge,
  },
];

export const DEFAULT_CONTACT = { damping: 0.5, friction: 0.5 };

const PARAMETERS: readonly NativeParameter[] = [
  { name: 'young', unit: 'Pa', min: 1e-6, max: 1e15, words: "Young's modulus" },
  { name: 'poisson', unit: '', min: -0.99, max: 0.49, words: "Poisson's ratio" },
  { name: 'thickness', unit: 'm', min: 1e-9, max: 1e6, words: 'thickness of the sheet' },
  { name: 'density', unit: 'kg/m3', min: 1e-9, max: 1e9, words: 'mass of a cubic metre' },
  DAMPING,
  ...CONTACT,
];

/** A family whose constants are those of a plate. */
export const sheetFamily: Pick<SolverProfile, 'parameters' | 'defaults' | 'constants' | 'elastic'> = {
  parameters: PARAMETERS,
  defaults({ young, poisson, thickness, density }) {
    return { young, poisson, thickness, density, self_distance: thickness, ...DEFAULT_CONTACT };
  },
  constants({ young, poisson, thickness, density }, { unit }) {
    const surfaceDensity = density * thickness;
    return { ...plateConstants({ young, poisson, thickness }), surfaceDensity, unit };
  },
  elastic(constants) {
    const plate = plateOf(constants);
    return { ...plate, density: constants.surfaceDensity / plate.thickness };
  },
};
