/** A body whose vertices move: places, normals and values written into its geometry for each picture. */

import type { BufferAttribute, BufferGeometry } from 'three';
import type { TriangleMesh } from '../../engine/core/core';

/** Above this many triangles faces are drawn flat, as the shader finds their normals by itself. */
const MOST_SMOOTH = 150_000;

/** Whether a mesh is shaded flat: its triangles are smaller than what could be told from smooth ones. */
export const isLarge = (mesh: TriangleMesh | null): boolean =>
  mesh !== null && mesh.triangles.length > 3 * MOST_SMOOTH;

/** `groups`: see CornerNormals; they are those of the mesh at rest, so that creases stay where they are. */
export function placeSurface(
  geometry: BufferGeometry,
  { triangles }: TriangleMesh,
  positions: Float32Array,
  groups: Uint32Array,
): void {
  const place = geometry.getAttribute('position') as BufferAttribute;
  const corners = place.array as Float32Array;
  for (let corner = 0; corner < triangles.length; corner++) {
    const at = 3 * triangles[corner];
    corners[3 * corner] = positions[at];
    corners[3 * corner + 1] = positions[at + 1];
    corners[3 * corner + 2] = positions[at + 2];
  }
  place.needsUpdate = true;
  if (triangles.length <= 3 * MOST_SMOOTH) smooth(geometry, corners, groups);
}

/** Normals weighted by area over the corners of a group. */
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
  // The first corner of a group comes before the others; the shader makes them unit vectors.
  for (let corner = 0; corner < groups.length; corner++) {
    const from = 3 * groups[corner];
    for (let c = 0; c < 3; c++) normals[3 * corner + c] = normals[from + c];
  }
  attribute.needsUpdate = true;
}

/** A value in [0, 1] per vertex, to colour by. */
export function paintSurface(
  geometry: BufferGeometry,
  { triangles }: TriangleMesh,
  values: Float32Array,
): void {
  const attribute = geometry.getAttribute('value') as BufferAttribute;
  const corners = attribute.array as Float32Array;
  for (let corner = 0; corner < triangles.length; corner++) corners[corner] = values[triangles[corner]];
  attribute.needsUpdate = true;
}
