/**
 * Hard edges: those at which the normals of a file differ from one side to the other. Where they follow from the angle between the
 * faces, as in what smoothing by angle and flat shading write, that angle makes them again after any collapse.
 */

import { NONE } from '../core/core';
import type { TriangleMesh } from '../core/core';
import { length3 } from '../core/exact_math';
import { vertexCount } from '../core/mesh';
import { ALL_HARD, unitFaceNormals } from '../document/shading/normals';

/** Edges between exactly two triangles, as half-edges: number 3 t + k runs from corner k of triangle t to its next corner. */
export interface InnerEdges {
  first: number[];
  second: number[];
}

/** Faces that meet at a cosine above this are in one plane: an angle of a thousandth. */
const FLAT_COSINE = 1 - 0.5e-6;

export function innerEdgesOf(mesh: TriangleMesh): InnerEdges {
  const { triangles } = mesh;
  const lastAt = new Uint32Array(vertexCount(mesh)).fill(NONE);
  const previous = new Uint32Array(triangles.length);
  const edges: InnerEdges = { first: [], second: [] };
  const ends = (half: number) => [triangles[half], triangles[nextCorner(half)]];
  triangles.forEach((_, half) => {
    const low = Math.min(...ends(half));
    previous[half] = lastAt[low];
    lastAt[low] = half;
  });
  lastAt.forEach((last, low) => {
    const halvesOf = new Map<number, number[]>();
    for (let half = last; half !== NONE; half = previous[half]) {
      const [a, b] = ends(half);
      const high = a === low ? b : a;
      const known = halvesOf.get(high);
      if (known) known.push(half);
      else halvesOf.set(high, [half]);
    }
    for (const halves of halvesOf.values()) {
      if (halves.length !== 2) continue;
      edges.first.push(halves[0]);
      edges.second.push(halves[1]);
    }
  });
  return edges;
}

/** Per edge: the cosine of the angle between its two faces. */
export function cosinesOf(mesh: TriangleMesh, { first, second }: InnerEdges): number[] {
  const normals = unitFaceNormals(mesh);
  return first.map((half, edge) => {
    const [a, b] = [half - (half % 3), second[edge] - (second[edge] % 3)];
    return normals[a] * normals[b] + normals[a + 1] * normals[b + 1] + normals[a + 2] * normals[b + 2];
  });
}

/**
 * The cosine below which the angle between two faces makes their edge hard: of all angles the one that tells hard edges from soft
 * ones with the least length of edges on the wrong side, the middle between the two edges next to it. ALL_HARD where only edges
 * within planes are soft; null where no edge is hard, or hard edges do not bend more than soft ones.
 */
export function hardCosineOf(
  mesh: TriangleMesh,
  edges: InnerEdges,
  cosines: readonly number[],
  isHard: (edge: number) => boolean,
): number | null {
  const order = Array.from(cosines, (_, edge) => edge).sort((a, b) => cosines[b] - cosines[a] || a - b);
  // From the angle 0 on, where every soft edge is wrong. Each edge that the angle passes changes the sum.
  let [wrong, least, softer] = [0, 0, 0];
  order.forEach((edge, i) => {
    wrong += lengthOf(mesh, edges.first[edge]) * (isHard(edge) ? 1 : -1);
    if (wrong >= least || cosines[order[i + 1]] === cosines[edge]) return;
    least = wrong;
    softer = i + 1;
  });
  if (!order.slice(softer).some(isHard)) return null;
  const below = softer === 0 ? 1 : cosines[order[softer - 1]];
  return below > FLAT_COSINE ? ALL_HARD : (below + cosines[order[softer]]) / 2;
}

/** The corners of both faces at the first end of the edge, and those at its second end. */
export function endsOf(
  { triangles }: TriangleMesh,
  { first, second }: InnerEdges,
  edge: number,
): [number, number][] {
  const [a, b] = [first[edge], nextCorner(first[edge])];
  const [c, d] = [second[edge], nextCorner(second[edge])];
  return triangles[a] === triangles[c]
    ? [
        [a, c],
        [b, d],
      ]
    : [
        [a, d],
        [b, c],
      ];
}

const nextCorner = (corner: number): number => corner - (corner % 3) + ((corner + 1) % 3);

function lengthOf({ positions, triangles }: TriangleMesh, half: number): number {
  const [a, b] = [3 * triangles[half], 3 * triangles[nextCorner(half)]];
  const along = (axis: number) => positions[b + axis] - positions[a + axis];
  return length3(along(0), along(1), along(2));
}
