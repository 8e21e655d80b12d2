/**
 * What a brush has painted on the vertices of a file, as text: `MESH:LEVELS` for each painted mesh of the file (numbers from
 * 0), joined by `+`. LEVELS are runs of equal levels over the vertices in the order of `Body.positions`: each run is one
 * number, 16 length + level, in base-128 digits, lowest first, and base64 without `+` and `/`.
 */

import { SettingError } from './errors';

/** Levels from 1 to STRONGEST keep triangles, higher ones more strongly; 0 is unpainted. */
export const STRONGEST = 10;
/** The level of a locked vertex. */
export const LOCKED = STRONGEST + 1;

/** A level per vertex, in [0, LOCKED]. */
export type Levels = Uint8Array;

const LEVELS_SPAN = 16;
const DIGITS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_';

/** Levels of each painted mesh of the file; the empty text has none. Throws SettingError. */
export function parsePaint(text: string): Map<number, Levels> {
  const terms = text === '' ? [] : text.split('+');
  return new Map(
    terms.map((term) => {
      const found = /^(\d+):([\w-]+)$/.exec(term);
      if (!found) throw notPaint();
      return [Number(found[1]), levelsOfRuns(numbersOf(found[2]))];
    }),
  );
}

/** The text with these levels for one mesh of the file, which is removed if all of them are 0. */
export function withPaint(text: string, mesh: number, levels: Levels): string {
  const painted = parsePaint(text);
  painted.delete(mesh);
  if (levels.some((level) => level > 0)) painted.set(mesh, levels);
  return [...painted]
    .sort(([a], [b]) => a - b)
    .map(([number, one]) => `${number}:${wordOf(runsOf(one))}`)
    .join('+');
}

const notPaint = (): SettingError =>
  new SettingError('paint', 'is not text from the brush of the page: copy it from the page unchanged.');

function runsOf(levels: Levels): number[] {
  const runs: number[] = [];
  for (let from = 0, to = 0; from < levels.length; from = to) {
    while (to < levels.length && levels[to] === levels[from]) to++;
    runs.push((to - from) * LEVELS_SPAN + levels[from]);
  }
  return runs;
}

function levelsOfRuns(runs: number[]): Levels {
  const length = runs.reduce((sum, run) => sum + Math.floor(run / LEVELS_SPAN), 0);
  if (length > 0xffffffff || runs.some((run) => run % LEVELS_SPAN > LOCKED)) throw notPaint();
  const levels = new Uint8Array(length);
  let at = 0;
  for (const run of runs) levels.fill(run % LEVELS_SPAN, at, (at += Math.floor(run / LEVELS_SPAN)));
  return levels;
}

/** Encodes six bits a letter; the unused bits of the last one are 0. */
function wordOf(numbers: number[]): string {
  const bytes: number[] = [];
  for (let number of numbers) {
    for (; number >= 128; number = Math.floor(number / 128)) bytes.push((number % 128) + 128);
    bytes.push(number);
  }
  let word = '';
  for (let i = 0; i < bytes.length; i += 3) {
    const bits = (bytes[i] << 16) | ((bytes[i + 1] ?? 0) << 8) | (bytes[i + 2] ?? 0);
    const letters = [18, 12, 6, 0].map((shift) => DIGITS[(bits >> shift) & 63]).join('');
    word += letters.slice(0, Math.min(3, bytes.length - i) + 1);
  }
  return word;
}

function numbersOf(word: string): number[] {
  const numbers: number[] = [];
  let [bits, bitCount, number, scale] = [0, 0, 0, 1];
  for (const letter of word) {
    bits = ((bits << 6) | DIGITS.indexOf(letter)) & 0xffff;
    bitCount += 6;
    if (bitCount < 8) continue;
    bitCount -= 8;
    const byte = (bits >> bitCount) & 255;
    number += (byte % 128) * scale;
    scale *= 128;
    if (byte >= 128) continue;
    numbers.push(number);
    [number, scale] = [0, 1];
  }
  return numbers;
}
