/** A document with some meshes replaced by their optimized geometry, as GLB bytes. */

import { Mesh } from '@gltf-transform/core';
import type { Accessor, Buffer, Document, Primitive } from '@gltf-transform/core';
import type { CornerSources, TriangleMesh } from '../core/core';
import { VERSION } from '../core/version';
import { carryAttributes, carryTargets } from './carry';
import type { Destination } from './carry';
import { copyDocument } from './extensions/variants';
import type { Body, OpenModel } from './model';
import { normalKeys, normalsOf } from './shading/normal_keys';
import { resultNormals } from './shading/normals';
import { followMikkTSpace, remakeTangents, tangentGenerator } from './shading/tangents';
import type { GenerateTangents } from './shading/tangents';
import type { ResultNormals } from './shading/normals';
import { disposeUnused, dropMorphing, dropUncarried, normaliseWeights } from './prune';
import type { Kept } from './prune';
import { addSwings } from './shapes';
import { spanOf } from './facts/spans';
import { dropEarlierAttributes, dropEarlierExtras } from './write/earlier_results';
import { NO_ADDITIONS, writeGlb } from './write/gltf_files';
import type { Additions } from './write/gltf_files';
import { rememberShared } from './write/shared_accessors';
import { withStoredType, staysStored } from './write/stored_values';
import type { MorphTarget } from './shapes';
import { GrowingIndices } from './growing';
import { CARRIED, geometryOf, isUntouched } from './vertices';
import type { PrimitiveGeometry, SourcedMesh } from './vertices';

export { droppedByExport } from './dropped';

export interface ExportedBody {
  /** the body of the model that it replaces */
  body: Body;
  mesh: TriangleMesh;
  /** per triangle of `mesh`: the triangle of `body` that it comes from */
  inputOfTriangle: Uint32Array;
  /** per corner of `mesh`: the point of `body` that its attributes come from; null: the body has nothing but positions */
  sources: CornerSources | null;
  /** edges whose faces meet at a smaller cosine are hard, and changed faces get normals by that; null: normals are carried */
  hardCosine: number | null;
  /** per vertex of `mesh` */
  fields?: { strain: Float32Array; curvature: Float32Array };
  /** shapes written as morph targets, each with an animation; they replace the body's own */
  targets?: MorphTarget[];
  /** written to the mesh's extras for engines; see CalibrationReport */
  calibration?: number;
  /** written for engines: to the mesh's extras as `limberSettings`, and as attributes */
  settings?: ExportedSettings;
}

export interface ExportedSettings {
  extras: object;
  /** values per vertex of the mesh, by semantic: `_LIMBER_MASS` and so on */
  attributes: Readonly<Record<string, Float32Array>>;
}

export interface ExportOptions {
  /** write the fields as attributes _STRAIN and _CURVATURE */
  fields: boolean;
}

/** The generator that written files name; such files may be overwritten without asking. */
export const GENERATOR = `Limber ${VERSION}`;
/** glTF's primitive mode. */
const TRIANGLES = 4;
/** With this many vertices or more, indices need 32 bits: index 65,535 is reserved. */
const MANY_VERTICES = 65535;

/**
 * Writes the model with model.bodies[i] replaced by `bodies[i]`; null leaves a body unchanged. The model itself does not
 * change. Written positions equal those of the meshes bit for bit. Every attribute and morph target is interpolated from
 * the body at the corners' sources and keeps its component type, but what an earlier run of Limber added is left out. A glTF body
 * without normals gets none, so that viewers shade it flat as before; bodies of other formats get smooth normals, split where
 * faces meet at more than 60 degrees.
 * Faces keep their primitive and hence their material. Hierarchy, skins, animations, names and extras are preserved;
 * `droppedByExport` lists what is not. The same input gives the same bytes.
 */
