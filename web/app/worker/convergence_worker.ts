/** Sees whether the original has converged, in a worker of its own, so that neither the motion nor the page waits for it. */

import { expose } from 'comlink';
import { loadCore } from '../../engine/core/load_core';
import type { Convergence } from '../../engine/motion/convergence';
import { calibrationOf } from '../../engine/motion/simulation';
import type { TwinSetup } from './simulation_protocol';
import { standingSetup } from './standing_setup';
import { twinOptions } from './twin_options';

export interface ConvergenceApi {
  /** Moves both bodies through the whole scenario, and the original once more with twice the substeps. */
  measure(wasmFolder: string, setup: TwinSetup): Promise<Convergence>;
}

const api: ConvergenceApi = {
  measure: async (wasmFolder, asked) => {
    const setup = standingSetup(asked);
    const core = await loadCore({ wasmFolder, threads: 1 });
    const { original, result, size, settings } = setup;
    const isCalibrated = settings.calibrate && settings.solver === 'none';
    const options = {
      ...twinOptions(setup),
      calibration: isCalibrated ? calibrationOf(core, { ...size, mesh: original }, result.mesh, settings) : 1,
      records: false,
      binding: core.bindToResult(original, result),
    };
    const { substeps, substepDeviation, deviationMean, isConverged } = core.compareMotion(
      original,
      result.mesh,
      options,
    );
    return { substeps, substepDeviation, deviationMean, isConverged };
  },
};

expose(api);
