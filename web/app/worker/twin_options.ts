/** The simulation options of both bodies from a setup of the Test step, for their motion and for its check. */

import type { Core, SimulatedSolver, SimulationOptions } from '../../engine/core/core';
import { calibrationOf, simulationOptions, untouchedSolversOf } from '../../engine/motion/simulation';
import { tunedSolvers } from '../../engine/solvers/solver_pair';
import type { TwinSetup } from './simulation_protocol';

export function twinOptions(setup: TwinSetup): SimulationOptions & { otherSolver: SimulatedSolver | null } {
  const { original, result, size, settings, pinned, tuned } = setup;
  const solvers = tuned
    ? tunedSolvers(tuned)
    : untouchedSolversOf(size, { original, result: result.mesh }, settings);
  return {
    ...simulationOptions(size, settings, pinned),
    solver: solvers?.original ?? null,
    otherSolver: solvers?.result ?? null,
  };
}

/** Solvers are tuned instead. */
export const isCalibrated = ({ settings }: TwinSetup): boolean =>
  settings.calibrate && settings.solver === 'none';

/** The factor on Young's modulus of the result. */
export const calibrationFor = (core: Core, setup: TwinSetup): number => {
  const { original, result, size, settings } = setup;
  return isCalibrated(setup) ? calibrationOf(core, { ...size, mesh: original }, result.mesh, settings) : 1;
};
