/** The fuzzer of the engine, which scripts/fuzz.mjs bundles and runs. */

import { loadCore } from '../../../web/engine/core/load_core';
import type { Door } from './doors';
import { visit } from './doors';
import type { Visit } from './doors';
import { keptTextDoors } from './kept_texts';
import { optimizeDoor } from './optimize';
import { readers } from './readers';
import { settingsDoors } from './settings';

/** All doors; the core is loaded from `wasmFolder`, an address with a final slash. */
export async function allDoors(wasmFolder: string): Promise<Door[]> {
  const core = await loadCore({ threads: 1, wasmFolder });
  return [...(await readers()), ...settingsDoors, ...keptTextDoors, optimizeDoor(core)];
}

export async function fuzz(
  doors: Door[],
  options: { seed: number; seconds: number },
  onVisit: (visit: Visit) => void,
): Promise<void> {
  for (const door of doors) onVisit(await visit(door, options));
}
