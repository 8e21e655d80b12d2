/** How much a body in motion is stretched. */

import type { TriangleMesh } from '../core/core';
import { length3 } from '../core/exact_math';

/** Edges of a mesh, each once: vertices edges[2 * e], edges[2 * e + 1], the lower first. */
export function edgesOf({ positions, triangles }: TriangleMesh): Uint32Array {
  const count = positions.length / 3;
  const keys = new Float64Array(triangles.length);
  triangles.forEach((a, corner) => {
    const b = triangles[corner % 3 === 2 ? corner - 2 : corner + 1];
    keys[corner] = Math.min(a, b) * count + Math.max(a, b);
  });
  keys.sort();
  const unique = keys.filter((key, i) => i === 0 || key !== keys[i - 1]);
  const edges = new Uint32Array(2 * unique.length);
  unique.forEach((key, e) => edges.set([Math.floor(key / count), key % count], 2 * e));
  return edges;
}

const lengthOf = (positions: Float32Array, edges: Uint32Array, e: number): number => {
  const [a, b] = [3 * edges[2 * e], 3 * edges[2 * e + 1]];
  return length3(
    positions[a] - positions[b],
    positions[a + 1] - positions[b + 1],
    positions[a + 2] - positions[b + 2],
  );
};

/** Measures how far the edges of a body are from their lengths at rest. */
export class Stretch {
  private readonly edges: Uint32Array;
  private readonly rest: Float64Array;

  constructor(mesh: TriangleMesh) {
    this.edges = edgesOf(mesh);
    this.rest = Float64Array.from({ length: this.edges.length / 2 }, (_, e) =>
      lengthOf(mesh.positions, this.edges, e),
    );
  }

  /** Mean over the edges of | length / length at rest - 1 |, in %. */
  mean(positions: Float32Array): number {
    let [sum, counted] = [0, 0];
    this.rest.forEach((rest, e) => {
      if (!(rest > 0)) return;
      sum += Math.abs(lengthOf(positions, this.edges, e) / rest - 1);
      counted += 1;
    });
    return counted > 0 ? (100 * sum) / counted : 0;
  }
}
