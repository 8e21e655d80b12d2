/** Finds the corners that a body hangs by. */

import type { TriangleMesh } from '../core/core';
import { boundsOf } from '../core/mesh';

/**
 * The vertices at the two ends of the upper border, highest and leftmost and highest and rightmost, in ascending order. A
 * horizontal sheet hangs by its back border.
 */
export function topCorners({ positions }: TriangleMesh): Uint32Array {
  const { low, high } = boundsOf(positions);
  const size = high.map((value, c) => value - low[c]);
  // A horizontal sheet has no upper border, so its back border is used.
  const up = size[1] > 0.05 * Math.max(...size) ? 1 : 2;
  const sign = up === 1 ? 1 : -1;
  const across = up === 1 ? (size[0] >= size[2] ? 0 : 2) : 0;
  const farthest = (side: number): number => {
    let [best, most] = [0, -Infinity];
    for (let v = 0; v < positions.length / 3; ++v) {
      const height =
        (sign * positions[3 * v + up]) / (size[up] || 1) +
        (side * positions[3 * v + across]) / (size[across] || 1);
      if (height > most) [best, most] = [v, height];
    }
    return best;
  };
  return Uint32Array.from(new Set([farthest(-1), farthest(1)])).sort();
}
