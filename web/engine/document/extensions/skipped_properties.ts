/** Restores properties of glTF files that the reader ignores although the writer supports them. */

import type { Document, GLTF, Property } from '@gltf-transform/core';
import { KHRMaterialsVariants } from '@gltf-transform/extensions';
import type { MappingList } from '@gltf-transform/extensions';

const VARIANTS = KHRMaterialsVariants.EXTENSION_NAME;

/** The properties that every glTF object may have. */
type Named = Pick<GLTF.IChildRootProperty, 'name' | 'extras'>;

/** Gives a document the version that its file needs, extras of variants, and names and extras of their materials. */
export function restoreSkippedProperties(document: Document, json: GLTF.IGLTF): void {
  const root = document.getRoot();
  const { minVersion } = json.asset;
  if (minVersion) root.getAsset().minVersion = minVersion;
  const extension = root.listExtensionsUsed().find(({ extensionName }) => extensionName === VARIANTS);
  if (!(extension instanceof KHRMaterialsVariants)) return;
  addTexts(extension.listVariants(), json.extensions?.[VARIANTS], 'variants');
  root.listMeshes().forEach((mesh, m) =>
    mesh.listPrimitives().forEach((primitive, p) => {
      const list = primitive.getExtension<MappingList>(VARIANTS);
      const own = json.meshes?.[m]?.primitives[p]?.extensions?.[VARIANTS];
      if (list) addTexts(list.listMappings(), own, 'mappings');
    }),
  );
}

/** Gives properties the names and extras in the list of this name. */
function addTexts(properties: Property[], holder: unknown, list: string): void {
  const entries = (holder as Record<string, Named[] | undefined> | undefined)?.[list] ?? [];
  properties.forEach((property, i) => {
    const { name, extras } = entries[i];
    if (name) property.setName(name);
    if (extras) property.setExtras(extras as Record<string, unknown>);
  });
}
