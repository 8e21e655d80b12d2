/** The fuzzer of the engine, which scripts/fuzz.mjs bundles and runs. */

import { loadCore } from '../../../web/engine/core/load_core';
import type { FuzzTarget } from './fuzz_target';
import { fuzzTarget } from './fuzz_target';
import type { FuzzResult } from './fuzz_target';
import { keptTextTargets } from './kept_texts';
import { optimizeTarget } from './optimize';
import { readers } from './readers';
import { settingsTargets } from './settings';

/** All targets; the core is loaded from `wasmFolder`, an address with a final slash. */
export async function allTargets(wasmFolder: string): Promise<FuzzTarget[]> {
  const core = await loadCore({ threads: 1, wasmFolder });
  return [...(await readers()), ...settingsTargets, ...keptTextTargets, optimizeTarget(core)];
}

export async function fuzz(
  targets: FuzzTarget[],
  options: { seed: number; seconds: number },
  onResult: (result: FuzzResult) => void,
): Promise<void> {
  for (const target of targets) onResult(await fuzzTarget(target, options));
}
