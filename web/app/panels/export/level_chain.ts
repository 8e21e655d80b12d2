/** A chain of levels of detail: its shares of the faces from text, and the sizes on the screen at which its levels change. */

import { coverageOf, LINES } from '../../../engine/document/write/level_nodes';
import { checkSetting } from '../../../engine/settings/options';
import { readNumber } from '../../../engine/settings/kinds';
import { refusalOf } from '../../state/refusal';

/** Digits of a share that stands for a number of faces: enough for a million. */
const DIGITS = 1e6;

/**
 * The shares that a list with commas stands for: "0.25", "25 %" or, above 1, a number of the `faces` of the file. Text that is no number
 * comes back as it is, and the range check refuses it.
 */
export function readLevels(text: string, faces: number): unknown[] {
  const plain = text.replaceAll(/\s/g, '');
  if (plain === '') return [];
  return plain.split(',').map((word) => readShare(word, faces));
}

/** The first word of such a list, as it is typed, that stands for no level of a file of so many faces; null for none. */
export function firstNoLevel(text: string, faces: number): string | null {
  const isLevel = (share: unknown): boolean => refusalOf(text, () => checkSetting('lods', [share])) === null;
  const wrong = readLevels(text, faces).findIndex((share) => !isLevel(share));
  return wrong < 0 ? null : text.split(',')[wrong].trim();
}

function readShare(word: string, faces: number): unknown {
  const value = readNumber(word.replace(/%$/, ''));
  if (typeof value !== 'number') return word;
  if (word.endsWith('%')) return Number((value / 100).toPrecision(12));
  // Rounded up, so that the share of the faces is not one less.
  return value > 1 && Number.isInteger(value) ? Math.ceil((value / faces) * DIGITS) / DIGITS : value;
}

/** The next level of a chain: half of the last one, the first being what is kept now. */
export const nextLevel = (lods: readonly number[], kept: number): number =>
  Number(((lods.at(-1) ?? kept) / 2).toPrecision(2));

/**
 * Per further level the height on the screen, in pixels of the diagonal, below which it takes over: there it is one pixel from the
 * original at most. `deviations`: of the further levels, % of the diagonal.
 */
export const switchHeights = (deviations: readonly number[]): number[] =>
  coverageOf([...deviations])
    .slice(0, -1)
    .map((share) => share * LINES);

/** The number of the level that is shown at a height, 0 for the first. */
export const levelAtHeight = (heights: readonly number[], height: number): number =>
  heights.filter((from) => height < from).length;
