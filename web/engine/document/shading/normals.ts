/** Vertex normals for display: either smooth and split along sharp edges, or face normals. */

import { vertexCount } from '../../core/mesh';
import type { TriangleMesh } from '../../core/core';
import { arcCosine, length3 } from '../../core/exact_math';

/** Cosine of 60 degrees: normals are split at edges whose faces meet at a larger angle. */
const CREASE_COSINE = 0.5;
/** A cosine below which edges are hard that makes all edges hard except those within planes. */
export const ALL_HARD = 2;
/**
 * Cosine of a ten-thousandth of a radian: faces that meet at less share a normal. It is narrower than FLAT_STEPS of hard_edges.ts, which
 * only classifies edges, because a shared normal is a mean and must not differ visibly from that of a face.
 */
const FLAT_COSINE = 1 - 5e-9;

export interface CornerNormals {
  /** per corner 3 * t + k: the lowest corner of the same vertex that shares its normal */
  group: Uint32Array;
  /** unit normals, normals[3 * corner + c]; filled at group corners only */
  normals: Float32Array;
}

/** Normals of a mesh, computed at the first query. A key identifies one normal. */
export interface ResultNormals {
  /** edges whose faces meet at a smaller cosine are hard */
  hardCosine: number;
  /** equal for corners at one vertex that are connected through edges that are not hard */
  smoothKey(corner: number): number;
  /** the unit normal of a key */
  at(key: number): ArrayLike<number>;
}

/** `hardCosine`: edges whose faces meet at a smaller cosine are hard; by default those beyond 60 degrees. */
export function resultNormals(mesh: TriangleMesh, hardCosine = CREASE_COSINE): ResultNormals {
  let computed: CornerNormals | null = null;
  const all = () => (computed ??= cornerNormals(mesh, Math.min(hardCosine, FLAT_COSINE)));
  return {
    hardCosine,
    smoothKey: (corner) => all().group[corner],
    at: (key) => all().normals.subarray(3 * key, 3 * key + 3),
  };
}

/** Angle-weighted normals over the corners of a vertex that are connected through edges that are not hard. */
export function cornerNormals(mesh: TriangleMesh, hardCosine = CREASE_COSINE): CornerNormals {
  const { triangles } = mesh;
  const faceNormals = unitFaceNormals(mesh);
  const group = smoothGroups(mesh, faceNormals, hardCosine);
  const sums = new Float64Array(3 * triangles.length);
  for (let corner = 0; corner < triangles.length; ++corner) {
    const [face, to] = [corner - (corner % 3), 3 * group[corner]];
    const angle = angleAt(mesh, corner);
    sums[to] += angle * faceNormals[face];
    sums[to + 1] += angle * faceNormals[face + 1];
    sums[to + 2] += angle * faceNormals[face + 2];
  }
  return { group, normals: normalise(group, sums, faceNormals) };
}

/** Unit normals normals[3 * t + c]; 0 for a triangle without area. */
export function unitFaceNormals(mesh: TriangleMesh): Float64Array {
  const normals = new Float64Array(mesh.triangles.length);
  putAreaNormals(mesh, normals);
  normaliseAll(normals);
  return normals;
}

/** Puts the normal of triangle t, twice as long as its area, at `normals[3 t + c]`. */
export function putAreaNormals(
  { positions, triangles }: TriangleMesh,
  normals: Float32Array | Float64Array,
): void {
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
}

/** Gives the vectors [3 i + c] length 1, in place; those without a length stay. */
export function normaliseAll(vectors: Float32Array | Float64Array): void {
  for (let i = 0; i < vectors.length; i += 3) {
    const length = length3(vectors[i], vectors[i + 1], vectors[i + 2]);
    if (!(length > 0)) continue;
    vectors[i] /= length;
    vectors[i + 1] /= length;
    vectors[i + 2] /= length;
  }
}

