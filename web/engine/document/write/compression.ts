/** How vertices are stored in a file, and how a document is prepared for that. */

import type { Accessor, Document, GLTF, Mesh, Primitive } from '@gltf-transform/core';
import {
  EXTMeshoptCompression,
  KHRDracoMeshCompression,
  KHRMeshQuantization,
} from '@gltf-transform/extensions';
import type { Compression } from '../../core/output_choices';
import { DRACO, loadMeshoptEncoder, MESHOPT, RATIFIED_MESHOPT } from '../gltf_io';
import { INSTANCING } from '../placements';
import { hasQuantized, isUnused } from '../prune';
import { moreThanMesh, moveToChild } from './child_nodes';
import { quantizeDifferences, detachRestingTargets } from './quantized_targets';
import { followThickness } from './thickness';

/** How the vertices of a file are stored. */
export interface Stored {
  kind: Exclude<Compression, 'like-input'>;
  /** whether it uses the ratified name of meshopt's extension */
  isRatified?: true;
}

/** glTF's primitive mode. */
const TRIANGLES = 4;
/** With this many vertices or more, indices need 32 bits. */
const MANY_VERTICES = 65535;
/** Bits of what Draco calls generic: joint weights, which 12 bits let miss the sum 1 by 2e-4, and custom attributes. */
const GENERIC_BITS = 16;
const UNUSED = 0xffffffff;
/** Bits of positions: all 16 cost nothing where nothing is packed after them. */
const POSITION_BITS = { quantized: 16, meshopt: 14 } as const;

/** How the file with this JSON stores its vertices, by its contents, not by the extensions that it declares. */
export function storedIn(json: GLTF.IGLTF): Stored {
  const primitives = (json.meshes ?? []).flatMap((mesh) => mesh.primitives ?? []);
  const views = json.bufferViews ?? [];
  const has = (holder: { extensions?: object }, name: string) => Object.hasOwn(holder.extensions ?? {}, name);
  if (primitives.some((primitive) => has(primitive, DRACO))) return { kind: 'draco' };
  if (views.some((view) => has(view, RATIFIED_MESHOPT))) return { kind: 'meshopt', isRatified: true };
  if (views.some((view) => has(view, MESHOPT))) return { kind: 'meshopt' };
  const isQuantized = (json.extensionsUsed ?? []).includes('KHR_mesh_quantization');
  return { kind: isQuantized ? 'quantized' : 'none' };
}

/** The JSON with the ratified name of meshopt's extension replaced by the one that the reader knows; the format is the same. */
export function withKnownNames(json: GLTF.IGLTF): GLTF.IGLTF {
  return renameExtension(json, RATIFIED_MESHOPT, MESHOPT);
}

/** The JSON with one extension of its buffers and their views under another name; the JSON itself where it has none. */
export function renameExtension(json: GLTF.IGLTF, from: string, to: string): GLTF.IGLTF {
  if (!json.extensionsUsed?.includes(from)) return json;
  const renamed = (names?: string[]) =>
    names && [...new Set(names.map((name) => (name === from ? to : name)))];
  const inside = <T extends { extensions?: Record<string, unknown> }>(holder: T): T => {
    if (!holder.extensions || !Object.hasOwn(holder.extensions, from)) return holder;
    const { [from]: value, ...others } = holder.extensions;
    return { ...holder, extensions: { ...others, [to]: value } };
  };
  return {
    ...json,
    extensionsUsed: renamed(json.extensionsUsed),
    ...(json.extensionsRequired ? { extensionsRequired: renamed(json.extensionsRequired) } : {}),
    ...(json.buffers ? { buffers: json.buffers.map(inside) } : {}),
    ...(json.bufferViews ? { bufferViews: json.bufferViews.map(inside) } : {}),
  } as GLTF.IGLTF;
}

export interface CompressionRequest {
  kind: Stored['kind'];
  /** whether attributes are quantized first; false: they keep their component types */
  quantizes: boolean;
  /** whether vertices and triangles keep their order, because another file refers to them by index */
  keepsOrder: boolean;
  /** the primitives that are rewritten; others keep their order */
  replaced: ReadonlySet<Primitive>;
  /** makes these primitives, which have their own data before, share equal data */
  share: () => void;
  /** whether nodes stay unchanged; otherwise quantized positions may scale and translate them */
  keepsNodes: boolean;
}

