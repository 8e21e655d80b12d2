/** The set of UVs that a format with one set gets of each primitive. */

import type { Material, Primitive, TextureInfo } from '@gltf-transform/core';
import { KHRTextureTransform } from '@gltf-transform/extensions';
import type { Transform } from '@gltf-transform/extensions';

const KIND = 'TEXCOORD_';
const FIRST = `${KIND}0`;

/** All sets of UVs of a primitive. */
export const uvSetsOf = (primitive: Primitive): string[] =>
  primitive.listSemantics().filter((name) => name.startsWith(KIND));

/**
 * The set that the material's colour texture uses, else that of its emission, else that of its normals. The first set if the
 * material has none of them, or the primitive lacks the set that it names; so the primitive may lack the returned set.
 */
export function uvSetOf(primitive: Primitive): string {
  const material = primitive.getMaterial();
  const info = material && shownInfo(material);
  const named = info ? `${KIND}${setOf(info)}` : FIRST;
  return primitive.getAttribute(named) ? named : FIRST;
}

const shownInfo = (material: Material): TextureInfo | null =>
  material.getBaseColorTextureInfo() ?? material.getEmissiveTextureInfo() ?? material.getNormalTextureInfo();

/** What a transform of the texture says comes first. */
const setOf = (info: TextureInfo): number =>
  info.getExtension<Transform>(KHRTextureTransform.EXTENSION_NAME)?.getTexCoord() ?? info.getTexCoord();
