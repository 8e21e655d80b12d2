/** Where along the body each mode strains it, for the gallery's strips. */

import type { Core, ModeSet, TriangleMesh } from '../../engine/core';
import { STRIP } from './protocol';

/** strips[layer * STRIP + i]: mean strain rank of the faces whose centre lies in slab i along the longest axis. */
export function strainStrips(core: Core, mesh: TriangleMesh, modes: ModeSet): Float32Array {
  const slab = slabOfTriangle(mesh);
  const strips = new Float32Array(modes.layerCount * STRIP);
  for (let layer = 0; layer < modes.layerCount; layer++) {
    const { rank } = core.strainGuidance(mesh, modes, { layers: [layer], weights: [1], p: 2, threshold: 0 });
    const sums = new Float64Array(STRIP);
    const counts = new Float64Array(STRIP);
    rank.forEach((value, triangle) => {
      sums[slab[triangle]] += value;
      counts[slab[triangle]] += 1;
    });
    for (let i = 0; i < STRIP; i++) strips[layer * STRIP + i] = counts[i] > 0 ? sums[i] / counts[i] : 0;
  }
  return strips;
}

function slabOfTriangle({ positions, triangles }: TriangleMesh): Uint8Array {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  positions.forEach((value, i) => {
    low[i % 3] = Math.min(low[i % 3], value);
    high[i % 3] = Math.max(high[i % 3], value);
  });
  const size = high.map((value, axis) => value - low[axis]);
  const axis = size.indexOf(Math.max(...size));
  const coordinate = (corner: number): number => positions[3 * triangles[corner] + axis];
  return Uint8Array.from({ length: triangles.length / 3 }, (_, t) => {
    const centre = (coordinate(3 * t) + coordinate(3 * t + 1) + coordinate(3 * t + 2)) / 3;
    return Math.min(STRIP - 1, Math.floor((STRIP * (centre - low[axis])) / (size[axis] || 1)));
  });
}
