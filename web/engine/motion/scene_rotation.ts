/** The rotation of a mesh by its node, so that gravity pulls down in the scene. */

import { cross, dot } from '../core/vectors';
import type { Vector } from '../core/vectors';

/** A rotation, row by row: from the space of a mesh to one with the axes of the scene, but the mesh's own scale and origin. */
export type SceneRotation = readonly number[];

/** Rotations that differ from the identity by less than this, per component, are invisible. */
const NONE = 1e-6;

/**
 * The rotation of a node's matrix, which is given column by column; null: none. Exact for the up direction; of a reflected node the rotation without the reflection,
 * of a sheared one the nearest rotation whose y axis is that of the node.
 */
export function rotationOf(nodeMatrix: readonly number[]): SceneRotation | null {
  const column = (c: number): Vector => [nodeMatrix[4 * c], nodeMatrix[4 * c + 1], nodeMatrix[4 * c + 2]];
  const sign = dot(cross(column(0), column(1)), column(2)) < 0 ? -1 : 1;
  const y = unit(column(1));
  const [own] = [column(0).map((value) => sign * value) as Vector];
  const along = y ? dot(own, y) : 0;
  const x = y && unit(own.map((value, c) => value - along * y[c]) as Vector);
  if (!x || !y) return null;
  const z = cross(x, y);
  const rotation = [0, 1, 2].flatMap((row) => [x[row], y[row], z[row]]);
  const isNone = rotation.every((value, i) => Math.abs(value - (i % 4 === 0 ? 1 : 0)) < NONE);
  return isNone ? null : rotation;
}

/** Rotated points, `points[3 i + c]`; with `isBack` from the scene to the mesh. Without a rotation the points themselves. */
export function rotated(points: Float32Array, rotation: SceneRotation | null, isBack = false): Float32Array {
  if (!rotation) return points;
  const out = new Float32Array(points.length);
  const entry = (row: number, column: number) => rotation[isBack ? 3 * column + row : 3 * row + column];
  for (let i = 0; i < points.length; i += 3)
    for (let row = 0; row < 3; row++)
      out[i + row] =
        entry(row, 0) * points[i] + entry(row, 1) * points[i + 1] + entry(row, 2) * points[i + 2];
  return out;
}

function unit(vector: Vector): Vector | null {
  const length = Math.sqrt(dot(vector, vector));
  return length > 0 && Number.isFinite(length) ? (vector.map((value) => value / length) as Vector) : null;
}

/** Names of the ends at the lower and at the higher coordinate. */
export interface EndNames {
  low: string;
  high: string;
}

const ENDS: readonly (readonly [string, string])[] = [
  ['Left end', 'Right end'],
  ['Bottom', 'Top'],
  ['Back end', 'Front end'],
];

/** Names of the low and the high end along an axis of the mesh (0 x, 1 y, 2 z) in the scene, seen from the front. */
export function endNames(nodeMatrix: readonly number[], axis: number): EndNames {
  const way = [0, 1, 2].map((c) => nodeMatrix[4 * axis + c]);
  const most = way.reduce((best, value, c) => (Math.abs(value) > Math.abs(way[best]) ? c : best), 0);
  const [first, last] = ENDS[most];
  return way[most] < 0 ? { low: last, high: first } : { low: first, high: last };
}

/** Names of the ends along each axis of the scene, as subjects of sentences. */
export const SCENE_ENDS: readonly EndNames[] = [
  { low: 'The left end', high: 'The right end' },
  { low: 'The bottom', high: 'The top' },
  { low: 'The back end', high: 'The front end' },
];
