/** Affine maps against what they do to points. */

import { expect, it } from 'vitest';
import { inverse, isSimilarity, product, scaleOf, transformed } from '../../web/engine/core/affine';

/** Turned by 30 degrees about z, scaled by 2 and moved. */
const [c, s] = [Math.sqrt(3), 1];
const TURNED = [c, s, 0, 0, -s, c, 0, 0, 0, 0, 2, 0, 3, -1, 5, 1];
const SHEARED = [1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 4, 0, 1, 2, 3, 1];

it('the inverse of a map undoes it', () => {
  for (const matrix of [TURNED, SHEARED]) {
    const both = product(inverse(matrix), matrix);
    both.forEach((value, i) => expect(value).toBeCloseTo(i % 5 === 0 ? 1 : 0, 12));
    const points = Float32Array.of(1, 2, 3, -4, 0, 0.5);
    const there = transformed(points, matrix);
    [...transformed(there, inverse(matrix))].forEach((value, i) => expect(value).toBeCloseTo(points[i], 5));
  }
  expect(inverse(new Array<number>(16).fill(0)).every(Number.isFinite)).toBe(false);
});

it('a similarity is a rotation, reflection, translation and uniform scale', () => {
  const mirrored = [-2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1];
  for (const matrix of [TURNED, mirrored]) {
    expect(isSimilarity(matrix)).toBe(true);
    expect(scaleOf(matrix)).toBeCloseTo(2, 12);
  }
  const uneven = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 3, 0, 0, 0, 0, 1];
  for (const matrix of [SHEARED, uneven, new Array<number>(16).fill(0), new Array<number>(16).fill(NaN)])
    expect(isSimilarity(matrix)).toBe(false);
});
