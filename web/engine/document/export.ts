/** A document with some meshes replaced by their optimized geometry, as GLB bytes. */

import { Mesh } from '@gltf-transform/core';
import type { Buffer, Document, Primitive } from '@gltf-transform/core';
import type { TriangleMesh } from '../core';
import { VERSION } from '../version';
import { createGltfIo } from './gltf_io';
import type { Body, OpenModel } from './model';
import { cornerNormals } from './normals';
import type { CornerNormals } from './normals';
import { addSwings } from './shapes';
import type { MorphTarget } from './shapes';
import {
  disposeUnused,
  dropMotion,
  dropPrimitiveExtensions,
  normaliseWeights,
  stripMaterials,
} from './prune';

export { droppedByExport } from './dropped';

export interface ExportedBody {
  mesh: TriangleMesh;
  /** the triangle of the Body that each triangle of `mesh` comes from */
  inputOfTriangle: Uint32Array;
  /** per vertex of `mesh` */
  fields?: { strain: Float32Array; curvature: Float32Array };
  /** shapes to write as morph targets, with an animation each */
  targets?: MorphTarget[];
}

export interface ExportOptions {
  /** write the fields as attributes _STRAIN and _CURVATURE */
  fields: boolean;
}

/** glTF's primitive mode. */
const TRIANGLES = 4;
/** From here on an index needs 32 bits; 65,535 itself is reserved. */
const MANY_VERTICES = 65535;

/** What one primitive of the file shows of the body's mesh. */
interface PrimitiveGeometry {
  /** per vertex here: the vertex of the mesh, and the corner that has its normal */
  vertexOfMesh: number[];
  cornerOfNormal: number[];
  indices: number[];
}

/**
 * Writes the model with `bodies[i]` in place of model.bodies[i]; null leaves a body as it is. The model stays unchanged.
 * Positions are those of the meshes to the bit; normals are smooth and split where faces meet at more than 60 degrees.
 * Faces stay with their primitive, hence with their material; hierarchy, names and extras stay; `droppedByExport` names
 * what does not. The same input gives the same bytes.
 */
export async function exportGlb(
  model: OpenModel,
  bodies: (ExportedBody | null)[],
  options: ExportOptions,
): Promise<Uint8Array> {
  const { cloneDocument } = await import('@gltf-transform/functions');
  const document = cloneDocument(model.document);
  const buffer = mergeBuffers(document);
  const replaced = new Set<Primitive>();
  bodies.forEach((exported, i) => {
    if (!exported) return;
    const shown = options.fields ? exported : { ...exported, fields: undefined };
    for (const primitive of replaceMesh(document, buffer, model.bodies[i], shown)) replaced.add(primitive);
  });
  if (replaced.size > 0) dropMotion(document, replaced);
  normaliseWeights(document, replaced);
  stripMaterials(document, replaced);
  if (bodies.some((exported) => exported?.targets?.length))
    addSwings(document, buffer, meshesWithTargets(replaced));
  disposeUnused(document, replaced);
  document.getRoot().getAsset().generator = `Limber ${VERSION}`;
  return (await createGltfIo()).writeBinary(document);
}

/** A GLB holds one buffer. */
function mergeBuffers(document: Document): Buffer {
  const root = document.getRoot();
  const [kept = document.createBuffer(), ...others] = root.listBuffers();
  kept.setURI('');
  for (const accessor of root.listAccessors()) accessor.setBuffer(kept);
  for (const other of others) other.dispose();
  return kept;
}

/** Gives the body's mesh its new geometry; returns the primitives that hold it. */
function replaceMesh(document: Document, buffer: Buffer, body: Body, exported: ExportedBody): Primitive[] {
  const mesh = document.getRoot().listMeshes()[body.mesh];
  const primitives = mesh.listPrimitives();
  const corners = cornerNormals(exported.mesh);
  const trianglesOfSpan = shareOut(body, exported.inputOfTriangle);
  const written: Primitive[] = [];
  body.spans.forEach(({ primitive: number }, span) => {
    const primitive = primitives[number];
    for (const target of primitive.listTargets()) {
      primitive.removeTarget(target);
      if (target.listParents().length === 0) target.dispose();
    }
    for (const semantic of primitive.listSemantics()) primitive.setAttribute(semantic, null);
    dropPrimitiveExtensions(primitive);
    if (trianglesOfSpan[span].length === 0) primitive.dispose();
    else {
      const geometry = geometryOf(exported.mesh, corners, trianglesOfSpan[span]);
      const attributes = attributesOf(exported, corners, geometry);
      writePrimitive(document, buffer, primitive.setMode(TRIANGLES), attributes, geometry.indices);
      writeTargets(document, buffer, primitive, exported.targets ?? [], geometry);
      written.push(primitive);
    }
  });
  mesh.setWeights((exported.targets ?? []).map(() => 0));
  return written;
}