/** Prepares the document to be written compressed or plain; the writer packs the data. */
export async function compress(document: Document, request: CompressionRequest): Promise<void> {
  const { kind, quantizes, keepsOrder, replaced } = request;
  if (kind === 'draco') {
    request.share();
    unshare(document);
    const { EDGEBREAKER, SEQUENTIAL } = KHRDracoMeshCompression.EncoderMethod;
    const method = keepsOrder ? SEQUENTIAL : EDGEBREAKER;
    const quantizationBits = { GENERIC: GENERIC_BITS };
    const draco = document.createExtension(KHRDracoMeshCompression).setRequired(true);
    draco.setEncoderOptions({ method, quantizationBits });
    return;
  }
  if (kind === 'meshopt' && !keepsOrder) {
    const encoder = await loadMeshoptEncoder();
    for (const primitive of replaced) reorder(primitive, encoder.reorderMesh);
  }
  if (quantizes && kind !== 'none') await quantizeAll(document, request);
  request.share();
  if (kind === 'meshopt') document.createExtension(EXTMeshoptCompression).setRequired(true);
}

/** Attributes of the document as integers; positions of a mesh in a box of its own. */
async function quantizeAll(document: Document, { kind, keepsNodes }: CompressionRequest): Promise<void> {
  const { quantize } = await import('@gltf-transform/functions');
  const bits = POSITION_BITS[kind as keyof typeof POSITION_BITS];
  if (!keepsNodes) {
    // glTF-Transform adjusts nodes to the box of positions even where these are integers already, which it leaves or rounds.
    for (const mesh of document.getRoot().listMeshes()) makePositionsFloat(mesh.listPrimitives());
    giveOwnNodes(document);
  }
  // Custom attributes can be of any magnitude, such as masses in kg, which few bits would round to 0.
  const pattern = keepsNodes ? /^(?!POSITION|_)/ : /^(?!_)/;
  const patternTargets = keepsNodes ? /^(?!)/ : /^POSITION$/;
  quantizeDifferences(document);
  const shown = document
    .getRoot()
    .listMaterials()
    .filter((material) => !isUnused(material, document.getRoot()));
  const putBack = [detachUnpositioned(document), detachRestingTargets(document)];
  if (!keepsNodes) putBack.push(followThickness(document));
  await document.transform(quantize({ pattern, patternTargets, quantizePosition: bits, cleanup: false }));
  for (const undo of putBack.reverse()) undo();
  // glTF-Transform declares it only where positions are integers, not where other attributes alone are.
  if (hasQuantized(document)) document.createExtension(KHRMeshQuantization).setRequired(true);
  const root = document.getRoot();
  // Skins and materials with a thickness were replaced by copies in the quantized scale; the old ones are unused.
  for (const list of [root.listSkins(), root.listAccessors(), shown])
    for (const property of list) if (isUnused(property, root)) property.dispose();
}

/** Removes primitives without positions, which cannot be quantized, from their meshes; the returned function puts them back. */
function detachUnpositioned(document: Document): () => void {
  const hasUnplaced = (mesh: Mesh) => mesh.listPrimitives().some((one) => !one.getAttribute('POSITION'));
  const taken = document.getRoot().listMeshes().filter(hasUnplaced);
  const whole = taken.map((mesh) => mesh.listPrimitives());
  for (const mesh of taken)
    for (const primitive of mesh.listPrimitives())
      if (!primitive.getAttribute('POSITION')) mesh.removePrimitive(primitive);
  const empty = taken.filter((mesh) => mesh.listPrimitives().length === 0);
  const endStandIns = empty.map((mesh) => addStandIn(document, mesh));
  return () => {
    for (const end of endStandIns) end();
    taken.forEach((mesh, i) => {
      for (const primitive of mesh.listPrimitives()) mesh.removePrimitive(primitive);
      for (const primitive of whole[i]) mesh.addPrimitive(primitive);
    });
  };
}

/** Gives a mesh without primitives one whose box is that of the integers, so that its nodes stay; the returned function removes it. */
function addStandIn(document: Document, mesh: Mesh): () => void {
  const [buffer] = document.getRoot().listBuffers();
  const corners = Float32Array.of(-1, -1, -1, 1, 1, 1);
  const positions = document.createAccessor('', buffer).setType('VEC3').setArray(corners);
  const primitive = document.createPrimitive().setAttribute('POSITION', positions);
  mesh.addPrimitive(primitive);
  return () => {
    for (const one of [primitive.getAttribute('POSITION')!, positions, primitive]) one.dispose();
  };
}

