/** Maps a point of one of two bound bodies to the other, so that both can be dragged there. */

import { faceCount } from '../core/mesh';
import type { Binding, Core, SurfacePoint, TriangleMesh } from '../core/core';
import { NONE } from '../core/core';

type Point = [number, number, number];

/** Two bodies at rest, and where each vertex of the original lies on the optimized one. */
export interface BoundBodies {
  original: TriangleMesh;
  optimized: TriangleMesh;
  binding: Binding;
}

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
 * bound points. Only the triangles around these are searched, so that a point on another, nearby sheet is never taken.
 */
export function onOptimized(
  core: Core,
  { original, optimized, binding }: BoundBodies,
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
  return core.closestPoint(optimized, Uint32Array.from(around(optimized, new Set(bound))), target);
}

/** The point of `original` that corresponds to a point of `optimized`. */
export function onOriginal(
  core: Core,
  { original, optimized, binding }: BoundBodies,
  point: SurfacePoint,
): SurfacePoint {
  const near = new Set(around(optimized, new Set([point.triangle])));
  const candidates: number[] = [];
  for (let t = 0; t < faceCount(original); ++t)
    if ([0, 1, 2].some((k) => near.has(binding.triangle[original.triangles[3 * t + k]]))) candidates.push(t);
  const target = positionOf(optimized.triangles, optimized.positions, point);
  return core.closestPoint(original, Uint32Array.from(candidates), target);
}

/** The triangles of `of` and all that share a vertex with one of them. */
function around({ triangles }: TriangleMesh, of: Set<number>): number[] {
  const vertices = new Set<number>();
  for (const t of of) if (t !== NONE) for (let k = 0; k < 3; ++k) vertices.add(triangles[3 * t + k]);
  const found: number[] = [];
  for (let t = 0; t < triangles.length / 3; ++t)
    if ([0, 1, 2].some((k) => vertices.has(triangles[3 * t + k]))) found.push(t);
  return found;
}
