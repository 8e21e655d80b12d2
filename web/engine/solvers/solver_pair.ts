/** The parameters of an original and its result in a solver: untouched, with the same numbers typed in again, or tuned. */

import type { SimulatedSolver, TriangleMesh, Tuned } from '../core/core';
import { profileOf } from './profiles';
import { modelOf, statesOf } from './tuned_body';
import type { TunedBody, TuneRequest } from './tuned_body';

export interface SolverPair {
  original: SimulatedSolver;
  result: SimulatedSolver;
}

/** Both with the user's own parameters. `unit`: metres per unit of both meshes; `result` may be the original itself. */
export function untouchedSolvers(
  request: Omit<TuneRequest, 'tune' | 'runsTrial'>,
  meshes: { original: TriangleMesh; result: TriangleMesh; unit: number },
): SolverPair {
  const profile = profileOf(request.solver);
  const model = modelOf(profile, request.massRule);
  const { original, untouched } = statesOf(profile, meshes, request);
  return {
    original: { model, constants: original.constants },
    result: { model, constants: untouched.constants },
  };
}

/** The original with the user's own parameters, the result with everything that was tuned. */
export function tunedSolvers({ model, original, result, tuned }: TunedBody): SolverPair {
  return {
    original: { model, constants: original.constants },
    result: { model, constants: result.constants, masses: tuned.masses, ...factorsOf(model, tuned) },
  };
}

type Factors = Pick<SimulatedSolver, 'stretchFactors' | 'bendFactors'>;

/** The tuned factors per constraint, from maps over vertices or one by one. */
export function factorsOf(
  { stretch, bend }: SimulatedSolver['model'],
  tuned: Pick<
    Tuned,
    'stretchField' | 'bendField' | 'stretchFactors' | 'bendFactors' | 'stretchVertices' | 'bendVertices'
  >,
): Factors {
  const stretchSize = stretch === 'membrane' ? 3 : 2;
  const bendSize = bend === 'cross-springs' ? 2 : 4;
  const stretchFactors =
    overConstraints(tuned.stretchField, tuned.stretchVertices, stretchSize) ?? tuned.stretchFactors;
  const bendFactors = overConstraints(tuned.bendField, tuned.bendVertices, bendSize) ?? tuned.bendFactors;
  return {
    ...(stretchFactors.length > 0 ? { stretchFactors } : {}),
    ...(bendFactors.length > 0 && bend !== 'morley' ? { bendFactors } : {}),
  };
}

/** The mean of a field over the vertices of each constraint; null where there is no field. */
function overConstraints(field: Float64Array, vertices: Uint32Array, size: number): Float64Array | null {
  if (field.length === 0) return null;
  return Float64Array.from({ length: vertices.length / size }, (_, c) => {
    const own = vertices.subarray(size * c, size * c + size);
    return own.reduce((sum, v) => sum + field[v], 0) / size;
  });
}
