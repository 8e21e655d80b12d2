/** Where each mode strains the body: along it, for the gallery's strips, and beside the other modes. */

import type { Core, ModeSet, TriangleMesh } from '../../engine/core/core';
import { hotFaces, sharedHotSpots } from '../../engine/stages/hot_spots';
import { STRIP } from './protocol';
import type { StrainOverview } from './protocol';

/** Each ordinal alone is ranked once; the strip takes means of the faces whose centre lies in slab i of the longest axis. */
export function strainOverview(core: Core, mesh: TriangleMesh, modes: ModeSet): StrainOverview {
  const slab = slabOfTriangle(mesh);
  const strips = new Float32Array(modes.modesPerComponent * STRIP);
  const hot = Array.from({ length: modes.modesPerComponent }, (_, ordinal) => {
    const { rank } = core.strainGuidance(mesh, modes, {
      ordinals: [ordinal],
      weights: [1],
      p: 2,
      threshold: 0,
    });
    strips.set(meanOverSlabs(rank, slab), ordinal * STRIP);
    return hotFaces(rank);
  });
  return { strips, shared: sharedHotSpots(hot) };
}

/** Per slab; 0 where it holds no face. */
function meanOverSlabs(rank: Float32Array, slab: Uint8Array): Float64Array {
  const sums = new Float64Array(STRIP);
  const counts = new Float64Array(STRIP);
  rank.forEach((value, triangle) => {
    sums[slab[triangle]] += value;
    counts[slab[triangle]] += 1;
  });
  return sums.map((sum, i) => (counts[i] > 0 ? sum / counts[i] : 0));
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
