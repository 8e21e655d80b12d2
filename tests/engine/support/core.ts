/** Loads the real core in either build. */

import type { Core, Progress } from '../../../web/engine/core/core';
import { loadCore } from '../../../web/engine/core/load_core';

export function loadTestCore(threads: number, onProgress?: (progress: Progress) => void): Promise<Core> {
  const wasmFolder = new URL('../../../public/wasm/', import.meta.url).href;
  return loadCore({ threads, wasmFolder, onProgress });
}