export async function exportGlb(
  model: OpenModel,
  bodies: (ExportedBody | null)[],
  options: ExportOptions,
): Promise<Uint8Array> {
  const destination = await copyForExport(model);
  const shareAgain = rememberShared(destination.document);
  const replaced = replaceBodies(destination, bodies, {
    ...options,
    smoothed: isSmoothed(model),
    keepsNumbers: !!model.foreign,
    tangents: await tangentGenerator(model.document),
  });
  shareAgain(replaced);
  return writeGlb(destination.document, additionsOf(model, bodies));
}

/** A copy of the model's document with one buffer. */
export async function copyForExport(model: OpenModel): Promise<Destination> {
  const document = await copyDocument(model.document);
  return { document, buffer: mergeBuffers(document) };
}

/** What the JSON of a result contains beyond its document. */
export const additionsOf = (model: OpenModel, bodies: (ExportedBody | null)[]): Additions => ({
  ...NO_ADDITIONS,
  foreign: model.foreign ?? null,
  textureTexts: model.textureTexts ?? null,
  innerExtras: model.innerExtras ?? [],
  replaced: new Set(bodies.flatMap((exported) => (exported ? [exported.body.mesh] : []))),
});

export interface ReplaceOptions extends ExportOptions, Kept {
  /** whether primitives without normals get smooth ones */
  smoothed: boolean;
  /**
   * whether positions and normals of integers stay integers; otherwise they become floats, as do positions of a mesh that has one
   * outside the range of its integers
   */
  keepsStored?: boolean;
  /** makes tangents of changed faces again, see `tangentGenerator`; null: they are carried */
  tangents: GenerateTangents | null;
  /** meshes of the document that are no body themselves: copies that become further levels */
  further?: { mesh: Mesh; exported: ExportedBody }[];
}

/**
 * Replaces meshes of the document itself, as `exportGlb` does in its copy; null leaves a body unchanged. Returns the primitives that
 * are rewritten, each with accessors of its own.
 */
export function replaceBodies(
  destination: Destination,
  bodies: (ExportedBody | null)[],
  options: ReplaceOptions,
): Set<Primitive> {
  const { document, buffer } = destination;
  const meshes = document.getRoot().listMeshes();
  const replaced = new Set<Primitive>();
  const own = bodies.flatMap((exported) =>
    exported ? [{ mesh: meshes[exported.body.mesh], exported }] : [],
  );
  for (const { mesh, exported } of [...(options.further ?? []), ...own]) {
    const shown = options.fields ? exported : { ...exported, fields: undefined };
    for (const primitive of replaceMesh(destination, mesh, shown, options)) replaced.add(primitive);
  }
  normaliseWeights(document);
  if (bodies.some((exported) => exported?.targets?.length))
    addSwings(document, buffer, meshesWithTargets(replaced));
  disposeUnused(document, replaced, options);
  document.getRoot().getAsset().generator = GENERATOR;
  return replaced;
}

/** Per vertex of each primitive that `exportGlb` writes for a body, in order: its vertex of `exported.mesh`. */
export function renderVertices(model: OpenModel, exported: ExportedBody): number[] {
  const { body } = exported;
  const primitives = model.document.getRoot().listMeshes()[body.mesh].listPrimitives();
  const sourced: SourcedMesh = { mesh: exported.mesh, body, sources: exported.sources };
  const normals = resultNormals(exported.mesh, exported.hardCosine ?? undefined);
  const trianglesOfSpan = trianglesBySpan(body, exported.inputOfTriangle);
  return body.spans.flatMap((span, i) => {
    const primitive = primitives[span.primitive];
    const keyOf = normalKeys(primitive, span, exported, { normals, smoothed: isSmoothed(model) });
    return [...geometryOf(sourced, span, primitive, trianglesOfSpan[i], keyOf).vertexOfMesh];
  });
}

/** glTF prescribes flat shading for meshes without normals; the other formats prescribe nothing. */
export function isSmoothed({ format }: OpenModel): boolean {
  return format !== 'glb' && format !== 'gltf';
}

