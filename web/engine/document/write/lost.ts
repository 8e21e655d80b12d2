/** What OBJ and PLY cannot hold of a document, in words for the user. */

import type { Material, Node, Primitive, Root, Scene } from '@gltf-transform/core';
import {
  EXTTextureAVIF,
  EXTTextureWebP,
  KHRMeshQuantization,
  KHRTextureBasisu,
  KHRTextureTransform,
} from '@gltf-transform/extensions';
import { counted, excerpt } from '../../core/words';
import type { WrittenFormat } from '../../core/output_choices';
import type { OpenModel } from '../model';
import { DRACO, MESHOPT } from '../gltf_io';
import { INSTANCING } from '../placements';
import { shownNodes } from './flat_meshes';
import { uvSetOf, uvSetsOf } from './uv_set';

/** glTF's primitive mode. */
const TRIANGLES = 4;

/** Extensions that only change how data are stored: nothing is lost with them. */
const STORAGE_EXTENSIONS: readonly string[] = [
  DRACO,
  MESHOPT,
  ...[EXTTextureAVIF, EXTTextureWebP, KHRMeshQuantization, KHRTextureBasisu].map(
    ({ EXTENSION_NAME }) => EXTENSION_NAME,
  ),
];

/** What a file of this format leaves out of a model; empty for GLB and glTF. An OBJ of an OBJ has the same material libraries. */
export function lostIn(
  format: WrittenFormat,
  { document, libraries = [], outside = [] }: Pick<OpenModel, 'document' | 'libraries' | 'outside'>,
): string[] {
  if (format === 'glb' || format === 'gltf') return [];
  const root = document.getRoot();
  const all = root.listMeshes().flatMap((mesh) => mesh.listPrimitives());
  const primitives = all.filter(hasTriangles);
  const targets = Math.max(0, ...primitives.map((primitive) => primitive.listTargets().length));
  const keepsMaterials = format === 'obj' && libraries.length > 0;
  const materials = keepsMaterials ? [] : root.listMaterials();
  const carried = [
    ...STORAGE_EXTENSIONS,
    INSTANCING,
    ...(keepsMaterials ? [KHRTextureTransform.EXTENSION_NAME] : []),
  ];
  const count = (length: number, one: string, many?: string) =>
    length > 0 ? [counted(length, one, many)] : [];
  const nodes = new Set(shownNodes(document));
  const shown = new Set([...nodes].map((node) => node.getMesh()));
  const furtherScenes = root.listScenes().filter((scene) => showsOthers(scene, nodes)).length;
  const hidden = root.listMeshes().filter((mesh) => !shown.has(mesh)).length;
  return [
    ...count(furtherScenes, 'further scene'),
    ...count(hidden, 'mesh outside of the scene', 'meshes outside of the scene'),
    ...count(all.length - primitives.length, 'primitive of points or lines', 'primitives of points or lines'),
    ...count(root.listSkins().length, 'skin'),
    ...count(targets, 'morph target'),
    ...count(root.listAnimations().length, 'animation'),
    ...count(root.listCameras().length, 'camera'),
    ...lostAttributes(format, root),
    ...(format === 'ply'
      ? lostMaterials(materials.length, root.listTextures().length)
      : [...new Set(materials.flatMap(unsupportedTextures))]),
    ...(keepsMaterials ? outside.map((name) => `${excerpt(name)} (not in the folder of the input)`) : []),
    ...root
      .listExtensionsUsed()
      .filter(({ extensionName }) => !carried.includes(extensionName))
      .map(({ extensionName }) => `extension ${extensionName}`),
  ];
}

/** What is lost as a list for a sentence, in which the words before the names of extensions and of attributes stand once. */
export function listLost(lost: readonly string[]): string {
  const named = (kind: string) => lost.filter((one) => one.startsWith(`${kind} `));
  const once = (kind: string) => {
    const names = named(kind).map((one) => one.slice(kind.length + 1));
    return names.length > 1 ? [`${kind}s ${names.join(', ')}`] : named(kind);
  };
  const kinds = ['attribute', 'extension'];
  const others = lost.filter((one) => !kinds.some((kind) => one.startsWith(`${kind} `)));
  return [...others, ...kinds.flatMap(once)].join(', ');
}

