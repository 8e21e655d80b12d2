/**
 * Hard edges: those at which the normals of a file differ from one side to the other. Where they follow from the angle between the
 * faces, as in what smoothing by angle and flat shading write, that angle makes them again after any collapse.
 */

import { NONE } from '../core/core';
import type { TriangleMesh } from '../core/core';
import { arcCosine, length3 } from '../core/exact_math';
import { vertexCount } from '../core/mesh';
import { ALL_HARD, unitFaceNormals } from '../document/shading/normals';

/** Edges between exactly two triangles, as half-edges: number 3 t + k runs from corner k of triangle t to its next corner. */
export interface InnerEdges {
  first: number[];
  second: number[];
}

/** Angles are counted in this many steps up to 180 degrees. */
const STEPS = 18_000;
/** Faces that meet at fewer steps than this, a thousandth of a radian, are in one plane. */
const FLAT_STEPS = 6;

export function innerEdgesOf(mesh: TriangleMesh): InnerEdges {
  const { triangles } = mesh;
  const other = oppositeHalves(mesh);
  const edges: InnerEdges = { first: [], second: [] };
  for (let half = 0; half < triangles.length; ++half) {
    if (other[half] === NONE || other[half] === half) continue;
    edges.first.push(half);
    edges.second.push(other[half]);
  }
  return edges;
}

/** Of the first half-edge of each edge: the second one, itself where there are more than two; NONE for all others. */
function oppositeHalves(mesh: TriangleMesh): Uint32Array {
  const { triangles } = mesh;
  const nextAt = new Uint32Array(vertexCount(mesh)).fill(NONE);
  const next = new Uint32Array(triangles.length);
  for (let half = triangles.length - 1; half >= 0; --half) {
    const low = Math.min(triangles[half], triangles[nextCorner(half)]);
    next[half] = nextAt[low];
    nextAt[low] = half;
  }
  const other = new Uint32Array(triangles.length).fill(NONE);
  const firstTo = new Map<number, number>();
  for (const start of nextAt) {
    firstTo.clear();
    for (let half = start; half !== NONE; half = next[half]) {
      const high = Math.max(triangles[half], triangles[nextCorner(half)]);
      const first = firstTo.get(high);
      if (first === undefined) firstTo.set(high, half);
      else other[first] = other[first] === NONE ? half : first;
    }
  }
  return other;
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
 * ones with the least length of edges on the wrong side, the middle between the
 * cosines of the edges next to it. ALL_HARD where only edges within
 * planes are soft; null where no edge is hard, or hard edges do not bend more than soft ones.
 */
export function hardCosineOf(
  mesh: TriangleMesh,
  edges: InnerEdges,
  cosines: readonly number[],
  isHard: (edge: number) => boolean,
): number | null {
  // Per step: the lengths of its hard edges less those of its soft ones.
  const balance = new Float64Array(STEPS + 1);
  cosines.forEach((cosine, edge) => {
    balance[stepOf(cosine)] += lengthOf(mesh, edges.first[edge]) * (isHard(edge) ? 1 : -1);
  });
  const last = lastSoftStep(balance);
  let [bent, straight] = [-1, 1];
  let makesHard = false;
  cosines.forEach((cosine, edge) => {
    if (stepOf(cosine) <= last) straight = Math.min(straight, cosine);
    else {
      bent = Math.max(bent, cosine);
      makesHard ||= isHard(edge);
    }
  });
  if (!makesHard) return null;
  return last < FLAT_STEPS ? ALL_HARD : (straight + bent) / 2;
}

/** The step up to which edges are best taken for soft; -1: none is. */
function lastSoftStep(balance: Float64Array): number {
  // Before the first step every soft edge is wrong; each step changes the sum by its balance.
  let [wrong, least, last] = [0, 0, -1];
  balance.forEach((value, step) => {
    wrong += value;
    if (wrong >= least) return;
    least = wrong;
    last = step;
  });
  return last;
}

const stepOf = (cosine: number): number => Math.round((arcCosine(cosine) / Math.PI) * STEPS);

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
