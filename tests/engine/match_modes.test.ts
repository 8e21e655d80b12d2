import { expect, test } from 'vitest';
import { matchModes } from '../../web/engine/core/match_modes';

/** Modes as rows of displacements. */
const set = (...rows: number[][]) => ({
  shapes: Float32Array.from(rows.flat()),
  modesPerComponent: rows.length,
});

const before = set([1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 1]);

test('a mode is matched at another number, with another sign and amplitude', () => {
  const after = set([0, 0, 2, 0, 0, 2], [-1, 0, 0, 0, 0, 0], [0, 0.9, 0.1, 0, 0, 0]);
  expect(matchModes(before, after, [1, 2, 3])).toEqual([2, 3, 1]);
});

test('a missing motion has no match, and no mode is matched twice', () => {
  const after = set([0, 0, 0, 1, 0, 0], [1, 0.9, 0, 0, 0, 0]);
  expect(matchModes(before, after, [3])).toEqual([null]);
  expect(matchModes(before, after, [1, 2])).toEqual([2, null]);
});

test('modes of one solution match themselves', () => {
  expect(matchModes(before, before, [2, 3])).toEqual([2, 3]);
});
