/** Removes from a document what does not apply to new vertices, and what is no longer used. */

import type {
  Accessor,
  Animation,
  Document,
  Extension,
  ExtensionProperty,
  Mesh,
  Node,
  Primitive,
  Property,
  Root,
  Texture,
} from '@gltf-transform/core';
import type { Features } from '@gltf-transform/extensions';
import { isVariant } from './extensions/variants';

const FEATURES = 'EXT_mesh_features';

/** Primitive extensions that refer to materials, or to attributes by name, and so stay valid. */
const CARRIED = new Set(['KHR_materials_variants', 'EXT_structural_metadata']);
const QUANTIZATION = 'KHR_mesh_quantization';
const DRACO = 'KHR_draco_mesh_compression';
const COMPRESSIONS = [DRACO, 'EXT_meshopt_compression'];

/** Extensions without properties of their own, each with a test of whether the document still needs it. */
const NEEDED_BY: Record<string, (document: Document, kept: Primitive[]) => boolean> = {
  [QUANTIZATION]: hasQuantized,
  KHR_mesh_primitive_restart: (_, kept) => kept.length > 0,
  KHR_accessor_float16: (document) => hasComponentType(document, 5131),
  KHR_accessor_float64: (document) => hasComponentType(document, 5130),
  EXT_texture_webp: (document) => hasTexture(document, 'image/webp'),
  EXT_texture_avif: (document) => hasTexture(document, 'image/avif'),
  KHR_texture_basisu: (document) => hasTexture(document, 'image/ktx2'),
};

/** Removes the mesh's morph targets, their weights and the animations of these. */
export function dropMorphing(document: Document, mesh: Mesh): void {
  for (const primitive of mesh.listPrimitives())
    for (const target of primitive.listTargets()) {
      primitive.removeTarget(target);
      if (target.listParents().length === 0) target.dispose();
    }
  mesh.setWeights([]);
  const nodes = document
    .getRoot()
    .listNodes()
    .filter((node) => node.getMesh() === mesh);
  for (const node of nodes) node.setWeights([]);
  for (const animation of document.getRoot().listAnimations()) dropWeightChannels(animation, nodes);
}

function dropWeightChannels(animation: Animation, nodes: Node[]): void {
  for (const channel of animation.listChannels()) {
    const isOfNodes = nodes.includes(channel.getTargetNode()!);
    if (!isOfNodes || channel.getTargetPath() !== 'weights') continue;
    const sampler = channel.getSampler();
    channel.dispose();
    if (!animation.listChannels().some((other) => other.getSampler() === sampler)) sampler?.dispose();
  }
  if (animation.listChannels().length === 0) animation.dispose();
}

/** Whether an extension of a primitive stays valid for new vertices. */
function isCarried(extension: ExtensionProperty): boolean {
  // By name: the library gets documents of other copies of glTF-Transform.
  if (extension.extensionName === FEATURES)
    // Features without an attribute or texture are numbered by vertices, which change.
    return (extension as Features)
      .listFeatureIDs()
      .every((ids) => ids.getAttribute() !== null || ids.getTexture() !== null);
  return CARRIED.has(extension.extensionName);
}

/** Names of the primitive's extensions that are valid only for its old vertices. */
export function uncarriedExtensions(primitive: Primitive): string[] {
  return primitive
    .listExtensions()
    .filter((extension) => !isCarried(extension))
    .map((extension) => extension.extensionName);
}

export function dropUncarried(primitive: Primitive): void {
  for (const name of uncarriedExtensions(primitive)) primitive.setExtension(name, null);
}

/** Normalises joint weights: those decoded from Draco do not add up to 1, which the validator would report in the uncompressed file. */
export function normaliseWeights(document: Document): void {
  const root = document.getRoot();
  if (!root.listExtensionsUsed().some(({ extensionName }) => extensionName === DRACO)) return;
  const done = new Set<Accessor>();
  for (const primitive of primitivesOf(document)) {
    const sets = primitive.listSemantics().filter((semantic) => semantic.startsWith('WEIGHTS_'));
    const accessors = sets.map((semantic) => primitive.getAttribute(semantic)!);
    if (accessors.some((accessor) => done.has(accessor))) continue;
    for (const accessor of accessors) done.add(accessor);
    const arrays = accessors.map((accessor) => accessor.getArray());
    if (arrays.length > 0 && arrays.every((array) => array instanceof Float32Array)) makeSumsOne(arrays);
  }
}

