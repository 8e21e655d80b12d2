/** The regions that each mode strains: along the body, for the gallery's strips, and in comparison with the other modes. */

import type { Core, ModeSet, TriangleMesh } from '../../engine/core/core';
import { boundsOf, faceCount, longestAxis } from '../../engine/core/mesh';
import { hotFaces, sharedHotSpots } from '../../engine/report/hot_spots';
import { STRIP } from './protocol';
import type { StrainOverview } from './protocol';

/** Ranks the strain of each ordinal separately; value i of a strip is the mean over the faces with their centre in slab i of the longest axis. */
export function strainOverview(core: Core, mesh: TriangleMesh, modes: ModeSet): StrainOverview {
  const slab = slabOfTriangle(mesh);
  const strips = new Float32Array(modes.modesPerComponent * STRIP);
  const ranks = new Uint8Array(modes.modesPerComponent * faceCount(mesh));
  const hot = Array.from({ length: modes.modesPerComponent }, (_, ordinal) => {
    const { rank } = core.strainGuidance(mesh, ofOrdinal(modes, ordinal), {
      ordinals: [0],
      weights: [1],
      p: 2,
      threshold: 0,
    });
    strips.set(meanOverSlabs(rank, slab), ordinal * STRIP);
    for (let t = 0; t < rank.length; t++) ranks[ordinal * rank.length + t] = Math.round(255 * rank[t]);
    return hotFaces(rank);
  });
  return { strips, ranks, shared: sharedHotSpots(hot) };
}

/** Only the modes of one ordinal: otherwise the shapes of all modes would be copied into the core for each of them. */
function ofOrdinal(modes: ModeSet, ordinal: number): ModeSet {
  const size = modes.shapes.length / modes.modesPerComponent;
  const own = modes.modes.filter((mode) => mode.ordinal === ordinal);
  return {
    ...modes,
    modes: own.map((mode) => ({ ...mode, ordinal: 0 })),
    modesPerComponent: 1,
    shapes: modes.shapes.subarray(ordinal * size, (ordinal + 1) * size),
  };
}

/** The mean rank per slab; 0 in a slab without faces. */
function meanOverSlabs(rank: Float32Array, slab: Uint8Array): Float64Array {
  const sums = new Float64Array(STRIP);
  const counts = new Float64Array(STRIP);
  for (let t = 0; t < rank.length; t++) {
    sums[slab[t]] += rank[t];
    counts[slab[t]] += 1;
  }
  return sums.map((sum, i) => (counts[i] > 0 ? sum / counts[i] : 0));
}

function slabOfTriangle(mesh: TriangleMesh): Uint8Array {
  const { positions, triangles } = mesh;
  const bounds = boundsOf(positions);
  const axis = longestAxis(bounds);
  const low = bounds.low[axis];
  const size = bounds.high[axis] - low;
  const coordinate = (corner: number): number => positions[3 * triangles[corner] + axis];
  return Uint8Array.from({ length: faceCount(mesh) }, (_, t) => {
    const centre = (coordinate(3 * t) + coordinate(3 * t + 1) + coordinate(3 * t + 2)) / 3;
    return Math.min(STRIP - 1, Math.floor((STRIP * (centre - low)) / (size || 1)));
  });
}
