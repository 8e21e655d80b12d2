/** The arrays that the viewport draws for a mesh; large meshes are prepared in a worker, see prepared_arrays.ts. */

import type { TriangleMesh } from '../../engine/core/core';
import { cornerNormals } from '../../engine/document/shading/normals';
import { quickNormals } from './quick_normals';
import { isLarge } from './twin_surface';

export interface DrawnArrays {
  /** positions[3 * corner + c] */
  positions: Float32Array;
  /** unit normals[3 * corner + c]; null: the shader computes them */
  normals: Float32Array | null;
  /** per corner: the lowest corner that shares its normal, see CornerNormals; empty without normals, and with those of `quickArrays` */
  groups: Uint32Array;
  /** lowest and highest coordinates; infinite for a mesh without vertices */
  low: [number, number, number];
  high: [number, number, number];
  /** whether `drawnArrays` computes better normals */
  isQuick: boolean;
}

/** Spreads `values[size v + c]` of vertices to their corners, `[size corner + c]`. */
export function perCorner({ triangles }: TriangleMesh, values: Float32Array, size: 1 | 3): Float32Array {
  const out = new Float32Array(triangles.length * size);
  if (size === 1) {
    for (let corner = 0; corner < triangles.length; corner++) out[corner] = values[triangles[corner]];
    return out;
  }
  for (let corner = 0, to = 0; corner < triangles.length; corner++) {
    const from = 3 * triangles[corner];
    out[to++] = values[from];
    out[to++] = values[from + 1];
    out[to++] = values[from + 2];
  }
  return out;
}

export function drawnArrays(mesh: TriangleMesh): DrawnArrays {
  const positions = perCorner(mesh, mesh.positions, 3);
  const box = boundsOf(mesh);
  if (isLarge(mesh)) return { positions, normals: null, groups: new Uint32Array(), ...box, isQuick: false };
  const { group, normals } = cornerNormals(mesh);
  const spread = new Float32Array(3 * group.length);
  for (let corner = 0; corner < group.length; corner++)
    for (let c = 0; c < 3; c++) spread[3 * corner + c] = normals[3 * group[corner] + c];
  return { positions, normals: spread, groups: group, ...box, isQuick: false };
}

/** The same in a tenth of the time, with normals that suffice while the slider moves. */
export function quickArrays(mesh: TriangleMesh): DrawnArrays {
  if (isLarge(mesh)) return drawnArrays(mesh);
  const positions = perCorner(mesh, mesh.positions, 3);
  const normals = quickNormals(mesh);
  return { positions, normals, groups: new Uint32Array(), ...boundsOf(mesh), isQuick: true };
}

/** Bounds of the vertices that triangles use. */
function boundsOf({ positions, triangles }: TriangleMesh): Pick<DrawnArrays, 'low' | 'high'> {
  const low: [number, number, number] = [Infinity, Infinity, Infinity];
  const high: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  const isUsed = new Uint8Array(positions.length / 3);
  for (let corner = 0; corner < triangles.length; corner++) isUsed[triangles[corner]] = 1;
  for (let v = 0; v < isUsed.length; v++) {
    if (isUsed[v] === 0) continue;
    for (let c = 0; c < 3; c++) {
      const value = positions[3 * v + c];
      if (value < low[c]) low[c] = value;
      if (value > high[c]) high[c] = value;
    }
  }
  return { low, high };
}
