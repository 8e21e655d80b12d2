/** Calls of one function for many inputs, on all threads. */

import type { CompareFunctions } from './compare';
import type { FitFunctions } from './fit';
import type { ModesFunctions } from './modes';
import type { SimplifyFunctions } from './simplify';

/** The functions that can be called in parallel; see `offerParallel` in wasm/bind. */
export type ParallelFunctions = Pick<ModesFunctions, 'findModes' | 'strainGuidance'> &
  Pick<SimplifyFunctions, 'simplify'> &
  Pick<FitFunctions, 'fitShape'> &
  Pick<CompareFunctions, 'measureSurfaceDistance' | 'measureHausdorff' | 'isWithinHausdorff'>;

export type ParallelName = keyof ParallelFunctions;

/** The functions of the core on this topic. */
export interface ParallelCallFunctions {
  /**
   * Calls the function once for each list of arguments. Results are those of single calls; where a call would throw an
   * Error, that Error is returned instead of its result.
   */
  callAll<Name extends ParallelName>(
    name: Name,
    lists: Parameters<ParallelFunctions[Name]>[],
  ): (ReturnType<ParallelFunctions[Name]> | Error)[];
}
