/** A chain of levels of detail: its face ratios from text, and the sizes on the screen at which its levels change. */

import { coverageOf, LINES } from '../../../engine/document/write/level_nodes';
import { checkSetting } from '../../../engine/settings/options';
import { readNumber } from '../../../engine/settings/kinds';
import { refusalOf } from '../../state/refusal';

/** Digits of a ratio that represents a number of faces: enough for a million. */
const DIGITS = 1e6;

/**
 * The ratios of a comma-separated list: "0.25", "25 %" or, above 1, a number of the `faces` of the file. Text that is
 * not a number is returned unchanged, and the range check refuses it.
 */
export function readLevels(text: string, faces: number): unknown[] {
  const plain = text.replaceAll(/\s/g, '');
  if (plain === '') return [];
  return plain.split(',').map((word) => readShare(word, faces));
}

/** The first word of such a list, as typed, that is not a valid level of a file with `faces` faces; null if all are valid. */
export function firstNoLevel(text: string, faces: number): string | null {
  const isLevel = (share: unknown): boolean => refusalOf(text, () => checkSetting('lods', [share])) === null;
  const wrong = readLevels(text, faces).findIndex((share) => !isLevel(share));
  return wrong < 0 ? null : text.split(',')[wrong].trim();
}

function readShare(word: string, faces: number): unknown {
  const value = readNumber(word.replace(/%$/, ''));
  if (typeof value !== 'number') return word;
  if (word.endsWith('%')) return Number((value / 100).toPrecision(12));
  // Rounded up, so that the ratio does not give one face less.
  return value > 1 && Number.isInteger(value) ? Math.ceil((value / faces) * DIGITS) / DIGITS : value;
}

/** The next level of a chain: half of the last one; the first level is the current result. */
export const nextLevel = (lods: readonly number[], kept: number): number =>
  Number(((lods.at(-1) ?? kept) / 2).toPrecision(2));

/**
 * Per further level the height on the screen, in pixels of the diagonal, below which it takes over: there it deviates
 * from the original by one pixel at most. `deviations`: of the further levels, % of the diagonal.
 */
export const switchHeights = (deviations: readonly number[]): number[] =>
  coverageOf([...deviations])
    .slice(0, -1)
    .map((share) => share * LINES);

/** The index of the level that is shown at a height, 0 for the first. */
export const levelAtHeight = (heights: readonly number[], height: number): number =>
  heights.filter((from) => height < from).length;
