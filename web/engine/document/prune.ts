/** Takes out of a document what new geometry cannot carry, and what nothing uses any more. */

import { ExtensionProperty, PropertyType } from '@gltf-transform/core';
import type {
  Accessor,
  Document,
  Extension,
  Material,
  Node,
  Primitive,
  Property,
  Texture,
  TextureInfo,
} from '@gltf-transform/core';

const VARIANTS = 'KHR_materials_variants';
const QUANTIZATION = 'KHR_mesh_quantization';
const DRACO = 'KHR_draco_mesh_compression';
const COMPRESSIONS = [DRACO, 'EXT_meshopt_compression'];

/** Extensions without properties of their own, and what in the document still needs them. */
const NEEDED_BY: Record<string, (document: Document, kept: Primitive[]) => boolean> = {
  [QUANTIZATION]: (_, kept) => kept.some(isQuantized),
  KHR_mesh_primitive_restart: (_, kept) => kept.length > 0,
  KHR_accessor_float16: (document) => hasComponentType(document, 5131),
  KHR_accessor_float64: (document) => hasComponentType(document, 5130),
  EXT_texture_webp: (document) => hasTexture(document, 'image/webp'),
  EXT_texture_avif: (document) => hasTexture(document, 'image/avif'),
  KHR_texture_basisu: (document) => hasTexture(document, 'image/ktx2'),
};

/** Removes every animation, and the skin and morph weights of the nodes that show a replaced primitive. */
export function dropMotion(document: Document, replaced: Set<Primitive>): void {
  const root = document.getRoot();
  for (const animation of root.listAnimations()) {
    for (const part of [...animation.listChannels(), ...animation.listSamplers()]) part.dispose();
    animation.dispose();
  }
  for (const node of root.listNodes())
    if (
      node
        .getMesh()
        ?.listPrimitives()
        .some((primitive) => replaced.has(primitive))
    )
      restNode(node);
}

function restNode(node: Node): void {
  node.setSkin(null);
  node.setWeights([]);
}

/** Only the choice of materials can stay: everything else speaks of the old vertices or their UV coordinates. */
export function dropPrimitiveExtensions(primitive: Primitive): void {
  for (const extension of primitive.listExtensions())
    if (extension.extensionName !== VARIANTS) primitive.setExtension(extension.extensionName, null);
}

/**
 * Takes the textures from the materials of `replaced`, whose primitives have no UV coordinates. A material that another
 * primitive uses as well stays whole there, and `replaced` get a copy.
 */
export function stripMaterials(document: Document, replaced: Set<Primitive>): void {
  for (const material of document.getRoot().listMaterials()) {
    const users = primitivesUsing(material);
    const affected = users.filter((primitive) => replaced.has(primitive));
    if (affected.length === 0) continue;
    let stripped = material;
    if (affected.length < users.length && hasTextures(material)) {
      stripped = material.clone();
      copyExtensions(material, stripped);
      for (const primitive of affected) primitive.swap(material, stripped);
    }
    if (affected.length === users.length || stripped !== material) stripTextures(stripped);
  }
}

/** Primitives that show the material, also through a variant. */
function primitivesUsing(material: Material): Primitive[] {
  const found = new Set<Primitive>();
  const visit = (property: Property, depth: number): void => {
    for (const parent of property.listParents())
      if (parent.propertyType === PropertyType.PRIMITIVE) found.add(parent as Primitive);
      else if (parent instanceof ExtensionProperty && depth < 3) visit(parent, depth + 1);
  };
  visit(material, 0);
  return [...found];
}

/** A clone shares its extensions' properties with the original: they are copied so that stripping spares that. */
function copyExtensions(from: Material, to: Material): void {
  for (const extension of from.listExtensions()) to.setExtension(extension.extensionName, extension.clone());
}

type Holder = Material | ExtensionProperty;
type Method = (argument?: null) => unknown;

/** The names of methods of a material or of a material extension, for every kind of texture. */
function methodsOf(holder: Holder, pattern: RegExp): string[] {
  const names = new Set<string>();
  for (let level: object | null = holder; level; level = Object.getPrototypeOf(level) as object | null)
    for (const name of Object.getOwnPropertyNames(level)) if (pattern.test(name)) names.add(name);
  return [...names];
}

