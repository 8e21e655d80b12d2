/** Keeps the chosen modes the same motions when pins change, because their numbers then refer to other modes. */

import { effect, untracked } from '@preact/signals';
import { leadingMode } from '../../engine/core/mode_set';
import { matchModes } from '../../engine/core/match_modes';
import type { ModesResult } from '../worker/protocol';
import { areModesStale, changeSettings, results, status, wants } from './store';
import { withoutUndo } from './undo';
import { listed, say } from '../language/say';

/** The modes to which the chosen numbers refer, and their pins; null: the modes that arrive next. */
let basis: { modes: ModesResult; pins: string } | null = null;
let chosen: unknown = null;

/** Starts following the state. */
export function followModes(): void {
  effect(() => {
    const { modes } = wants.settings.value;
    if (modes === chosen) return;
    chosen = modes;
    // Numbers that arrive together with other pins, by undo or a link, refer to the modes with those pins.
    const known = untracked(() => (areModesStale.value ? null : results.modes.value));
    basis = known && { modes: known, pins: wants.settings.peek().pins };
  });
  effect(() => {
    const { value: found } = results.modes;
    untracked(() => found && !areModesStale.value && take(found));
  });
}

function take(found: ModesResult): void {
  const { pins, modes } = wants.settings.value;
  const before = basis;
  basis = { modes: found, pins };
  const isOfOneMesh = before?.modes.shapes.length === found.shapes.length;
  if (!before || before.pins === pins || !isOfOneMesh || !Array.isArray(modes)) return;
  follow(before.modes, found, modes);
}

function follow(before: ModesResult, found: ModesResult, modes: readonly number[]): void {
  const alike = matchModes(before, found, modes);
  const kept = alike.filter((number) => number !== null).sort((a, b) => a - b);
  if (kept.length === modes.length && kept.every((number, i) => number === modes[i])) return;
  const next = kept.length > 0 ? kept : ('auto' as const);
  chosen = next;
  withoutUndo(() => changeSettings({ modes: next, modeWeights: [] }));
  status.notice.value = { kind: 'info', text: describeChange(before, modes, alike) };
}

/** "With these pins mode 2 (twist) is now mode 3." */
function describeChange(
  before: ModesResult,
  modes: readonly number[],
  alike: readonly (number | null)[],
): string {
  const parts = modes.flatMap((mode, i) => {
    const name = leadingMode(before, mode - 1)?.name;
    if (alike[i] === mode) return [];
    const values = { mode, name: name ? ` (${say(name)})` : '', now: alike[i] ?? 0 };
    return alike[i] === null
      ? [say('nothing moves like mode {mode}{name} any more', values)]
      : [say('mode {mode}{name} is now mode {now}', values)];
  });
  return say('With these pins {changes}.', { changes: listed(parts) });
}
