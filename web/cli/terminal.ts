/**
 * The line of progress on a terminal. It is drawn without escape sequences, and nothing is coloured, so that NO_COLOR has
 * nothing to switch off; a dumb terminal, which cannot go back in its line, gets none.
 */

import type { Progress } from '../engine/core/core';
import { plain } from './words';

/** Characters of the line that is shown. */
let shown = 0;

/** Whether a line that is drawn over and over can be shown. */
export const canRedraw = (stream: { isTTY?: boolean }, term = process.env.TERM): boolean =>
  Boolean(stream.isTTY) && term !== 'dumb';

/** What takes the place of a line of `before` characters: blanks hide what is left of it. */
export const redrawn = (text: string, before: number): string => `\r${text.padEnd(before)}`;

export function showProgress(activity: string, { phase, fraction }: Progress): void {
  const text = `${plain(activity)}: ${phase} ${Math.round(100 * fraction)} %`;
  process.stderr.write(redrawn(text, shown));
  shown = text.length;
}

/** Empties the line, so that other text can be written. */
export function clearProgress(): void {
  if (shown > 0) process.stderr.write(`${redrawn('', shown)}\r`);
  shown = 0;
}
