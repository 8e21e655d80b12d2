/** Whether a scenario that moves its pins finds any to move. */

import { boundsOf } from '../core/mesh';
import { scenarioWords } from '../core/scenarios';
import type { ScenarioName } from '../core/scenarios';

/**
 * Whether nothing moves, as the scenario moves nothing but pins beyond the middle of the longest side, and these are all before it:
 * `pinTarget` in wasm/simulate/scenario.cpp. `positions`: of the original, as it stands; `pinned`: null for those of the scenario.
 */
export function areAllStill(
  scenario: ScenarioName,
  positions: Float32Array,
  pinned: Uint32Array | null,
): boolean {
  if (pinned === null || !scenarioWords(scenario).movesPins) return false;
  const { low, high } = boundsOf(positions);
  const sizes = high.map((value, axis) => value - low[axis]);
  const axis = sizes.indexOf(Math.max(...sizes));
  return pinned.every((v) => positions[3 * v + axis] <= (low[axis] + high[axis]) / 2);
}
