/** Checks whether the original has converged, in a worker of its own, so that neither the motion nor the page waits for it. */

import { expose } from 'comlink';
import { loadCore } from '../../engine/core/load_core';
import type { Convergence } from '../../engine/motion/convergence';
import type { TwinSetup } from './simulation_protocol';
import { standingSetup } from './standing_setup';
import { calibrationFor, twinOptions } from './twin_options';

export interface ConvergenceApi {
  /** Moves both bodies through the whole scenario, and the original once more with twice the substeps. */
  measure(wasmFolder: string, setup: TwinSetup): Promise<Convergence>;
}

const api: ConvergenceApi = {
  measure: async (wasmFolder, asked) => {
    const setup = standingSetup(asked);
    const core = await loadCore({ wasmFolder, threads: 1 });
    const { original, result } = setup;
    const options = {
      ...twinOptions(setup),
      calibration: calibrationFor(core, setup),
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
