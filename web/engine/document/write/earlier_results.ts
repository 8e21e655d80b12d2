/** Removes what an earlier run of Limber wrote about a mesh, which does not apply to its replacement. */

import type { Mesh, Primitive } from '@gltf-transform/core';

/** Names of what `ExportedBody` adds to the extras of a mesh. */
const EXTRAS = ['limberCalibration', 'limberSettings'];
/** Attributes that settings of a solver have. */
const SETTINGS = /^_LIMBER_/;
/** Attributes that are always written together: one alone comes from another program. */
const FIELDS = ['_STRAIN', '_CURVATURE'];

/** Removes the settings and calibration of an earlier run from the extras. */
export function dropEarlierExtras(mesh: Mesh): void {
  const extras = { ...mesh.getExtras() };
  for (const name of EXTRAS) delete extras[name];
  mesh.setExtras(extras);
}

/** Removes the attributes that an earlier run added. */
export function dropEarlierAttributes(primitive: Primitive): void {
  const semantics = primitive.listSemantics();
  const hasFields = FIELDS.every((semantic) => semantics.includes(semantic));
  for (const semantic of semantics)
    if (SETTINGS.test(semantic) || (hasFields && FIELDS.includes(semantic)))
      primitive.setAttribute(semantic, null);
}
