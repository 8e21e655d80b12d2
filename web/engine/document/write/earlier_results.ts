/** What an earlier run has written about a mesh, which says nothing of the mesh that takes its place. */

import type { Mesh, Primitive } from '@gltf-transform/core';

/** Names of what `ExportedBody` adds to the extras of a mesh. */
const EXTRAS = ['limberCalibration', 'limberSettings'];
/** Attributes that settings of a solver have. */
const SETTINGS = /^_LIMBER_/;
/** Attributes that are always written together: one alone is somebody else's. */
const FIELDS = ['_STRAIN', '_CURVATURE'];

/** Takes the settings and calibration of an earlier run out of the extras. */
export function dropEarlierExtras(mesh: Mesh): void {
  const extras = { ...mesh.getExtras() };
  for (const name of EXTRAS) delete extras[name];
  mesh.setExtras(extras);
}

/** Takes the attributes away that an earlier run has added. */
export function dropEarlierAttributes(primitive: Primitive): void {
  const semantics = primitive.listSemantics();
  const hasFields = FIELDS.every((semantic) => semantics.includes(semantic));
  for (const semantic of semantics)
    if (SETTINGS.test(semantic) || (hasFields && FIELDS.includes(semantic)))
      primitive.setAttribute(semantic, null);
}
