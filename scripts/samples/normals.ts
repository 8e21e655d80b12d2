// Vertex normals for display: vertices are duplicated at creases.

import { angleBetween, cross, dot, length, pointAt, subtract, type Point, type Shape } from './shape';

export interface ShadedShape {
  positions: Float32Array;
  normals: Float32Array;
  triangles: Uint32Array;
}

/**
 * Angle-weighted unit normals. Faces around a vertex share a normal if a path across edges with angles of at most
 * `creaseDegrees` connects them; otherwise the vertex is duplicated with bitwise equal coordinates. Vertices keep their
 * order, and copies of a vertex are consecutive.
 */
export function shade(shape: Shape, creaseDegrees: number): ShadedShape {
  const faceNormals = unitNormals(shape);
  const group = smoothCornerGroups(shape, faceNormals, Math.cos((creaseDegrees * Math.PI) / 180));
  const byVertex = [...shape.triangles.keys()].sort(
    (a, b) => shape.triangles[a] - shape.triangles[b] || a - b,
  );
  const vertexOf = new Map<number, number>();
  const triangles = new Uint32Array(shape.triangles.length);
  const positions: number[] = [];
  const sums: number[] = [];
  for (const corner of byVertex) {
    const root = group(corner);
    if (!vertexOf.has(root)) {
      vertexOf.set(root, positions.length / 3);
      positions.push(...pointAt(shape.positions, shape.triangles[corner]));
      sums.push(0, 0, 0);
    }
    const vertex = (triangles[corner] = vertexOf.get(root)!);
    const weight = cornerAngle(shape, corner);
    const normal = faceNormals[Math.floor(corner / 3)];
    for (let axis = 0; axis < 3; axis++) sums[3 * vertex + axis] += weight * normal[axis];
  }
  const normals = Float32Array.from(sums, (sum, i) => sum / length(pointAt(sums, Math.floor(i / 3))));
  return { positions: Float32Array.from(positions), normals, triangles };
}

function corners({ positions, triangles }: Shape, t: number): [Point, Point, Point] {
  const at = (corner: number) => pointAt(positions, triangles[3 * t + corner]);
  return [at(0), at(1), at(2)];
}

function unitNormals(shape: Shape): Point[] {
  return Array.from({ length: shape.triangles.length / 3 }, (_, t) => {
    const [a, b, c] = corners(shape, t);
    const normal = cross(subtract(b, a), subtract(c, a));
    const size = length(normal);
    return [normal[0] / size, normal[1] / size, normal[2] / size];
  });
}

function cornerAngle(shape: Shape, corner: number): number {
  const points = corners(shape, Math.floor(corner / 3));
  const [here, next, last] = [0, 1, 2].map((step) => points[((corner % 3) + step) % 3]);
  return angleBetween(subtract(next, here), subtract(last, here));
}

/** Union-find over face corners: across every edge that is not a crease, the two corners at each end are joined. */
function smoothCornerGroups({ triangles }: Shape, faceNormals: readonly Point[], smallestCosine: number) {
  const parent = Uint32Array.from(triangles, (_, corner) => corner);
  const root = (corner: number): number => {
    while (parent[corner] !== corner) corner = parent[corner] = parent[parent[corner]];
    return corner;
  };
  const join = (a: number, b: number) => {
    const [low, high] = [Math.min(root(a), root(b)), Math.max(root(a), root(b))];
    parent[high] = low;
  };
  const next = (corner: number) => (corner % 3 === 2 ? corner - 2 : corner + 1);
  const cornerOfEdge = new Map<string, number>();
  triangles.forEach((v, corner) => cornerOfEdge.set(`${v},${triangles[next(corner)]}`, corner));
  triangles.forEach((v, corner) => {
    const other = cornerOfEdge.get(`${triangles[next(corner)]},${v}`);
    if (other === undefined) return;
    const cosine = dot(faceNormals[Math.floor(corner / 3)], faceNormals[Math.floor(other / 3)]);
    if (cosine < smallestCosine) return;
    join(corner, next(other));
    join(next(corner), other);
  });
  return root;
}
