/** What a solver's parameters depend on besides the material: how large a mesh is, and how fine. */

import type { TriangleMesh } from '../core/core';
import { length3 } from '../core/exact_math';
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

/** The facts of a welded mesh with at least one face; `unit` in metres per unit of its positions. */
export function meshFacts(mesh: TriangleMesh, unit: number): MeshFacts {
  const { positions, triangles } = mesh;
  const count = vertexCount(mesh);
  const along = (from: number, to: number): number[] =>
    [0, 1, 2].map((c) => positions[3 * to + c] - positions[3 * from + c]);
  const seen = new Set<number>();
  let [area, length] = [0, 0];
  for (let t = 0; t < triangles.length; t += 3) {
    const corners = [triangles[t], triangles[t + 1], triangles[t + 2]];
    const [a, b] = [along(corners[0], corners[1]), along(corners[0], corners[2])];
    area += length3(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]) / 2;
    corners.forEach((from, k) => {
      const to = corners[(k + 1) % 3];
      const key = Math.min(from, to) * count + Math.max(from, to);
      if (seen.has(key)) return;
      seen.add(key);
      const [x, y, z] = along(from, to);
      length += length3(x, y, z);
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
