/** The common part of the generic spring families: one stiffness for all edges and one for all bends, the same on every mesh. */

import type { MeshFacts } from './mesh_facts';
import { springOfPlate } from './plate';
import type { NativeParameter, SolverProfile } from './profile';
import { CONTACT, DAMPING, DEFAULT_CONTACT } from './sheet_family';

type Shared = Pick<SolverProfile, 'parameters' | 'defaults' | 'constants' | 'elastic'>;

/**
 * A family with edges of the stiffness `stretch`. The default of `bend` is the bend ratio times the stiffness of the edges, times
 * `scale` of the original.
 */
export function netFamily(
  bend: Pick<NativeParameter, 'unit' | 'words'>,
  scale: (original: MeshFacts) => number,
): Shared {
  return {
    parameters: [
      { name: 'stretch', unit: 'N/m', min: 1e-12, max: 1e15, words: 'stiffness of every edge' },
      { name: 'bend', min: 0, max: 1e15, ...bend },
      { name: 'density', unit: 'kg/m2', min: 1e-12, max: 1e9, words: 'mass of a square metre' },
      DAMPING,
      ...CONTACT,
    ],
    defaults(material, original, given) {
      const stretch = given.stretch ?? springOfPlate(material);
      const density = material.density * material.thickness;
      const constants = { stretch, bend: material.bendRatio * stretch * scale(original), density };
      return { ...constants, self_distance: material.thickness, ...DEFAULT_CONTACT };
    },
    constants: (values, { unit }) => ({
      stretch: values.stretch,
      secondStretch: 0,
      bend: values.bend,
      poisson: 0,
      surfaceDensity: values.density,
      unit,
    }),
    elastic: (constants) => ({
      stretch: constants.stretch,
      bend: constants.bend,
      density: constants.surfaceDensity,
    }),
  };
}