function makePositionsFloat(primitives: Primitive[]): void {
  const holders = primitives.flatMap((primitive) => [primitive, ...primitive.listTargets()]);
  const accessors = new Set(holders.map((holder) => holder.getAttribute('POSITION')));
  for (const accessor of accessors)
    if (accessor && !(accessor.getArray() instanceof Float32Array)) makeFloat(accessor);
}

function makeFloat(accessor: Accessor): void {
  const [size, element] = [accessor.getElementSize(), [] as number[]];
  const floats = new Float32Array(size * accessor.getCount());
  for (let v = 0; v < accessor.getCount(); ++v) floats.set(accessor.getElement(v, element), size * v);
  accessor.setArray(floats).setNormalized(false);
}

/**
 * A node with another purpose than to show its mesh gets a child for the mesh, since quantized positions scale and translate their node. If it has
 * instances, these are adjusted instead.
 */
function giveOwnNodes(document: Document): void {
  const root = document.getRoot();
  const isMore = moreThanMesh(document);
  for (const node of root.listNodes()) {
    if (!node.getMesh() || node.getSkin() || node.getExtension(INSTANCING) || !isMore(node)) continue;
    moveToChild(document, node, node.getName());
  }
}

type ReorderMesh = Awaited<ReturnType<typeof loadMeshoptEncoder>>['reorderMesh'];

/** Sorts triangles and vertices into the order that compresses best. The primitive must not share its accessors. */
function reorder(primitive: Primitive, reorderMesh: ReorderMesh): void {
  const indices = primitive.getIndices()!;
  const triangles = Uint32Array.from(indices.getArray()!);
  if (triangles.length === 0) return;
  const [newVertexOf, count] = reorderMesh(triangles, true, true);
  indices.setArray(count < MANY_VERTICES ? Uint16Array.from(triangles) : triangles);
  const accessors = [primitive, ...primitive.listTargets()].flatMap((holder) => holder.listAttributes());
  for (const accessor of new Set(accessors)) {
    const [array, size] = [accessor.getArray()!, accessor.getElementSize()];
    const moved = array.slice(0, size * count);
    newVertexOf.forEach((to, from) => {
      if (to === UNUSED) return;
      for (let c = 0; c < size; ++c) moved[size * to + c] = array[size * from + c];
    });
    accessor.setArray(moved);
  }
}

/** Ends partial sharing of data: Draco packs every primitive as a whole, so only primitives that share all of their data can share the packed data. */
function unshare(document: Document): void {
  const root = document.getRoot();
  const numbers = new Map(root.listAccessors().map((accessor, i) => [accessor, i]));
  const primitives = root.listMeshes().flatMap((mesh) => mesh.listPrimitives());
  const isPacked = (primitive: Primitive) =>
    primitive.getIndices() !== null && (primitive.getMode() as number) === TRIANGLES;
  // The order of vertices stays where they have morph targets, which are not packed.
  const wholeOf = (primitive: Primitive) => {
    const named = primitive
      .listSemantics()
      .map((name) => `${name} ${numbers.get(primitive.getAttribute(name)!)}`);
    return [primitive.listTargets().length > 0, numbers.get(primitive.getIndices()!), ...named.sort()].join(
      ' ',
    );
  };
  const owners = new AccessorOwners();
  for (const primitive of primitives) if (isPacked(primitive)) owners.give(primitive, wholeOf(primitive));
  for (const primitive of primitives) if (!isPacked(primitive)) owners.give(primitive, 'plain');
}

/** Gives each accessor to the first owner that asks for it; others get copies. */
class AccessorOwners {
  private readonly owners = new Map<Accessor, string>();
  private readonly copies = new Map<string, Map<Accessor, Accessor>>();

  give(primitive: Primitive, owner: string): void {
    for (const accessor of new Set(accessorsOf(primitive))) {
      const first = this.owners.get(accessor) ?? owner;
      this.owners.set(accessor, first);
      if (first !== owner) primitive.swap(accessor, this.copyOf(accessor, owner));
    }
  }

  private copyOf(accessor: Accessor, owner: string): Accessor {
    const own = this.copies.get(owner) ?? new Map<Accessor, Accessor>();
    const copy = own.get(accessor) ?? accessor.clone();
    this.copies.set(owner, own.set(accessor, copy));
    return copy;
  }
}

const accessorsOf = (primitive: Primitive): Accessor[] =>
  [primitive.getIndices(), ...primitive.listAttributes()].filter((accessor) => accessor !== null);
