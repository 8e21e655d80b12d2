/** Counts and bounds of flat arrays of vertices and triangles. */

import type { TriangleMesh } from './core';
import { length3 } from './exact_math';

export const vertexCount = ({ positions }: Pick<TriangleMesh, 'positions'>): number => positions.length / 3;

export const faceCount = ({ triangles }: Pick<TriangleMesh, 'triangles'>): number => triangles.length / 3;

/** An axis-aligned box; low[c] and high[c] in the units of the positions. */
export interface Bounds {
  low: number[];
  high: number[];
}

/** The bounding box of positions[3 v + c]; without positions its sides are inverted, from Infinity to -Infinity. */
export function boundsOf(positions: Float32Array | readonly number[]): Bounds {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  positions.forEach((value, i) => {
    low[i % 3] = Math.min(low[i % 3], value);
    high[i % 3] = Math.max(high[i % 3], value);
  });
  return { low, high };
}

/** The axis of the longest side of a box, the first of equal ones. */
export function longestAxis({ low, high }: Bounds): number {
  const sizes = high.map((value, axis) => value - low[axis]);
  return sizes.indexOf(Math.max(...sizes));
}

/** The length of the diagonal of the bounding box. */
export function diagonalOf(positions: Float32Array | readonly number[]): number {
  const { low, high } = boundsOf(positions);
  return length3(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

/** The sum, added from the first value to the last. */
export const sum = (values: readonly number[]): number => values.reduce((total, value) => total + value, 0);
