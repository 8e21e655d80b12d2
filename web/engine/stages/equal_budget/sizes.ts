/** Area and enclosed volume of a mesh. */

import type { TriangleMesh } from '../../core/core';
import { length3 } from '../../core/exact_math';

export interface Sizes {
  /** unit squared */
  area: number;
  /** unit cubed, positive where the faces look outwards; without meaning where the surface is open */
  volume: number;
}

/** Volume by the divergence theorem: a sixth of the sum of p . (q x r) over all triangles, seen from the first vertex. */
export function sizesOf({ positions, triangles }: TriangleMesh): Sizes {
  let [area, volume] = [0, 0];
  const at = (vertex: number, c: number): number => positions[3 * vertex + c] - positions[c];
  for (let t = 0; t < triangles.length; t += 3) {
    const [p, q, r] = [0, 1, 2].map((i) => [0, 1, 2].map((c) => at(triangles[t + i], c)));
    const [a, b] = [q, r].map((end) => end.map((value, c) => value - p[c]));
    area += length3(...cross(a, b)) / 2;
    const [x, y, z] = cross(q, r);
    volume += (p[0] * x + p[1] * y + p[2] * z) / 6;
  }
  return { area, volume };
}

const cross = ([ax, ay, az]: number[], [bx, by, bz]: number[]): [number, number, number] => [
  ay * bz - az * by,
  az * bx - ax * bz,
  ax * by - ay * bx,
];
