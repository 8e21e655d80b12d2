/** Compares meshes with their mirror images. */

import type { TriangleMesh } from '../../../web/engine/core/core';

/** The faces as sorted texts of their points, each from its lowest corner; -1 mirrors the mesh across x = 0. */
export function facesOf({ positions, triangles }: TriangleMesh, side: 1 | -1): string[] {
  const point = (v: number) =>
    [side * positions[3 * v] + 0, positions[3 * v + 1], positions[3 * v + 2]].join(' ');
  const faces: string[] = [];
  for (let t = 0; t < triangles.length; t += 3) {
    const corners = (side === 1 ? [0, 1, 2] : [2, 1, 0]).map((c) => point(triangles[t + c]));
    const first = corners.indexOf([...corners].sort()[0]);
    faces.push([0, 1, 2].map((c) => corners[(first + c) % 3]).join(', '));
  }
  return faces.sort();
}
