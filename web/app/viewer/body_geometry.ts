/** A mesh as the viewport draws it: triangles share no corners, so that each can have its own colour and sharp edges. */

import { Box3, BufferAttribute, BufferGeometry, DynamicDrawUsage, Sphere, Vector3 } from 'three';
import type { TriangleMesh } from '../../engine/core/core';
import { LOCKED, STRONGEST } from '../../engine/settings/paint_text';
import type { Levels } from '../../engine/settings/paint_text';
import { perCorner } from './drawn_arrays';
import type { DrawnArrays } from './drawn_arrays';

/** A scalar to colour by, in [0, 1]. */
export interface Field {
  on: 'vertices' | 'triangles';
  values: Float32Array;
}

/** The geometry of a mesh whose arrays have been prepared. */
export function geometryFrom(
  { positions, normals, low, high }: DrawnArrays,
  mesh: TriangleMesh,
): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  if (normals) geometry.setAttribute('normal', new BufferAttribute(normals, 3));
  setDisplacement(geometry, mesh, null);
  geometry.boundingBox = new Box3(new Vector3(...low), new Vector3(...high));
  geometry.boundingSphere = geometry.boundingBox.getBoundingSphere(new Sphere());
  return geometry;
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

/** Colours by a field; null removes the colours. */
export function setField(geometry: BufferGeometry, mesh: TriangleMesh, field: Field | null): void {
  if (!field) return void geometry.deleteAttribute('value');
  const values = new Float32Array(mesh.triangles.length);
  if (field.on === 'vertices') values.set(perCorner(mesh, field.values, 1));
  if (field.on === 'triangles')
    for (let t = 0; t < field.values.length; t++)
      values[3 * t] = values[3 * t + 1] = values[3 * t + 2] = field.values[t];
  geometry.setAttribute('value', new BufferAttribute(values, 1));
}

/** Shows the paint of a brush, per vertex; null: none. The attribute is (keep level, whether it is locked). */
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