/** A GLB can contain only one buffer. */
function mergeBuffers(document: Document): Buffer {
  const root = document.getRoot();
  const [kept = document.createBuffer(), ...others] = root.listBuffers();
  kept.setURI('');
  for (const accessor of root.listAccessors()) accessor.setBuffer(kept);
  for (const other of others) other.dispose();
  return kept;
}

/** Gives a mesh with the primitives of the body its new geometry and returns the primitives written. */
function replaceMesh(
  destination: Destination,
  mesh: Mesh,
  exported: ExportedBody,
  { smoothed, tangents, keepsStored = false }: ReplaceOptions,
): Primitive[] {
  const { body } = exported;
  const primitives = mesh.listPrimitives();
  if (exported.targets) dropMorphing(destination.document, mesh);
  const sourced: SourcedMesh = { mesh: exported.mesh, body, sources: exported.sources };
  const normals = resultNormals(exported.mesh, exported.hardCosine ?? undefined);
  const trianglesOfSpan = trianglesBySpan(body, exported.inputOfTriangle);
  const written: Primitive[] = [];
  const before = body.spans.map(({ primitive }) => primitives[primitive].getAttribute('POSITION')!);
  const stores = staysStored(keepsStored, exported.mesh.positions, before);
  body.spans.forEach((span, i) => {
    const primitive = primitives[span.primitive];
    if (trianglesOfSpan[i].length === 0) {
      primitive.dispose();
      return;
    }
    const keyOf = normalKeys(primitive, span, exported, { normals, smoothed });
    const geometry = geometryOf(sourced, span, primitive, trianglesOfSpan[i], keyOf);
    const old = tangents && mikkTSpaceOf(primitive, indicesOfSpan(body, i), tangents);
    writePrimitive(destination, primitive.setMode(TRIANGLES), exported, { geometry, normals, stores });
    if (old) {
      const isUnchanged = Array.from(
        trianglesOfSpan[i],
        (t) => exported.sources !== null && isUntouched(exported.sources, t, exported.inputOfTriangle[t]),
      );
      remakeTangents(primitive, isUnchanged, old, tangents);
    }
    written.push(primitive);
  });
  dropEarlierExtras(mesh);
  if (exported.calibration !== undefined)
    mesh.setExtras({ ...mesh.getExtras(), limberCalibration: exported.calibration });
  if (exported.settings) mesh.setExtras({ ...mesh.getExtras(), limberSettings: exported.settings.extras });
  if (exported.targets) {
    mesh.setWeights(exported.targets.map(() => 0));
    addRestingTargets(destination, mesh, exported.targets);
  }
  return written;
}

/** Adds targets without displacement to points and lines, because all primitives of a mesh must have the same morph targets. */
function addRestingTargets({ document, buffer }: Destination, mesh: Mesh, targets: MorphTarget[]): void {
  for (const primitive of mesh.listPrimitives()) {
    const positions = primitive.getAttribute('POSITION');
    if (!positions || primitive.listTargets().length > 0 || targets.length === 0) continue;
    const resting = new Float32Array(3 * positions.getCount());
    const accessor = document.createAccessor('', buffer).setType('VEC3').setArray(resting);
    for (const { name } of targets)
      primitive.addTarget(document.createPrimitiveTarget(name).setAttribute('POSITION', accessor));
  }
}

/** The tangents of a primitive, if they are MikkTSpace's; `indices`: of its triangles. */
const mikkTSpaceOf = (
  primitive: Primitive,
  indices: Uint32Array,
  tangents: GenerateTangents,
): Accessor | null =>
  followMikkTSpace(primitive, indices, tangents) ? primitive.getAttribute('TANGENT') : null;

/** The vertices of a span's triangles as its primitive counts them. */
function indicesOfSpan({ spans, indices }: Body, i: number): Uint32Array {
  const { first, firstVertex } = spans[i];
  return indices
    .subarray(3 * first, 3 * (spans[i + 1]?.first ?? indices.length / 3))
    .map((v) => v - firstVertex);
}

