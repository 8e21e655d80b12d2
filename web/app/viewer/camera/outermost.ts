/** The outermost of many points, which stand for all of them where a camera is framed. */

import { Vector3 } from 'three';

/** Directions besides the axes: between two neighbours the outline is missed by at most some hundredths of its size. */
const DIRECTIONS = 64;
/** The number of points compared in these directions. */
const SAMPLES = 30_000;

/** Spread evenly over half a sphere: of each direction the points at both ends are found. */
const directions = Array.from({ length: DIRECTIONS }, (_, i) => {
  const y = (i + 0.5) / DIRECTIONS;
  const angle = i * Math.PI * (3 - Math.sqrt(5));
  return new Vector3(Math.cos(angle) * Math.sqrt(1 - y * y), y, Math.sin(angle) * Math.sqrt(1 - y * y));
});
const axes = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];

/** The points `[3 i + c]` that lie farthest out along the axes, exactly, and in many other directions; none twice. */
export function outermost(points: Float32Array): Vector3[] {
  const step = Math.max(1, Math.ceil(points.length / 3 / SAMPLES));
  const found = new Set([
    ...axes.flatMap((axis) => endsAlong(points, axis, 1)),
    ...directions.flatMap((direction) => endsAlong(points, direction, step)),
  ]);
  return [...found].map((i) => new Vector3().fromArray(points, 3 * i));
}

/** The points with the least and the largest offset in a direction. */
function endsAlong(points: Float32Array, { x, y, z }: Vector3, step: number): number[] {
  let [first, last] = [-1, -1];
  let [low, high] = [Infinity, -Infinity];
  for (let i = 0; 3 * i < points.length; i += step) {
    const offset = x * points[3 * i] + y * points[3 * i + 1] + z * points[3 * i + 2];
    if (offset < low) [low, first] = [offset, i];
    if (offset > high) [high, last] = [offset, i];
  }
  return [first, last].filter((i) => i >= 0);
}
