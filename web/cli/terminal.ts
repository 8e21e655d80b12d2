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

/** A line shorter than the terminal, which else would go on to the next one: the name in front gives way. */
export function progressLine(activity: string, { phase, fraction }: Progress, columns = 80): string {
  const rest = `: ${phase} ${Math.round(100 * fraction)} %`;
  const [name, room] = [plain(activity), Math.max(0, columns - 1 - rest.length)];
  const shownName = name.length <= room ? name : `${name.slice(0, Math.max(0, room - 3))}...`;
  return `${shownName}${rest}`.slice(0, columns - 1);
}

export function showProgress(activity: string, progress: Progress): void {
  const text = progressLine(activity, progress, process.stderr.columns || 80);
  process.stderr.write(redrawn(text, shown));
  shown = text.length;
}

/** Empties the line, so that other text can be written. */
export function clearProgress(): void {
  if (shown > 0) process.stderr.write(`${redrawn('', shown)}\r`);
  shown = 0;
}
