/** Checks the accessors that meshes of a glTF file refer to: with wrong ones they would be read as other meshes. */

import type { GLTF } from '@gltf-transform/core';

/** A clause on the first mesh with missing or invalid positions or indices; null if all are valid. */
export function findWrongMesh({ accessors = [], meshes = [] }: GLTF.IGLTF): string | null {
  for (const [number, { primitives }] of meshes.entries())
    for (const primitive of Array.isArray(primitives) ? primitives : []) {
      const { indices, attributes } = primitive ?? {};
      if (indices !== undefined && !accessors[indices])
        return `mesh ${number} refers to indices that do not exist`;
      const position: unknown = attributes?.POSITION;
      if (position === undefined) continue;
      const accessor = accessors[position as number];
      if (!accessor) return `mesh ${number} refers to positions that do not exist`;
      if (accessor.type !== 'VEC3') return `the positions of mesh ${number} are not of the type VEC3`;
    }
  return null;
}
