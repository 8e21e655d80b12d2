/** A tuned sheet for tests of what is written about it. */

import type { Tuned } from '../../../web/engine/core/core';
import { nativeValues } from '../../../web/engine/solvers/profile';
import { profileOf } from '../../../web/engine/solvers/profiles';
import type { SolverName } from '../../../web/engine/solvers/profiles';
import { statesOf, tunedConstants } from '../../../web/engine/solvers/tuned_body';
import type { TunedBody } from '../../../web/engine/solvers/tuned_body';
import { grid } from './shapes';

const MATERIAL = { young: 1e5, poisson: 0.3, density: 500, thickness: 0.01, bendRatio: 0.05 };
const original = grid(4, 4);
export const TUNED_SHEET = grid(1, 1);

/** A sheet of two triangles, as if it were tuned to one of 32. */
export function tunedBody(solver: SolverName, change: Partial<Tuned> = {}): TunedBody {
  const profile = profileOf(solver);
  const isNet = profile.stretch === 'edge-springs';
  const states = statesOf(
    profile,
    { original, result: TUNED_SHEET, unit: 1 },
    { material: MATERIAL, given: {} },
  );
  const tuned: Tuned = {
    stretchFactor: 1.25,
    bendFactor: 0.5,
    stretchField: new Float64Array(),
    bendField: new Float64Array(),
    stretchFactors: new Float64Array(),
    bendFactors: new Float64Array(),
    masses: Float64Array.of(1, 2, 2, 1 / 3),
    stretchVertices: isNet ? Uint32Array.of(0, 1, 1, 2, 0, 2, 2, 3, 1, 3) : TUNED_SHEET.triangles,
    bendVertices: profile.bend === 'cross-springs' ? Uint32Array.of(0, 3) : Uint32Array.of(1, 2, 0, 3),
    frequencies: { errorUntouched: 40, errorTuned: 5, errorUnseen: 7, errorOtherPins: 8 },
    frequencyStatus: 'found',
    kept: 'tuned',
    motionRefusal: '',
    motion: { scene: 'sway', untouched: 1.5, tuned: 0.4, noiseFloor: 0.01, kept: 'tuned' },
    ...change,
  };
  const constants = tunedConstants(states.original, states.untouched, tuned);
  const { facts } = states.untouched;
  return {
    ...{
      solver,
      tune: 'global',
      massRule: profile.takes.vertexMasses ? 'area' : 'vertex',
      mesh: TUNED_SHEET,
      tuned,
    },
    model: { stretch: profile.stretch, bend: profile.bend, mass: profile.mass },
    original: states.original,
    result: { values: nativeValues(profile, states.original, { constants, facts }), constants, facts },
    pins: Uint32Array.of(1, 3),
    substeps: 20,
  };
}