/** Per span of the body: the triangles of the new mesh that come from it, ascending. */
function trianglesBySpan(body: Body, inputOfTriangle: Uint32Array): Uint32Array[] {
  const shares = body.spans.map(() => new GrowingIndices());
  inputOfTriangle.forEach((source, t) => shares[spanOf(body, source)].push(t));
  return shares.map((share) => share.finish());
}

/** Replaces the primitive's geometry, attributes and morph targets. */
function writePrimitive(
  destination: Destination,
  primitive: Primitive,
  exported: ExportedBody,
  {
    geometry,
    normals,
    stores,
  }: { geometry: PrimitiveGeometry; normals: ResultNormals; stores: (semantic: string) => boolean },
): void {
  const { vertexOfMesh, firstCorner, sources } = geometry;
  dropUncarried(primitive);
  dropEarlierAttributes(primitive);
  carryAttributes(destination, primitive, sources, (i) => normals.at(normals.smoothKey(firstCorner[i])));
  carryTargets(destination, primitive, sources);
  const add = (semantic: string, values: Float32Array<ArrayBuffer>, type: 'VEC3' | 'SCALAR') => {
    const accessor = destination.document
      .createAccessor('', destination.buffer)
      .setType(type)
      .setArray(values);
    const old = primitive.getAttribute(semantic);
    primitive.setAttribute(semantic, old && stores(semantic) ? withStoredType(accessor, old) : accessor);
  };
  add('POSITION', gatherTriples(exported.mesh.positions, vertexOfMesh), 'VEC3');
  if (geometry.normalKey.some((key) => key !== CARRIED))
    add('NORMAL', normalsOf(primitive.getAttribute('NORMAL'), geometry, normals), 'VEC3');
  if (exported.fields) {
    const { strain, curvature } = exported.fields;
    add(
      '_STRAIN',
      Float32Array.from(vertexOfMesh, (v) => strain[v]),
      'SCALAR',
    );
    add(
      '_CURVATURE',
      Float32Array.from(vertexOfMesh, (v) => curvature[v]),
      'SCALAR',
    );
  }
  for (const [semantic, values] of Object.entries(exported.settings?.attributes ?? {}))
    add(
      semantic,
      Float32Array.from(vertexOfMesh, (v) => values[v]),
      'SCALAR',
    );
  writeIndices(destination, primitive, geometry);
  writeTargets(destination, primitive, exported.targets ?? [], geometry);
}

function writeIndices(
  { document, buffer }: Destination,
  primitive: Primitive,
  geometry: PrimitiveGeometry,
): void {
  const isLarge = geometry.vertexOfMesh.length >= MANY_VERTICES;
  const array = isLarge ? geometry.indices : Uint16Array.from(geometry.indices);
  primitive.setIndices(document.createAccessor('', buffer).setType('SCALAR').setArray(array));
}

function writeTargets(
  { document, buffer }: Destination,
  primitive: Primitive,
  targets: MorphTarget[],
  { vertexOfMesh }: PrimitiveGeometry,
): void {
  for (const { name, displacements } of targets) {
    const array = gatherTriples(displacements, vertexOfMesh);
    const accessor = document.createAccessor('', buffer).setType('VEC3').setArray(array);
    primitive.addTarget(document.createPrimitiveTarget(name).setAttribute('POSITION', accessor));
  }
}

function gatherTriples(source: Float32Array, which: Uint32Array): Float32Array<ArrayBuffer> {
  const gathered = new Float32Array(3 * which.length);
  which.forEach((from, to) => {
    for (let c = 0; c < 3; ++c) gathered[3 * to + c] = source[3 * from + c];
  });
  return gathered;
}

function meshesWithTargets(primitives: Set<Primitive>): Set<Mesh> {
  const moving = [...primitives].filter((primitive) => primitive.listTargets().length > 0);
  return new Set(
    moving.flatMap((primitive) => primitive.listParents()).filter((parent) => parent instanceof Mesh),
  );
}