/** Interior angle at a corner, in radians. */
function angleAt({ positions, triangles }: TriangleMesh, corner: number): number {
  const [face, k] = [corner - (corner % 3), corner % 3];
  const at = 3 * triangles[corner];
  const next = 3 * triangles[face + ((k + 1) % 3)];
  const previous = 3 * triangles[face + ((k + 2) % 3)];
  let [along, a2, b2] = [0, 0, 0];
  for (let c = 0; c < 3; ++c) {
    const a = positions[next + c] - positions[at + c];
    const b = positions[previous + c] - positions[at + c];
    along += a * b;
    a2 += a * a;
    b2 += b * b;
  }
  const length = Math.sqrt(a2 * b2);
  return length > 0 ? arcCosine(along / length) : 0;
}

/** Per corner: the lowest corner of its group. */
function smoothGroups(mesh: TriangleMesh, faceNormals: Float64Array, hardCosine: number): Uint32Array {
  const { triangles } = mesh;
  const parent = Uint32Array.from(triangles.keys());
  const find = (corner: number): number => {
    while (parent[corner] !== corner) corner = parent[corner] = parent[parent[corner]];
    return corner;
  };
  const { first, corners } = cornersOfVertices(triangles, vertexCount(mesh));
  // Per vertex: the corner at v whose face has the edge to it, valid where `metAt` is v + 1.
  const cornerAcross = new Uint32Array(first.length);
  const metAt = new Uint32Array(first.length);
  for (let v = 0; v + 1 < first.length; ++v) {
    for (let at = first[v]; at < first[v + 1]; ++at) {
      const corner = corners[at];
      const [face, k] = [corner - (corner % 3), corner % 3];
      for (let step = 1; step < 3; ++step) {
        const neighbour = triangles[face + ((k + step) % 3)];
        const other = cornerAcross[neighbour];
        if (metAt[neighbour] !== v + 1) {
          metAt[neighbour] = v + 1;
          cornerAcross[neighbour] = corner;
        } else if (cosineBetween(faceNormals, corner, other) >= hardCosine) {
          const [a, b] = [find(corner), find(other)];
          parent[Math.max(a, b)] = Math.min(a, b);
        }
      }
    }
  }
  return parent.map((_, corner) => find(corner));
}

/** Between the faces of two corners. */
function cosineBetween(faceNormals: Float64Array, corner: number, other: number): number {
  const [a, b] = [corner - (corner % 3), other - (other % 3)];
  return (
    faceNormals[a] * faceNormals[b] +
    faceNormals[a + 1] * faceNormals[b + 1] +
    faceNormals[a + 2] * faceNormals[b + 2]
  );
}

/** The corners of vertex v are corners[first[v]] up to corners[first[v + 1]], ascending. */
function cornersOfVertices(triangles: Uint32Array, vertexCount: number) {
  const first = new Uint32Array(vertexCount + 1);
  for (const v of triangles) first[v + 1] += 1;
  for (let v = 0; v < vertexCount; ++v) first[v + 1] += first[v];
  const next = first.slice();
  const corners = new Uint32Array(triangles.length);
  triangles.forEach((v, corner) => (corners[next[v]++] = corner));
  return { first, corners };
}

/** Where a sum vanishes the face normal replaces it, and +z where the face has no area: normals must have length 1. */
function normalise(group: Uint32Array, sums: Float64Array, faceNormals: Float64Array): Float32Array {
  const normals = new Float32Array(sums.length);
  for (let corner = 0; corner < group.length; ++corner) {
    if (group[corner] !== corner) continue;
    const [at, face] = [3 * corner, corner - (corner % 3)];
    if (!putUnit(normals, at, sums, at) && !putUnit(normals, at, faceNormals, face)) normals[at + 2] = 1;
  }
  return normals;
}

/** Puts the direction of the vector `from[i + c]` at `to[at + c]`; false if it has none. */
function putUnit(to: Float32Array, at: number, from: Float64Array, i: number): boolean {
  const length = length3(from[i], from[i + 1], from[i + 2]);
  if (!(length > 1e-9)) return false;
  for (let c = 0; c < 3; ++c) to[at + c] = from[i + c] / length;
  return true;
}
