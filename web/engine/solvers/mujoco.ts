/**
 * MuJoCo 4, a two-dimensional flex with elastic2d="both" (XMLreference, flexcomp/elasticity). Stretching is a constant-strain
 * St. Venant-Kirchhoff membrane in plane stress, read off `flex_stiffness` of one triangle: E h / (2 (1 + nu)) and
 * E h nu / (1 - nu^2). Bending is the cotangent operator of Wardetzky et al. 2007 (user_mesh.cc, ComputeBending), a hinge
 * 1/2 (3 D l^2 / (A1 + A2)) (d theta)^2 with D = E h^3 / (36 (1 - nu^2)), a third of a plate's, read off `flex_bending` of one
 * hinge. `mass` of a flexcomp is shared out equally over its vertices; body_mass, flex_stiffness and flex_bending of a compiled
 * model can be changed. `damping` (s) multiplies the stiffness, so that damping follows it. Coarser or finer meshes need no other
 * time step for the same motion.
 */

import { plateConstants, plateOf } from './plate';
import { meshIndependent, withEdge } from './profile';
import type { SolverProfile } from './profile';

/** A plate's flexural rigidity over that of the flex. */
const SOFTER = 3;

export const mujoco: SolverProfile = {
  name: 'mujoco',
  label: 'MuJoCo',
  words: 'MuJoCo: a two-dimensional flex',
  stretch: 'membrane',
  bend: 'hinge-area',
  mass: 'vertex',
  takes: { vertexMaps: true, constraintValues: true, vertexMasses: true },
  status: 'verified',
  isLocal: false,
  parameters: [
    { name: 'young', unit: 'Pa', min: 1e-6, max: 1e15, words: "Young's modulus" },
    { name: 'poisson', unit: '', min: -0.99, max: 0.49, words: "Poisson's ratio" },
    { name: 'thickness', unit: 'm', min: 1e-9, max: 1e6, words: 'thickness of the sheet' },
    { name: 'mass', unit: 'kg', min: 1e-9, max: 1e9, words: 'of the whole flex' },
    {
      name: 'damping',
      unit: 's',
      min: 0,
      max: 1000,
      words: "Rayleigh's coefficient: damping over stiffness",
      role: 'damping',
      scaling: meshIndependent,
    },
    {
      name: 'radius',
      unit: 'm',
      min: 0,
      max: 1e3,
      words: 'of every element in contacts',
      role: 'collisionThickness',
      scaling: withEdge,
    },
    {
      name: 'friction',
      unit: '',
      min: 0,
      max: 100,
      words: 'sliding coefficient of contacts',
      role: 'friction',
      scaling: meshIndependent,
    },
  ],
  defaults({ young, poisson, thickness, density }, { area }) {
    const mass = density * thickness * area;
    return { young, poisson, thickness, mass, damping: 0, radius: 0.005, friction: 1 };
  },
  constants({ young, poisson, thickness, mass }, { area, unit }) {
    const plate = plateConstants({ young, poisson, thickness });
    return { ...plate, bend: plate.bend / SOFTER, surfaceDensity: mass / area, unit };
  },
  elastic(constants, { area }) {
    const plate = plateOf({ ...constants, bend: SOFTER * constants.bend });
    return { ...plate, mass: constants.surfaceDensity * area };
  },
};
