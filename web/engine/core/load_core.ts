/** Loads the WebAssembly core in Node, a web worker or a page, and wraps it in its typed interface. */

import { PHASES } from './core';
import type { Core, CoreOptions, Progress } from './core';
import { LARGEST_HEAP, SMALLEST_HEAP } from './memory_size';

/** More threads have not been found to help. */
const MAX_THREADS = 8;

type Observer = (phase: number, fraction: number) => void;
type CoreFunctions = Omit<Core, 'threads' | 'job' | 'peakHeapBytes' | 'heapLimit'>;

/** The exports of the module of wasm/bind. */
interface CoreModule extends CoreFunctions {
  wasmMemory: WebAssembly.Memory;
  jobAddress(): number;
  resetJob(observer: Observer | null): void;
  setThreadCount(count: number): void;
  peakHeapBytes(): number;
  limitHeap(bytes: number): void;
  /** the names of all functions that wasm/bind offers */
  functionNames(): (keyof CoreFunctions)[];
}

type CreateModule = (options: {
  threadCount: number;
  locateFile(name: string): string;
  wasmMemory: WebAssembly.Memory;
}) => Promise<CoreModule>;

/**
 * Loads the threaded build if memory can be shared and more than one thread is wanted, otherwise the one-thread build. The
 * choice precedes the import, because the threaded module cannot even start without shared memory.
 */
export async function loadCore(options: CoreOptions): Promise<Core> {
  const wanted = options.threads === 0 ? Math.min(coreCount(), MAX_THREADS) : options.threads;
  const canShare = typeof SharedArrayBuffer !== 'undefined';
  const threads = canShare ? wanted : 1;
  const name = threads > 1 ? 'limber-threads' : 'limber-single';
  const locateFile = (file: string): string =>
    options.addresses?.[file] ?? new URL(file, options.wasmFolder).href;
  const address = locateFile(`${name}.js`);
  const { default: createModule } = (await import(/* @vite-ignore */ address)) as { default: CreateModule };
  const { wasmMemory, heapLimit } = reserveMemory(options.memory ?? LARGEST_HEAP, threads > 1);
  const module = await createModule({ threadCount: threads, locateFile, wasmMemory });
  module.setThreadCount(threads);
  if (heapLimit < LARGEST_HEAP) module.limitHeap(heapLimit);
  return { ...wrapModule(module, threads, options.onProgress), heapLimit };
}

/** Engines reserve this address space at once, however small the maximum of the memory is. */
const NO_MEMORY =
  'The core gets no memory from the system: close what else takes it, or allow more address space (ulimit -v), of which WebAssembly takes 10 GB.';

/** Bytes of a page of WebAssembly memory. */
const PAGE = 2 ** 16;

/**
 * A memory that may grow to `bytes`, or to half of that, a quarter and so on where the engine lacks the address
 * space, as on phones. Throws an Error where the core could not start in it, or where there is none at all.
 */
function reserveMemory(
  bytes: number,
  shared: boolean,
): { wasmMemory: WebAssembly.Memory; heapLimit: number } {
  if (bytes < SMALLEST_HEAP) throw new Error('The core needs 64 MB of memory: give it more.');
  const maximum = Math.floor(Math.min(bytes, LARGEST_HEAP) / PAGE);
  try {
    const wasmMemory = new WebAssembly.Memory({ initial: SMALLEST_HEAP / PAGE, maximum, shared });
    return { wasmMemory, heapLimit: maximum * PAGE };
  } catch (error) {
    const half = (maximum * PAGE) / 2;
    if (!(error instanceof RangeError)) throw error;
    if (half < SMALLEST_HEAP) throw new Error(NO_MEMORY);
    return reserveMemory(half, shared);
  }
}

function wrapModule(
  module: CoreModule,
  threads: number,
  onProgress?: (progress: Progress) => void,
): Omit<Core, 'heapLimit'> {
  const observer: Observer | null = onProgress
    ? (phase, fraction) => onProgress({ phase: PHASES[phase], fraction })
    : null;
  const wrapped = module.functionNames().map((name) => [name, callOf(module, name, observer)]);
  const job = threads > 1 ? new Int32Array(module.wasmMemory.buffer, module.jobAddress(), 4) : null;
  return {
    ...(Object.fromEntries(wrapped) as CoreFunctions),
    threads,
    job,
    peakHeapBytes: () => module.peakHeapBytes(),
  };
}

/** Wraps a function of the core so that an exception, which arrives as a returned Error, is thrown. */
function callOf(module: CoreModule, name: keyof CoreFunctions, observer: Observer | null) {
  const inner = module[name] as (...values: unknown[]) => unknown;
  return (...values: unknown[]): unknown => {
    module.resetJob(observer);
    const result = inner(...values);
    if (Object.prototype.toString.call(result) === '[object Error]') throw result;
    return result;
  };
}

/** The number of logical cores. Node 20 has no navigator. */
function coreCount(): number {
  const { navigator, process } = globalThis as {
    navigator?: { hardwareConcurrency?: number };
    process?: { getBuiltinModule?(name: string): { availableParallelism(): number } };
  };
  return navigator?.hardwareConcurrency ?? process?.getBuiltinModule?.('node:os').availableParallelism() ?? 1;
}