/** Per span of the body: the triangles of the new mesh that come from it, ascending. */
function shareOut({ spans }: Body, inputOfTriangle: Uint32Array): number[][] {
  const shares: number[][] = spans.map(() => []);
  inputOfTriangle.forEach((source, t) => {
    let span = spans.length - 1;
    while (spans[span].first > source) --span;
    shares[span].push(t);
  });
  return shares;
}

/** Vertices in the order of their first use; one that lies on a sharp edge is there once for each of its normals. */
function geometryOf(mesh: TriangleMesh, { group }: CornerNormals, triangles: number[]): PrimitiveGeometry {
  const geometry: PrimitiveGeometry = { vertexOfMesh: [], cornerOfNormal: [], indices: [] };
  const vertexOfGroup = new Map<number, number>();
  for (const t of triangles)
    for (let corner = 3 * t; corner < 3 * t + 3; ++corner) {
      let vertex = vertexOfGroup.get(group[corner]);
      if (vertex === undefined) {
        vertex = geometry.vertexOfMesh.length;
        vertexOfGroup.set(group[corner], vertex);
        geometry.vertexOfMesh.push(mesh.triangles[corner]);
        geometry.cornerOfNormal.push(group[corner]);
      }
      geometry.indices.push(vertex);
    }
  return geometry;
}

/** Values per vertex by attribute name: 3 floats each, or 1. */
function attributesOf(
  { mesh, fields }: ExportedBody,
  { normals }: CornerNormals,
  { vertexOfMesh, cornerOfNormal }: PrimitiveGeometry,
): Record<string, Float32Array<ArrayBuffer>> {
  const attributes: Record<string, Float32Array<ArrayBuffer>> = {
    POSITION: gatherTriples(mesh.positions, vertexOfMesh),
    NORMAL: gatherTriples(normals, cornerOfNormal),
  };
  if (fields) {
    attributes._STRAIN = Float32Array.from(vertexOfMesh, (v) => fields.strain[v]);
    attributes._CURVATURE = Float32Array.from(vertexOfMesh, (v) => fields.curvature[v]);
  }
  return attributes;
}

function gatherTriples(source: Float32Array, which: number[]): Float32Array<ArrayBuffer> {
  const gathered = new Float32Array(3 * which.length);
  which.forEach((from, to) => {
    for (let c = 0; c < 3; ++c) gathered[3 * to + c] = source[3 * from + c];
  });
  return gathered;
}

function writePrimitive(
  document: Document,
  buffer: Buffer,
  primitive: Primitive,
  attributes: Record<string, Float32Array<ArrayBuffer>>,
  indices: number[],
): void {
  for (const [semantic, array] of Object.entries(attributes)) {
    const type = semantic.startsWith('_') ? 'SCALAR' : 'VEC3';
    primitive.setAttribute(semantic, document.createAccessor('', buffer).setType(type).setArray(array));
  }
  const isLarge = attributes.POSITION.length / 3 >= MANY_VERTICES;
  const array = isLarge ? Uint32Array.from(indices) : Uint16Array.from(indices);
  primitive.setIndices(document.createAccessor('', buffer).setType('SCALAR').setArray(array));
}

function writeTargets(
  document: Document,
  buffer: Buffer,
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

function meshesWithTargets(primitives: Set<Primitive>): Set<Mesh> {
  const moving = [...primitives].filter((primitive) => primitive.listTargets().length > 0);
  return new Set(
    moving.flatMap((primitive) => primitive.listParents()).filter((parent) => parent instanceof Mesh),
  );
}
