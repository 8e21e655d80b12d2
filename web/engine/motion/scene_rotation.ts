/** How a node turns a mesh, so that what is up in the scene is up where gravity pulls. */

import { cross, dot } from '../core/vectors';
import type { Vector } from '../core/vectors';

/** A rotation, row by row: from the space of a mesh to one that stands as the scene does, with the mesh's own size and place. */
export type SceneRotation = readonly number[];

/** Turns by less than this, per component, change no picture. */
const NONE = 1e-6;

/**
 * The turn of a node's matrix, column by column; null: none. Exact for what is up; of a mirrored node the turn without the mirror,
 * of a sheared one the nearest whose y axis is that of the node.
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

/** Points, `points[3 i + c]`, turned; with `isBack` from the scene to the mesh. Without a turn the points themselves. */
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

/** What the ends of something are called, at the lower and at the higher coordinate. */
export interface EndNames {
  low: string;
  high: string;
}

const ENDS: readonly (readonly [string, string])[] = [
  ['Left end', 'Right end'],
  ['Bottom', 'Top'],
  ['Back end', 'Front end'],
];

/** What the low and the high end along an axis of the mesh (0 x, 1 y, 2 z) are in the scene, seen from the front. */
export function endNames(nodeMatrix: readonly number[], axis: number): EndNames {
  const way = [0, 1, 2].map((c) => nodeMatrix[4 * axis + c]);
  const most = way.reduce((best, value, c) => (Math.abs(value) > Math.abs(way[best]) ? c : best), 0);
  const [first, last] = ENDS[most];
  return way[most] < 0 ? { low: last, high: first } : { low: first, high: last };
}

/** The ends of a body that stands as the scene does, along an axis of the scene, as subjects of sentences. */
export const STANDING_ENDS: readonly EndNames[] = [
  { low: 'The left end', high: 'The right end' },
  { low: 'The bottom', high: 'The top' },
  { low: 'The back end', high: 'The front end' },
];
