/** A mesh as the viewport draws it: triangles share no corners, so that each can have its own colour and sharp edges. */

import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from 'three';
import type { TriangleMesh } from '../../engine/core/core';
import { LOCKED, STRONGEST } from '../../engine/settings/paint_text';
import type { Levels } from '../../engine/settings/paint_text';
import { cornerNormals } from '../../engine/document/shading/normals';
import { isLarge } from './twin_surface';

/** A scalar to colour by, in [0, 1]. */
export interface Field {
  on: 'vertices' | 'triangles';
  values: Float32Array;
}

/** Spreads `values[size v + c]` of vertices to their corners, `[size corner + c]`. */
function perCorner({ triangles }: TriangleMesh, values: Float32Array, size: number): Float32Array {
  const out = new Float32Array(triangles.length * size);
  for (let corner = 0; corner < triangles.length; corner++)
    for (let c = 0; c < size; c++) out[size * corner + c] = values[size * triangles[corner] + c];
  return out;
}

/** `groups`: the corners that share a normal, see CornerNormals. A large mesh has neither groups nor normals. */
export function bodyGeometry(mesh: TriangleMesh): { geometry: BufferGeometry; groups: Uint32Array } {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(perCorner(mesh, mesh.positions, 3), 3));
  const groups = isLarge(mesh) ? new Uint32Array() : setNormals(geometry, mesh);
  setDisplacement(geometry, mesh, null);
  setField(geometry, mesh, null);
  geometry.computeBoundingSphere();
  geometry.computeBoundingBox();
  return { geometry, groups };
}

/** Returns the groups of corners that share a normal. */
function setNormals(geometry: BufferGeometry, mesh: TriangleMesh): Uint32Array {
  const { group, normals } = cornerNormals(mesh);
  const spread = new Float32Array(3 * group.length);
  group.forEach((corner, i) => {
    for (let c = 0; c < 3; c++) spread[3 * i + c] = normals[3 * corner + c];
  });
  geometry.setAttribute('normal', new BufferAttribute(spread, 3));
  return group;
}

/** `shape[3 v + c]`, in units of the mesh; null removes the displacement. */
export function setDisplacement(
  geometry: BufferGeometry,
  mesh: TriangleMesh,
  shape: Float32Array | null,
): void {
  if (shape) geometry.setAttribute('displacement', new BufferAttribute(perCorner(mesh, shape, 3), 3));
  else geometry.deleteAttribute('displacement');
}

/** Colours by a field; null: values of 0. */
export function setField(geometry: BufferGeometry, mesh: TriangleMesh, field: Field | null): void {
  const values = new Float32Array(mesh.triangles.length);
  if (field?.on === 'vertices') values.set(perCorner(mesh, field.values, 1));
  if (field?.on === 'triangles')
    values.forEach((_, corner) => (values[corner] = field.values[Math.floor(corner / 3)]));
  geometry.setAttribute('value', new BufferAttribute(values, 1));
}

/** Shows what a brush has painted, per vertex; null: nothing. The attribute is (how much is kept, whether it is locked). */
export function setPaint(geometry: BufferGeometry, { triangles }: TriangleMesh, levels: Levels | null): void {
  if (!levels) {
    geometry.deleteAttribute('paint');
    return;
  }
  const attribute =
    geometry.getAttribute('paint') ??
    new BufferAttribute(new Uint8Array(2 * triangles.length), 2, true).setUsage(DynamicDrawUsage);
  const { array } = attribute;
  for (let corner = 0; corner < triangles.length; corner++) {
    const level = levels[triangles[corner]];
    array[2 * corner] = level === LOCKED ? 0 : (255 * level) / STRONGEST;
    array[2 * corner + 1] = level === LOCKED ? 255 : 0;
  }
  attribute.needsUpdate = true;
  geometry.setAttribute('paint', attribute);
}