/** "1 material with 1 texture": PLY has neither. */
function lostMaterials(materials: number, textures: number): string[] {
  if (materials === 0) return [];
  const words = counted(materials, 'material');
  return [textures === 0 ? words : `${words} with ${counted(textures, 'texture')}`];
}

/** Whether the scene has a mesh at a node that is not among these. */
function showsOthers(scene: Scene, nodes: ReadonlySet<Node>): boolean {
  let shows = false;
  scene.traverse((node) => (shows ||= node.getMesh() !== null && !nodes.has(node)));
  return shows;
}

/** Attributes that are lost: OBJ and PLY have one set of UVs and of colours, and all primitives in a list of vertices must have the same attributes. */
function lostAttributes(format: WrittenFormat, root: Root): string[] {
  const ofMeshes = root.listMeshes().map((mesh) => mesh.listPrimitives().filter(hasTriangles));
  const primitives = ofMeshes.flat();
  const names = new Set(primitives.flatMap((primitive) => primitive.listSemantics()));
  const hasFurtherColours = [...names].some((name) => name.startsWith('COLOR_') && !name.endsWith('_0'));
  const lists = format === 'ply' ? [primitives] : ofMeshes;
  const isPartial = (nameOf: NameOf) => lists.some((list) => isOfSome(list, nameOf));
  const one = (isLost: boolean, words: string) => (isLost ? [words] : []);
  return [
    ...one(format === 'ply' && isPartial(() => 'NORMAL'), 'normals, which not all of its meshes have'),
    ...one(format === 'ply' && isPartial(uvSetOf), 'UVs, which not all of its meshes have'),
    ...one(
      isPartial(() => 'COLOR_0'),
      `vertex colours, which not all ${format === 'ply' ? 'of its meshes' : 'parts of a mesh'} have`,
    ),
    ...one(format === 'obj' && primitives.some(hasOpacity), 'opacity of vertex colours'),
    ...one(names.has('TANGENT'), 'tangents'),
    ...lostUvs(primitives),
    ...one(hasFurtherColours, 'further sets of vertex colours'),
    ...[...names].filter((name) => name.startsWith('_')).map((name) => `attribute ${name}`),
  ];
}

const hasTriangles = (primitive: Primitive): boolean => (primitive.getMode() as number) >= TRIANGLES;

/** The sets of UVs besides the written one of each primitive. */
function lostUvs(primitives: Primitive[]): string[] {
  const lost = primitives.flatMap((primitive) => {
    const written = uvSetOf(primitive);
    return uvSetsOf(primitive).filter((name) => name !== written);
  });
  return lost.length > 0 ? [`further sets of UVs (${[...new Set(lost)].sort().join(', ')})`] : [];
}

/** The name of an attribute of a primitive. */
type NameOf = (primitive: Primitive) => string;

/** Whether some but not all primitives have the attribute. */
function isOfSome(primitives: Primitive[], nameOf: NameOf): boolean {
  const having = primitives.filter((primitive) => primitive.getAttribute(nameOf(primitive)) !== null).length;
  return having > 0 && having < primitives.length;
}

/** Whether a vertex is not opaque. */
function hasOpacity(primitive: Primitive): boolean {
  const colours = primitive.getAttribute('COLOR_0');
  if (!colours || colours.getElementSize() < 4) return false;
  const element: number[] = [];
  for (let v = 0; v < colours.getCount(); ++v) if (colours.getElement(v, element)[3] < 1) return true;
  return false;
}

/** Textures that MTL cannot express. */
const unsupportedTextures = (material: Material): string[] => [
  ...(material.getMetallicRoughnessTexture() ? ['metallic-roughness textures'] : []),
  ...(material.getOcclusionTexture() ? ['occlusion textures'] : []),
];
