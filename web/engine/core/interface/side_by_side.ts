/** Calls of one function for many inputs, on all threads. */

import type { CompareFunctions } from './compare';
import type { FitFunctions } from './fit';
import type { ModesFunctions } from './modes';
import type { SimplifyFunctions } from './simplify';

/** The functions that can be called side by side; see `offerSideBySide` in wasm/bind. */
export type ManyFunctions = Pick<ModesFunctions, 'findModes' | 'strainGuidance'> &
  Pick<SimplifyFunctions, 'simplify'> &
  Pick<FitFunctions, 'fitShape'> &
  Pick<CompareFunctions, 'measureSurfaceDistance' | 'measureHausdorff' | 'isWithinHausdorff'>;

export type ManyName = keyof ManyFunctions;

/** The functions of the core on this topic. */
export interface SideBySideFunctions {
  /**
   * Calls the function once for each list of arguments. Results are the same as of single calls; where one of these would throw an
   * Error, it is in its place.
   */
  callAll<Name extends ManyName>(
    name: Name,
    lists: Parameters<ManyFunctions[Name]>[],
  ): (ReturnType<ManyFunctions[Name]> | Error)[];
}