/** Scales the weights of each vertex, four per array, to sum 1 unless all are 0. */
function makeSumsOne(arrays: Float32Array[]): void {
  for (let first = 0; first < arrays[0].length; first += 4) {
    let sum = 0;
    for (const array of arrays) for (let i = 0; i < 4; ++i) sum += array[first + i];
    if (sum > 0) for (const array of arrays) for (let i = 0; i < 4; ++i) array[first + i] /= sum;
  }
}

/** Which unused properties are kept. */
export interface Kept {
  /** whether properties that may be referred to by index are kept */
  keepsNumbers?: boolean;
  spared?: ReadonlySet<Property>;
}

const NONE_SPARED: ReadonlySet<Property> = new Set();

/** Whether nothing but the root, which lists it, refers to a property. */
export const isUnused = (property: Property, root: Root): boolean =>
  property.listParents().every((parent) => parent === root);

/** What `disposeUnused` would dispose of before any change: the owner of the document may still need it. */
export function listUnused(document: Document): Set<Property> {
  const root = document.getRoot();
  const own = [...root.listSkins(), ...root.listTextures(), ...root.listAccessors()];
  const ofExtensions = root.listExtensionsUsed().flatMap((extension) => extension.listProperties());
  return new Set([...own, ...ofExtensions].filter((property) => isUnused(property, root)));
}

/**
 * Disposes of data, textures, skins and extensions that nothing refers to; nodes, materials and cameras stay. With `keepsNumbers`, so do
 * skins, textures and what extensions list, which others may refer to by number; so does what is `spared`.
 */
export function disposeUnused(
  document: Document,
  replaced: Set<Primitive>,
  { keepsNumbers = false, spared = NONE_SPARED }: Kept,
): void {
  const root = document.getRoot();
  const isGone = (property: Property) => isUnused(property, root) && !spared.has(property);
  if (!keepsNumbers) {
    for (const extension of root.listExtensionsUsed()) disposeOrphans(extension, spared);
    for (const skin of root.listSkins()) if (isGone(skin)) skin.dispose();
    for (const texture of root.listTextures()) if (isGone(texture)) texture.dispose();
  }
  for (const accessor of root.listAccessors()) if (isGone(accessor)) accessor.dispose();
  const kept = primitivesOf(document).filter((primitive) => !replaced.has(primitive));
  for (const extension of root.listExtensionsUsed())
    if (!isNeeded(document, extension, kept)) extension.dispose();
}

const primitivesOf = (document: Document): Primitive[] =>
  document
    .getRoot()
    .listMeshes()
    .flatMap((mesh) => mesh.listPrimitives());

/**
 * Disposes of the extension's properties that have no parent, until none is left. Variants stay: one that no primitive names shows the
 * materials that are there without any.
 */
export function disposeOrphans(extension: Extension, spared = NONE_SPARED): void {
  const orphans = extension
    .listProperties()
    .filter(
      (property) => property.listParents().length === 0 && !isVariant(property) && !spared.has(property),
    );
  for (const orphan of orphans) orphan.dispose();
  if (orphans.length > 0) disposeOrphans(extension, spared);
}

function isNeeded(document: Document, extension: Extension, kept: Primitive[]): boolean {
  const name = extension.extensionName;
  // Whether the result is compressed is decided when it is written.
  if (COMPRESSIONS.includes(name)) return false;
  return Object.hasOwn(NEEDED_BY, name)
    ? NEEDED_BY[name](document, kept)
    : extension.listProperties().length > 0;
}

/** Whether a mesh has integers that glTF allows only with KHR_mesh_quantization. */
export function hasQuantized(document: Document): boolean {
  return primitivesOf(document).some(isQuantized);
}

/** Whether positions, normals, tangents or UVs are integers, which core glTF allows for normalized UVs only. */
function isQuantized(primitive: Primitive): boolean {
  const holders = [primitive, ...primitive.listTargets()];
  return holders.some((holder) =>
    holder.listSemantics().some((semantic) => {
      const accessor = holder.getAttribute(semantic)!;
      const isGeometry = /^(POSITION|NORMAL|TANGENT|TEXCOORD_)/.test(semantic);
      return isGeometry && !(accessor.getArray() instanceof Float32Array);
    }),
  );
}

const hasComponentType = (document: Document, type: number): boolean =>
  document
    .getRoot()
    .listAccessors()
    .some((accessor) => (accessor.getComponentType() as number) === type);

const hasTexture = (document: Document, mimeType: string): boolean =>
  document
    .getRoot()
    .listTextures()
    .some((texture: Texture) => texture.getMimeType() === mimeType);
