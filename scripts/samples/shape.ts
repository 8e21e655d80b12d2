// The geometry of a sample, and operations that all generators need.

/** A welded triangle mesh in metres, +Y up; `triangles` are counter-clockwise seen from outside. */
export interface Shape {
  /** positions[3 * v + axis] */
  positions: Float32Array;
  /** triangles[3 * t + corner], indices of vertices */
  triangles: Uint32Array;
}

export type Point = readonly [number, number, number];

export const subtract = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const dot = (a: Point, b: Point) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const length = (a: Point) => Math.hypot(a[0], a[1], a[2]);
export const cross = (a: Point, b: Point): Point => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** Linear interpolation from `a` at 0 to `b` at 1. */
export const mix = (a: number, b: number, fraction: number) => a + (b - a) * fraction;

/** The angle between two directions, radians in [0, pi]; exact for small angles, where acos is not. */
export const angleBetween = (a: Point, b: Point) => Math.atan2(length(cross(a, b)), dot(a, b));

/** Vertex `v` of flat positions. */
export const pointAt = (positions: ArrayLike<number>, v: number): Point => [
  positions[3 * v],
  positions[3 * v + 1],
  positions[3 * v + 2],
];

/** A shape of `points` and `triangles`, moved to stand on y = 0 with its bounding box centred on the Y axis. */
export function standing(points: ArrayLike<number>, triangles: ArrayLike<number>): Shape {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; i++) {
    low[i % 3] = Math.min(low[i % 3], points[i]);
    high[i % 3] = Math.max(high[i % 3], points[i]);
  }
  const origin = [(low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2];
  const positions = Float32Array.from(points, (value, i) => value - origin[i % 3]);
  return { positions, triangles: Uint32Array.from(triangles) };
}
