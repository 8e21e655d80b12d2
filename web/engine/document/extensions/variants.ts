/** Variants of materials: the names that viewers offer, whether or not a primitive has a material for them. */

import { Document } from '@gltf-transform/core';
import type { Extension, ExtensionProperty } from '@gltf-transform/core';

const VARIANTS = 'KHR_materials_variants';

/** By name: the library gets documents of other copies of glTF-Transform. */
export const isVariant = ({ propertyType }: ExtensionProperty): boolean => propertyType === 'Variant';

/** A copy of a document, with all its variants in their order: a copy otherwise has those that primitives name, in that order. */
export async function copyDocument(source: Document): Promise<Document> {
  const { createDefaultPropertyResolver, mergeDocuments } = await import('@gltf-transform/functions');
  const target = new Document().setLogger(source.getLogger());
  const resolve = createDefaultPropertyResolver(target, source);
  for (const extension of source.getRoot().listExtensionsUsed()) {
    if (extension.extensionName !== VARIANTS) continue;
    target.createExtension(extension.constructor as new (document: Document) => Extension);
    for (const variant of extension.listProperties().filter(isVariant))
      resolve(variant).copy(variant, resolve);
  }
  mergeDocuments(target, source, resolve);
  target.getRoot().copy(source.getRoot(), resolve as never);
  return target;
}
