/** What formats without a scene cannot hold of a document, in plain words. */

import type { Document, Material, Primitive } from '@gltf-transform/core';
import { counted } from '../../core/words';
import type { WrittenFormat } from '../../core/output_words';
import { shownNodes } from './flat_meshes';

/** What a file of this format leaves out of the document; empty for GLB and glTF. */
export function lostIn(format: WrittenFormat, document: Document): string[] {
  if (format === 'glb' || format === 'gltf') return [];
  const root = document.getRoot();
  const primitives = root.listMeshes().flatMap((mesh) => mesh.listPrimitives());
  const targets = Math.max(0, ...primitives.map((primitive) => primitive.listTargets().length));
  const materials = root.listMaterials();
  const count = (length: number, one: string) => (length > 0 ? [counted(length, one)] : []);
  const shown = new Set(shownNodes(document).map((node) => node.getMesh()));
  const hidden = root.listMeshes().filter((mesh) => !shown.has(mesh)).length;
  return [
    ...(hidden > 0 ? [counted(hidden, 'mesh outside of the scene', 'meshes outside of the scene')] : []),
    ...count(root.listSkins().length, 'skin'),
    ...count(targets, 'morph target'),
    ...count(root.listAnimations().length, 'animation'),
    ...count(root.listCameras().length, 'camera'),
    ...lostAttributes(format, primitives),
    ...(format === 'ply' ? count(materials.length, 'material') : [...new Set(materials.flatMap(unsaid))]),
    ...root.listExtensionsUsed().map(({ extensionName }) => `extension ${extensionName}`),
  ];
}

/** OBJ and PLY have one set of UVs and of colours; colours, and in PLY UVs, only where all primitives that share a list have them. */
function lostAttributes(format: WrittenFormat, primitives: Primitive[]): string[] {
  const names = new Set(primitives.flatMap((primitive) => primitive.listSemantics()));
  const further = (kind: string) =>
    [...names].filter((name) => name.startsWith(kind) && !name.endsWith('_0'));
  const isPartial = (name: string) =>
    names.has(name) && !primitives.every((primitive) => primitive.getAttribute(name) !== null);
  const one = (isLost: boolean, words: string) => (isLost ? [words] : []);
  return [
    ...one(format === 'ply' && isPartial('TEXCOORD_0'), 'UVs, which not all of its meshes have'),
    ...one(format === 'ply' && isPartial('COLOR_0'), 'vertex colours, which not all of its meshes have'),
    ...one(further('TEXCOORD_').length > 0, 'further sets of UVs'),
    ...one(further('COLOR_').length > 0, 'further sets of vertex colours'),
    ...[...names].filter((name) => name.startsWith('_')).map((name) => `attribute ${name}`),
  ];
}

/** Textures that MTL has no word for. */
const unsaid = (material: Material): string[] => [
  ...(material.getMetallicRoughnessTexture() ? ['metallic-roughness textures'] : []),
  ...(material.getOcclusionTexture() ? ['occlusion textures'] : []),
];
