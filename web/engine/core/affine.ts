/** Affine maps as 4 x 4 matrices, column by column, whose last row is 0, 0, 0, 1. */

import { length3 } from './exact_math';
import { cross, dot } from './vectors';
import type { Vector } from './vectors';

export type Matrix = ArrayLike<number>;

/** a b of two matrices. */
export function product(a: Matrix, b: Matrix): number[] {
  return Array.from({ length: 16 }, (_, i) => {
    const [row, column] = [i % 4, 4 * Math.floor(i / 4)];
    return [0, 1, 2, 3].reduce((sum, k) => sum + a[4 * k + row] * b[column + k], 0);
  });
}

/** The inverse, by cofactors; not finite where there is none. */
export function inverse(m: Matrix): number[] {
  const [x, y, z] = axesOf(m);
  const rows = [cross(y, z), cross(z, x), cross(x, y)];
  const determinant = dot(x, rows[0]);
  const turned = rows.map((row) => row.map((value) => value / determinant) as Vector);
  const moved = turned.map((row) => -dot(row, [m[12], m[13], m[14]]));
  const column = (c: number): number[] => [...turned.map((row) => row[c]), 0];
  return [...column(0), ...column(1), ...column(2), ...moved, 1];
}

/** Whether the map keeps angles, up to `tolerance`: a rotation, reflection, translation and uniform scale. */
export function isSimilarity(m: Matrix, tolerance = 1e-3): boolean {
  const axes = axesOf(m);
  const lengths = axes.map(([x, y, z]) => length3(x, y, z));
  const [smallest, largest] = [Math.min(...lengths), Math.max(...lengths)];
  if (!(smallest > 0) || !Number.isFinite(largest) || largest > (1 + tolerance) * smallest) return false;
  const [x, y, z] = axes;
  const most = tolerance * largest * largest;
  return [dot(x, y), dot(y, z), dot(z, x)].every((value) => Math.abs(value) <= most);
}

/** The scale factor of a similarity. */
export const scaleOf = (m: Matrix): number => length3(m[0], m[1], m[2]);

/** positions[3 v + c] under the map, rounded to 32 bits. */
export function transformed(positions: Float32Array, m: Matrix): Float32Array {
  const result = new Float32Array(positions.length);
  for (let at = 0; at < positions.length; at += 3)
    for (let c = 0; c < 3; ++c)
      result[at + c] =
        m[c] * positions[at] + m[4 + c] * positions[at + 1] + m[8 + c] * positions[at + 2] + m[12 + c];
  return result;
}

/** The images of the axes: the first three columns. */
const axesOf = (m: Matrix): Vector[] => [0, 4, 8].map((at) => [m[at], m[at + 1], m[at + 2]]);
