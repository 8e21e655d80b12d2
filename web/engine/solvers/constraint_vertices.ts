/** The constraints of a solver on a mesh, by their vertices, in the order of factors: see wasm/simulate/simulated_solver.h. */

import type { SolverModel, TriangleMesh } from '../core/core';

export interface ConstraintVertices {
  /** pairs, or the corners of triangles */
  stretch: number[][];
  /** pairs, or the edge and the corners opposite to it */
  bend: number[][];
}

interface Edge {
  a: number;
  b: number;
  /** the third corner of each triangle around it */
  opposite: number[];
}

export function constraintVertices(
  mesh: TriangleMesh,
  { stretch, bend }: Pick<SolverModel, 'stretch' | 'bend'>,
): ConstraintVertices {
  const edges = edgesOf(mesh);
  const bending = edges.filter(({ opposite: [k, l, ...more] }) => l !== undefined && k !== l && !more.length);
  return {
    stretch: stretch === 'edge-springs' ? edges.map(({ a, b }) => [a, b]) : trianglesOf(mesh),
    bend: bending.map(({ a, b, opposite }) => (bend === 'cross-springs' ? opposite : [a, b, ...opposite])),
  };
}

const trianglesOf = ({ triangles }: TriangleMesh): number[][] =>
  Array.from({ length: triangles.length / 3 }, (_, t) => [...triangles.subarray(3 * t, 3 * t + 3)]);

/** Each edge once, sorted by its lower vertex and then by the other. */
function edgesOf(mesh: TriangleMesh): Edge[] {
  const edges = new Map<string, Edge>();
  for (const corners of trianglesOf(mesh))
    corners.forEach((from, c) => {
      const to = corners[(c + 1) % 3];
      const [a, b] = from < to ? [from, to] : [to, from];
      const key = `${a} ${b}`;
      const edge = edges.get(key) ?? { a, b, opposite: [] };
      edge.opposite.push(corners[(c + 2) % 3]);
      edges.set(key, edge);
    });
  return [...edges.values()].sort((one, two) => one.a - two.a || one.b - two.b);
}
