/** Checks the pins of a scenario that moves its pins. */

import { boundsOf, longestAxis } from '../core/mesh';
import type { TriangleMesh } from '../core/core';
import { scenarioWords } from '../core/scenarios';
import type { ScenarioName } from '../core/scenarios';

/** Still: no pin moves, so nothing does. Torn: neighbouring pins are pulled apart, because only one of them moves. */
export type PinProblem = 'still' | 'torn';

/** Bits for what a scenario does with a pin. */
const [STAYS, MOVES] = [1, 2];

/**
 * The problem with pins in a scenario that moves only those beyond the middle of the longest side: `pinTarget` in
 * wasm/simulate/scenario.cpp. Null without a problem. `mesh`: the original, rotated as in its scene; `pinned`: null for the default pins of the scenario.
 */
export function findPinProblem(
  scenario: ScenarioName,
  mesh: TriangleMesh,
  pinned: Uint32Array | null,
): PinProblem | null {
  if (pinned === null || !scenarioWords(scenario).movesPins) return null;
  const isMoved = movedBy(mesh.positions);
  if (!pinned.some(isMoved)) return 'still';
  const { positions, triangles } = mesh;
  const pinOf = new Uint8Array(positions.length / 3);
  for (const v of pinned) pinOf[v] = isMoved(v) ? MOVES : STAYS;
  for (let t = 0; t < triangles.length; t += 3)
    if ((pinOf[triangles[t]] | pinOf[triangles[t + 1]] | pinOf[triangles[t + 2]]) === (STAYS | MOVES))
      return 'torn';
  return null;
}

/** How the reader writes a setting, with its value or without. */
type SettingText = (name: 'scenario' | 'pins', value?: string) => string;

/** The problem as a sentence without its full stop. */
export function describePinProblem(problem: PinProblem, scenario: ScenarioName, write: SettingText): string {
  const moves = `${write('scenario', scenario)} moves pins of the upper half`;
  const cure = `leave ${write('pins')} out or take ${write('scenario', 'sway')}`;
  return problem === 'still'
    ? `nothing moves: ${moves}, and ${write('pins')} has none there; ${cure}`
    : `${moves}, and of the neighbours in ${write('pins')} some lie beyond the middle and some do not, so that they are torn apart; ${cure}`;
}

/** Whether a vertex lies beyond the middle of the longest side. */
function movedBy(positions: Float32Array): (v: number) => boolean {
  const bounds = boundsOf(positions);
  const axis = longestAxis(bounds);
  const middle = (bounds.low[axis] + bounds.high[axis]) / 2;
  return (v) => positions[3 * v + axis] > middle;
}
