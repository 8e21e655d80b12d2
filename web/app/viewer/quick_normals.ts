/** Normals for drawing a mesh while the slider moves: one pass over the triangles, while `cornerNormals` takes many. */

import type { TriangleMesh } from '../../engine/core/core';
import { normaliseAll, putAreaNormals } from '../../engine/document/shading/normals';

/** Cosine of 30 degrees: a corner whose face is turned further away from its vertex is at a crease, and is shaded flat. */
const MIN_COSINE = Math.sqrt(3) / 2;

/** Unit normals[3 corner + c]: the area-weighted normal of the vertex, or at creases that of the face; 0 where neither exists. */
export function quickNormals(mesh: TriangleMesh): Float32Array {
  const { positions, triangles } = mesh;
  const faces = new Float32Array(triangles.length);
  putAreaNormals(mesh, faces);
  const sums = new Float32Array(positions.length);
  for (let corner = 0; corner < triangles.length; corner++) {
    const [to, from] = [3 * triangles[corner], corner - (corner % 3)];
    sums[to] += faces[from];
    sums[to + 1] += faces[from + 1];
    sums[to + 2] += faces[from + 2];
  }
  normaliseAll(sums);
  normaliseAll(faces);
  const normals = new Float32Array(3 * triangles.length);
  for (let corner = 0; corner < triangles.length; corner++) {
    const [at, face] = [3 * triangles[corner], corner - (corner % 3)];
    const cosine = sums[at] * faces[face] + sums[at + 1] * faces[face + 1] + sums[at + 2] * faces[face + 2];
    const [values, from] = cosine < MIN_COSINE ? [faces, face] : [sums, at];
    normals[3 * corner] = values[from];
    normals[3 * corner + 1] = values[from + 1];
    normals[3 * corner + 2] = values[from + 2];
  }
  return normals;
}
