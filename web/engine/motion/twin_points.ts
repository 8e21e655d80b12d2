/** Finds a point of one of two bound bodies on the other, so that both can be dragged there. */

import type { Binding, SurfacePoint, TriangleMesh } from '../core/core';
import { NONE } from '../core/core';

type Point = [number, number, number];

/** The position of a surface point when the vertices are at `positions`. */
export function positionOf(triangles: Uint32Array, positions: Float32Array, point: SurfacePoint): Point {
  return [0, 1, 2].map((c) =>
    [0, 1, 2].reduce(
      (sum, k) => sum + point.barycentric[k] * positions[3 * triangles[3 * point.triangle + k] + c],
      0,
    ),
  ) as Point;
}

/**
 * The point of `optimized` that a point of `original` is bound to: the closest one to the weighted mean of its corners'
 * bound points. Only the triangles around these are searched, so that a nearby sheet is never mistaken for this one.
 */
export function onOptimized(
  original: TriangleMesh,
  optimized: TriangleMesh,
  binding: Binding,
  point: SurfacePoint,
): SurfacePoint {
  const corners = [...original.triangles.subarray(3 * point.triangle, 3 * point.triangle + 3)];
  const bound = corners.map((v) => binding.triangle[v]);
  const target: Point = [0, 0, 0];
  corners.forEach((v, k) => {
    if (bound[k] === NONE) return;
    const barycentric = [...binding.barycentric.subarray(3 * v, 3 * v + 3)] as Point;
    const at = positionOf(optimized.triangles, optimized.positions, { triangle: bound[k], barycentric });
    for (let c = 0; c < 3; ++c) target[c] += point.barycentric[k] * at[c];
  });
  return closestPoint(optimized, target, around(optimized, new Set(bound)));
}

/** The point of `original` that corresponds to a point of `optimized`. */
export function onOriginal(
  original: TriangleMesh,
  optimized: TriangleMesh,
  binding: Binding,
  point: SurfacePoint,
): SurfacePoint {
  const near = new Set(around(optimized, new Set([point.triangle])));
  const candidates: number[] = [];
  for (let t = 0; t < original.triangles.length / 3; ++t)
    if ([0, 1, 2].some((k) => near.has(binding.triangle[original.triangles[3 * t + k]]))) candidates.push(t);
  return closestPoint(original, positionOf(optimized.triangles, optimized.positions, point), candidates);
}

/** The triangles that share a vertex with one of `of`, including these. */
function around({ triangles }: TriangleMesh, of: Set<number>): number[] {
  const vertices = new Set<number>();
  for (const t of of) if (t !== NONE) for (let k = 0; k < 3; ++k) vertices.add(triangles[3 * t + k]);
  const found: number[] = [];
  for (let t = 0; t < triangles.length / 3; ++t)
    if ([0, 1, 2].some((k) => vertices.has(triangles[3 * t + k]))) found.push(t);
  return found;
}

/** The point closest to `target` at rest among the triangles in `candidates`, or among all if that is empty. */
export function closestPoint(mesh: TriangleMesh, target: Point, candidates: number[]): SurfacePoint {
  const all =
    candidates.length > 0 ? candidates : Array.from({ length: mesh.triangles.length / 3 }, (_, t) => t);
  let best: SurfacePoint = { triangle: all[0], barycentric: [1, 0, 0] };
  let least = Infinity;
  for (const triangle of all) {
    const point = { triangle, barycentric: closestBarycentric(mesh, triangle, target) };
    const distance = squaredDistance(positionOf(mesh.triangles, mesh.positions, point), target);
    if (distance >= least) continue;
    [least, best] = [distance, point];
  }
  return best;
}

const minus = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const squaredDistance = (a: Point, b: Point): number => dot(minus(a, b), minus(a, b));

/** The barycentric coordinates of the point of a triangle that is closest to `target`. */
function closestBarycentric({ positions, triangles }: TriangleMesh, t: number, target: Point): Point {
  const corners = [0, 1, 2].map((k) => {
    const at = 3 * triangles[3 * t + k];
    return [positions[at], positions[at + 1], positions[at + 2]] as Point;
  });
  const [u, v, w] = [minus(corners[1], corners[0]), minus(corners[2], corners[0]), minus(target, corners[0])];
  const [uu, uv, vv, uw, vw] = [dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w)];
  const area = uu * vv - uv * uv;
  const [b, c] = [(vv * uw - uv * vw) / area, (uu * vw - uv * uw) / area];
  if (area > 0 && b >= 0 && c >= 0 && b + c <= 1) return [1 - b - c, b, c];
  let [best, least]: [Point, number] = [[1, 0, 0], Infinity];
  for (let k = 0; k < 3; ++k) {
    const [from, to] = [corners[k], corners[(k + 1) % 3]];
    const along = minus(to, from);
    const length = dot(along, along);
    const share = length > 0 ? Math.min(1, Math.max(0, dot(minus(target, from), along) / length)) : 0;
    const at = from.map((value, i) => value + share * along[i]) as Point;
    const distance = squaredDistance(at, target);
    if (distance >= least) continue;
    least = distance;
    best = [0, 0, 0];
    best[k] = 1 - share;
    best[(k + 1) % 3] = share;
  }
  return best;
}
