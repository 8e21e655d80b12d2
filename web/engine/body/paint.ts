/**
 * What a brush has painted on the vertices of a file, as text that is a setting like others: `MESH:LEVELS` for each painted
 * mesh of the file (numbers from 0), joined by `+`. LEVELS are runs of equal levels over the vertices in the order of
 * `Body.positions`: each run is one number, 16 length + level, in base-128 digits, lowest first, and base64 without `+` and `/`.
 */

import { NONE } from '../core/core';
import type { PreparedBody } from './prepared_body';

/** Levels from 1 to STRONGEST keep triangles, the stronger the higher; 0 is bare. */
export const STRONGEST = 10;
/** The level of a vertex that stays as it is. */
export const LOCKED = STRONGEST + 1;

/** A level per vertex of a body. */
export type Levels = Uint8Array;

const LEVELS_SPAN = 16;
const DIGITS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_';
const NOT_PAINT = 'is not what the brush writes: take it from the page as it is';

/** Levels of each painted mesh of the file; the empty text has none. Throws one sentence where it is no such text. */
export function parsePaint(text: string): Map<number, Levels> {
  const terms = text === '' ? [] : text.split('+');
  return new Map(
    terms.map((term) => {
      const found = /^(\d+):([\w-]+)$/.exec(term);
      if (!found) throw new Error(`--paint ${NOT_PAINT}.`);
      return [Number(found[1]), levelsOfRuns(numbersOf(found[2]))];
    }),
  );
}

/** The text with these levels for one mesh of the file; bare ones take the mesh out. */
export function withPaint(text: string, mesh: number, levels: Levels): string {
  const painted = parsePaint(text);
  painted.delete(mesh);
  if (levels.some((level) => level > 0)) painted.set(mesh, levels);
  return [...painted]
    .sort(([a], [b]) => a - b)
    .map(([number, one]) => `${number}:${wordOf(runsOf(one))}`)
    .join('+');
}

/** Per vertex of the welded mesh the highest level of its sources; null where the mesh is bare. */
export function paintOn(
  text: string,
  { body, weld, mesh }: Pick<PreparedBody, 'weld' | 'mesh'> & { body: { name: string; mesh: number } },
): Levels | null {
  const levels = parsePaint(text).get(body.mesh);
  if (!levels) return null;
  const { vertexOfSource } = weld;
  if (levels.length !== vertexOfSource.length)
    throw new Error(
      `--paint is for ${levels.length} vertices, but "${body.name}" has ${vertexOfSource.length}: take the file that was painted.`,
    );
  return weldLevels(levels, vertexOfSource, mesh.positions.length / 3);
}

/** `vertexOfSource` as WeldResult has it. */
export function weldLevels(levels: Levels, vertexOfSource: Uint32Array, vertexCount: number): Levels {
  const welded = new Uint8Array(vertexCount);
  levels.forEach((level, source) => {
    const vertex = vertexOfSource[source];
    if (vertex !== NONE) welded[vertex] = Math.max(welded[vertex], level);
  });
  return welded;
}

/** Back from the welded mesh to its sources. */
export function unweldLevels(welded: Levels, vertexOfSource: Uint32Array): Levels {
  return Uint8Array.from(vertexOfSource, (vertex) => (vertex === NONE ? 0 : welded[vertex]));
}

/** The keep weights that the levels stand for, in [0, 1]; of a locked vertex 1. */
export const keepOfLevels = (levels: Levels): Float32Array =>
  Float32Array.from(levels, (level) => Math.min(level, STRONGEST) / STRONGEST);

/** The vertices that stay as they are, ascending. */
export function lockedIn(levels: Levels): number[] {
  const locked: number[] = [];
  levels.forEach((level, vertex) => {
    if (level === LOCKED) locked.push(vertex);
  });
  return locked;
}

/** What a stroke with the brush does at a vertex, by how near it is to the middle: `nearness` in [0, 1]. */
export function painted(level: number, tool: 'keep' | 'lock' | 'erase', nearness: number): number {
  if (tool === 'erase') return 0;
  if (tool === 'lock') return LOCKED;
  return level === LOCKED ? level : Math.max(level, Math.ceil(STRONGEST * nearness));
}

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
  if (length > 0xffffffff || runs.some((run) => run % LEVELS_SPAN > LOCKED))
    throw new Error(`--paint ${NOT_PAINT}.`);
  const levels = new Uint8Array(length);
  let at = 0;
  for (const run of runs) levels.fill(run % LEVELS_SPAN, at, (at += Math.floor(run / LEVELS_SPAN)));
  return levels;
}

/** Six bits a letter; what is left over of the last one is 0. */
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
  let [bits, held, number, scale] = [0, 0, 0, 1];
  for (const letter of word) {
    bits = ((bits << 6) | DIGITS.indexOf(letter)) & 0xffff;
    held += 6;
    if (held < 8) continue;
    held -= 8;
    const byte = (bits >> held) & 255;
    number += (byte % 128) * scale;
    scale *= 128;
    if (byte >= 128) continue;
    numbers.push(number);
    [number, scale] = [0, 1];
  }
  return numbers;
}
