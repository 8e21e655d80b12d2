/** What formats without a scene cannot hold of a document, in plain words. */

import type { Document, Material } from '@gltf-transform/core';
import { counted } from '../../core/words';
import type { WrittenFormat } from '../../core/output_words';

/** What a file of this format leaves out of the document; empty for GLB and glTF. */
export function lostIn(format: WrittenFormat, document: Document): string[] {
  if (format === 'glb' || format === 'gltf') return [];
  const root = document.getRoot();
  const primitives = root.listMeshes().flatMap((mesh) => mesh.listPrimitives());
  const targets = Math.max(0, ...primitives.map((primitive) => primitive.listTargets().length));
  const materials = root.listMaterials();
  const count = (length: number, one: string) => (length > 0 ? [counted(length, one)] : []);
  return [
    ...count(root.listSkins().length, 'skin'),
    ...count(targets, 'morph target'),
    ...count(root.listAnimations().length, 'animation'),
    ...count(root.listCameras().length, 'camera'),
    ...(format === 'ply' ? count(materials.length, 'material') : [...new Set(materials.flatMap(unsaid))]),
    ...root.listExtensionsUsed().map(({ extensionName }) => `extension ${extensionName}`),
  ];
}

/** Textures that MTL has no word for. */
const unsaid = (material: Material): string[] => [
  ...(material.getMetallicRoughnessTexture() ? ['metallic-roughness textures'] : []),
  ...(material.getOcclusionTexture() ? ['occlusion textures'] : []),
];
