/** Size and resolution of a mesh, on which a solver's parameters depend besides the material. */

import type { TriangleMesh } from '../core/core';
import { length3 } from '../core/exact_math';
import { cross, difference } from '../core/vectors';
import type { Vector } from '../core/vectors';
import { faceCount, vertexCount } from '../core/mesh';

export interface MeshFacts {
  /** m2 */
  area: number;
  vertices: number;
  faces: number;
  /** mean length of the edges, each counted once, m */
  meanEdge: number;
  /** metres per unit of the mesh */
  unit: number;
}

/** A triangle is flat if its height is at most this share of its longest edge. */
const FLAT = 1e-7;

/** Whether a triangle of the mesh has no area, up to the rounding of its positions. */
export function hasFlatTriangles({ positions, triangles }: TriangleMesh): boolean {
  const point = (corner: number): Vector => {
    const first = 3 * triangles[corner];
    return [positions[first], positions[first + 1], positions[first + 2]];
  };
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [point(t), point(t + 1), point(t + 2)];
    const edges = [difference(a, b), difference(b, c), difference(c, a)];
    const longest = Math.max(...edges.map((edge) => length3(...edge)));
    if (!(doubleArea(edges[0], edges[1]) > FLAT * longest * longest)) return true;
  }
  return false;
}

const doubleArea = (a: Vector, b: Vector): number => length3(...cross(a, b));

/** The facts of a welded mesh with at least one face; `unit` in metres per unit of its positions. */
export function meshFacts(mesh: TriangleMesh, unit: number): MeshFacts {
  const { positions, triangles } = mesh;
  const count = vertexCount(mesh);
  const point = (v: number): Vector => [positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]];
  const along = (first: number, second: number): Vector => difference(point(first), point(second));
  const seen = new Set<number>();
  let [area, length] = [0, 0];
  for (let t = 0; t < triangles.length; t += 3) {
    const corners = [triangles[t], triangles[t + 1], triangles[t + 2]];
    area += doubleArea(along(corners[0], corners[1]), along(corners[0], corners[2])) / 2;
    corners.forEach((first, k) => {
      const second = corners[(k + 1) % 3];
      const key = Math.min(first, second) * count + Math.max(first, second);
      if (seen.has(key)) return;
      seen.add(key);
      length += length3(...along(first, second));
    });
  }
  return {
    area: area * unit * unit,
    vertices: count,
    faces: faceCount(mesh),
    meanEdge: (length * unit) / seen.size,
    unit,
  };
}