function call(holder: Holder, name: string, ...values: null[]): unknown {
  return (holder as unknown as Record<string, Method>)[name](...values);
}

function holdersOf(material: Material): Holder[] {
  return [material, ...material.listExtensions()];
}

function hasTextures(material: Material): boolean {
  return holdersOf(material).some((holder) =>
    methodsOf(holder, /^get\w*Texture$/).some((name) => call(holder, name) !== null),
  );
}

/** The info of a texture can be had only while the texture is there. */
function stripTextures(material: Material): void {
  for (const holder of holdersOf(material)) {
    for (const name of methodsOf(holder, /^get\w*TextureInfo$/)) {
      const info = call(holder, name) as TextureInfo | null;
      for (const extension of info?.listExtensions() ?? []) info!.setExtension(extension.extensionName, null);
    }
    for (const name of methodsOf(holder, /^set\w*Texture$/)) call(holder, name, null);
  }
}

/**
 * Draco decodes joint weights that do not add up to 1, which only stays unseen while they are compressed: they are
 * normalised in the primitives that are kept.
 */
export function normaliseWeights(document: Document, replaced: Set<Primitive>): void {
  const root = document.getRoot();
  if (!root.listExtensionsUsed().some(({ extensionName }) => extensionName === DRACO)) return;
  const done = new Set<Accessor>();
  for (const primitive of root.listMeshes().flatMap((mesh) => mesh.listPrimitives())) {
    const sets = primitive.listSemantics().filter((semantic) => semantic.startsWith('WEIGHTS_'));
    const accessors = sets.map((semantic) => primitive.getAttribute(semantic)!);
    if (replaced.has(primitive) || accessors.some((accessor) => done.has(accessor))) continue;
    for (const accessor of accessors) done.add(accessor);
    const arrays = accessors.map((accessor) => accessor.getArray());
    if (arrays.length > 0 && arrays.every((array) => array instanceof Float32Array)) makeSumsOne(arrays);
  }
}

/** Four weights of a vertex per array; all of them add up to 1 afterwards, where they are not all 0. */
function makeSumsOne(arrays: Float32Array[]): void {
  for (let first = 0; first < arrays[0].length; first += 4) {
    let sum = 0;
    for (const array of arrays) for (let i = 0; i < 4; ++i) sum += array[first + i];
    if (sum > 0) for (const array of arrays) for (let i = 0; i < 4; ++i) array[first + i] /= sum;
  }
}

/** Disposes data, textures, skins and extensions that nothing refers to; nodes, materials and cameras stay. */
export function disposeUnused(document: Document, replaced: Set<Primitive>): void {
  const root = document.getRoot();
  const isUnused = (property: Property) => property.listParents().every((parent) => parent === root);
  for (const extension of root.listExtensionsUsed()) disposeOrphans(extension);
  for (const skin of root.listSkins()) if (isUnused(skin)) skin.dispose();
  for (const texture of root.listTextures()) if (isUnused(texture)) texture.dispose();
  for (const accessor of root.listAccessors()) if (isUnused(accessor)) accessor.dispose();
  const primitives = root.listMeshes().flatMap((mesh) => mesh.listPrimitives());
  const kept = primitives.filter((primitive) => !replaced.has(primitive));
  for (const extension of root.listExtensionsUsed())
    if (!isNeeded(document, extension, kept)) extension.dispose();
}

/** Properties of an extension that hang nowhere, until none is left. */
function disposeOrphans(extension: Extension): void {
  const orphans = extension.listProperties().filter((property) => property.listParents().length === 0);
  for (const orphan of orphans) orphan.dispose();
  if (orphans.length > 0) disposeOrphans(extension);
}

function isNeeded(document: Document, extension: Extension, kept: Primitive[]): boolean {
  const name = extension.extensionName;
  // Nothing is compressed on output.
  if (COMPRESSIONS.includes(name)) return false;
  return name in NEEDED_BY ? NEEDED_BY[name](document, kept) : extension.listProperties().length > 0;
}

/** Integers where glTF alone allows floats only; colours, joints, weights and normalized UVs may be integers anyway. */
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
