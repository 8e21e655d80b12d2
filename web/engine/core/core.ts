/**
 * The typed interface of the C++ core: plain data and free functions with the same names as in `wasm/`. Typed arrays are
 * copied in both directions. Between calls the core keeps only running simulations (see simulated_bodies.ts), and the
 * meshes and histories of `keepMesh` and `keepHistory`.
 */

import type { MeshFunctions } from './interface/mesh';
import type { ModesFunctions } from './interface/modes';
import type { SimplifyFunctions } from './interface/simplify';
import type { FitFunctions } from './interface/fit';
import type { TransferFunctions } from './interface/transfer';
import type { CompareFunctions } from './interface/compare';
import type { ParallelCallFunctions } from './interface/parallel_calls';
import type { SimulateFunctions } from './interface/simulate';
import type { TuneFunctions } from './interface/tune';
import type { Progress } from './interface/job';

export * from './interface/material';
export * from './interface/mesh';
export * from './interface/modes';
export * from './interface/simplify';
export * from './interface/fit';
export * from './interface/transfer';
export * from './interface/compare';
export * from './interface/parallel_calls';
export * from './interface/simulate';
export * from './interface/tune';
export * from './interface/job';

/**
 * The core. Every function is synchronous and may run for a long time: call it off the main thread. All functions throw
 * an Error whose message is one sentence; a cancelled call throws an Error whose name is 'Cancelled'.
 */
export interface Core
  extends
    MeshFunctions,
    ModesFunctions,
    SimplifyFunctions,
    FitFunctions,
    TransferFunctions,
    CompareFunctions,
    ParallelCallFunctions,
    SimulateFunctions,
    TuneFunctions {
  /** 1 in the one-thread build */
  threads: number;
  /**
   * The job's four words in shared memory ([0] request to cancel, [1] phase, [2] progress in 1/10,000), through which other
   * threads read the progress and request cancellation while a call runs. null in the one-thread build, which reports
   * progress through `onProgress` only.
   */
  job: Int32Array | null;
  /** the present size of the wasm memory, in bytes; it never shrinks, so that this is the peak */
  peakHeapBytes(): number;
  /** bytes to which the wasm memory may grow */
  heapLimit: number;
}

export interface CoreOptions {
  /** 0: min(cores, 8); 1 loads the one-thread build */
  threads: number;
  /** the address of the folder with limber-threads.js and limber-single.js, with a final slash */
  wasmFolder: string;
  /** addresses of files of the core that are not in the folder, by name */
  addresses?: Readonly<Record<string, string>>;
  /** bytes to which the memory of the core may grow, from 64 MiB up to 4 GiB, which is the default */
  memory?: number;
  /** called on the calling thread in either build, at most once per percent */
  onProgress?: (progress: Progress) => void;
}
