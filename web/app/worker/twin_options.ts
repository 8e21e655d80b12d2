/** What a setup of the Test step asks of both bodies, for their motion and for its check. */

import type { SimulatedSolver, SimulationOptions } from '../../engine/core/core';
import { simulationOptions, solversAsTheyAre } from '../../engine/motion/simulation';
import { tunedSolvers } from '../../engine/solvers/solver_pair';
import type { TwinSetup } from './simulation_protocol';

export function twinOptions(setup: TwinSetup): SimulationOptions & { otherSolver: SimulatedSolver | null } {
  const { original, result, size, settings, pinned, tuned } = setup;
  const solvers = tuned
    ? tunedSolvers(tuned)
    : solversAsTheyAre(size, { original, result: result.mesh }, settings);
  return {
    ...simulationOptions(size, settings, pinned),
    solver: solvers?.original ?? null,
    otherSolver: solvers?.result ?? null,
  };
}
