/** Normals to draw a mesh with while the slider moves: one pass over the triangles, where `cornerNormals` takes many. */

import type { TriangleMesh } from '../../engine/core/core';

/** Cosine of 30 degrees: a corner whose face is turned further away from its vertex is at a crease, and is shaded flat. */
const LEAST_COSINE = Math.sqrt(3) / 2;

/** Unit normals[3 corner + c]: the area-weighted normal of the vertex, or at creases that of the face; 0 where neither exists. */
export function quickNormals({ positions, triangles }: TriangleMesh): Float32Array {
  const faces = faceNormals(positions, triangles);
  const sums = new Float32Array(positions.length);
  for (let corner = 0; corner < triangles.length; corner++) {
    const [to, from] = [3 * triangles[corner], corner - (corner % 3)];
    sums[to] += faces[from];
    sums[to + 1] += faces[from + 1];
    sums[to + 2] += faces[from + 2];
  }
  normalise(sums);
  normalise(faces);
  const normals = new Float32Array(3 * triangles.length);
  for (let corner = 0; corner < triangles.length; corner++) {
    const [at, face] = [3 * triangles[corner], corner - (corner % 3)];
    const cosine = sums[at] * faces[face] + sums[at + 1] * faces[face + 1] + sums[at + 2] * faces[face + 2];
    const [values, from] = cosine < LEAST_COSINE ? [faces, face] : [sums, at];
    normals[3 * corner] = values[from];
    normals[3 * corner + 1] = values[from + 1];
    normals[3 * corner + 2] = values[from + 2];
  }
  return normals;
}

/** normals[3 t + c], twice as long as the area of triangle t. */
function faceNormals(positions: Float32Array, triangles: Uint32Array): Float32Array {
  const normals = new Float32Array(triangles.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    const ux = positions[b] - positions[a];
    const uy = positions[b + 1] - positions[a + 1];
    const uz = positions[b + 2] - positions[a + 2];
    const vx = positions[c] - positions[a];
    const vy = positions[c + 1] - positions[a + 1];
    const vz = positions[c + 2] - positions[a + 2];
    normals[t] = uy * vz - uz * vy;
    normals[t + 1] = uz * vx - ux * vz;
    normals[t + 2] = ux * vy - uy * vx;
  }
  return normals;
}

function normalise(vectors: Float32Array): void {
  for (let i = 0; i < vectors.length; i += 3) {
    const [x, y, z] = [vectors[i], vectors[i + 1], vectors[i + 2]];
    const length = Math.sqrt(x * x + y * y + z * z);
    if (length === 0) continue;
    vectors[i] = x / length;
    vectors[i + 1] = y / length;
    vectors[i + 2] = z / length;
  }
}
