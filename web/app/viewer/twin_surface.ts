/** A body whose vertices move: writes positions, normals and values into its geometry for each frame. */

import { BufferAttribute } from 'three';
import type { BufferGeometry } from 'three';
import type { TriangleMesh } from '../../engine/core/core';

/** Bodies with more triangles than this are shaded flat; the shader finds their normals by itself. */
const MAX_SMOOTH = 150_000;

/** Whether a mesh is flat-shaded: its triangles are so small that smooth shading would look the same. */
export const isLarge = (mesh: TriangleMesh | null): boolean =>
  mesh !== null && mesh.triangles.length > 3 * MAX_SMOOTH;

/** `groups`: those of the mesh at rest, see CornerNormals, so that creases do not change. */
export function writePositions(
  geometry: BufferGeometry,
  { triangles }: TriangleMesh,
  positions: Float32Array,
  groups: Uint32Array,
): void {
  const attribute = geometry.getAttribute('position') as BufferAttribute;
  const corners = attribute.array as Float32Array;
  for (let corner = 0; corner < triangles.length; corner++) {
    const at = 3 * triangles[corner];
    corners[3 * corner] = positions[at];
    corners[3 * corner + 1] = positions[at + 1];
    corners[3 * corner + 2] = positions[at + 2];
  }
  attribute.needsUpdate = true;
  if (triangles.length <= 3 * MAX_SMOOTH) smooth(geometry, corners, groups);
}

/** Sets the normal of each group of corners to the sum of its triangles' normals, weighted by area. */
function smooth(geometry: BufferGeometry, corners: Float32Array, groups: Uint32Array): void {
  const attribute = geometry.getAttribute('normal') as BufferAttribute;
  const normals = attribute.array as Float32Array;
  normals.fill(0);
  for (let at = 0; at < corners.length; at += 9) {
    const [ux, uy, uz] = [
      corners[at + 3] - corners[at],
      corners[at + 4] - corners[at + 1],
      corners[at + 5] - corners[at + 2],
    ];
    const [vx, vy, vz] = [
      corners[at + 6] - corners[at],
      corners[at + 7] - corners[at + 1],
      corners[at + 8] - corners[at + 2],
    ];
    const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    for (let k = 0; k < 3; k++) {
      const to = 3 * groups[at / 3 + k];
      normals[to] += nx;
      normals[to + 1] += ny;
      normals[to + 2] += nz;
    }
  }
  // The first corner of a group precedes the others. The shader normalises the sums.
  for (let corner = 0; corner < groups.length; corner++) {
    const from = 3 * groups[corner];
    for (let c = 0; c < 3; c++) normals[3 * corner + c] = normals[from + c];
  }
  attribute.needsUpdate = true;
}

/** Colours by `values[v]` in [0, 1]. */
export function writeValues(
  geometry: BufferGeometry,
  { triangles }: TriangleMesh,
  values: Float32Array,
): void {
  const attribute = (geometry.getAttribute('value') ??
    new BufferAttribute(new Float32Array(triangles.length), 1)) as BufferAttribute;
  const corners = attribute.array as Float32Array;
  for (let corner = 0; corner < triangles.length; corner++) corners[corner] = values[triangles[corner]];
  attribute.needsUpdate = true;
  geometry.setAttribute('value', attribute);
}
