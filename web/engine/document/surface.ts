/** Turns files of formats without a scene (OBJ, STL, PLY) into a document with one node and one mesh per body. */

import { Document } from '@gltf-transform/core';
import type { Accessor, Buffer, Material, Primitive } from '@gltf-transform/core';
import { SILENT } from './gltf_io';
import type { Body, Format, OpenModel } from './model';

/** One body as read from a file. */
export interface Surface {
  name: string;
  positions: Float32Array;
  indices: Uint32Array;
  /** vertex attributes under glTF's names; normals have length 1, UVs start at the upper left corner */
  attributes?: SurfaceAttributes;
  /** triangles [first, next part's first) have this material ('' for none); absent: one part without material */
  parts?: { material: string; first: number }[];
  notes: string[];
}

export interface SurfaceAttributes {
  NORMAL?: Float32Array;
  TEXCOORD_0?: Float32Array;
  /** linear light, three numbers for each vertex or four with its opacity; 65,535 stands for 1 */
  COLOR_0?: Uint16Array;
}

/** The content of a file as read. */
export interface SurfaceFile {
  surfaces: Surface[];
  notes: string[];
  /** content of the file that is dropped, in words for the user */
  unread: string[];
  /** names of the material libraries of an OBJ */
  libraries?: string[];
}

/** Finds or makes the material of a name, for a surface with or without UVs. */
export type MaterialMaker = (name: string, hasUvs: boolean) => Material;

/** `makerOf`: makes the materials; by default they have nothing but names. */
export function modelOfSurfaces(
  name: string,
  format: Format,
  file: SurfaceFile,
  makerOf: (document: Document) => MaterialMaker = plainMaker,
): OpenModel {
  const document = new Document().setLogger(SILENT);
  document.createBuffer();
  const scene = document.createScene();
  document.getRoot().setDefaultScene(scene);
  const materialOf = makerOf(document);
  const bodies = file.surfaces.map((surface, index): Body => {
    const { positions, indices, notes } = surface;
    const parts = surface.parts ?? [{ material: '', first: 0 }];
    const mesh = document.createMesh(surface.name);
    for (const primitive of primitivesOf(document, surface, parts, materialOf)) mesh.addPrimitive(primitive);
    scene.addChild(document.createNode(surface.name).setMesh(mesh));
    const vertexCount = positions.length / 3;
    const spans = parts.map(({ first }, primitive) => ({ primitive, first, firstVertex: 0, vertexCount }));
    return { name: surface.name, positions, indices, notes, mesh: index, spans, scale: 1 };
  });
  const { notes, unread, libraries = [] } = file;
  return { name, format, document, bodies, notes, unread, libraries };
}

/** One primitive per part; all share the vertices. */
function primitivesOf(
  document: Document,
  { positions, indices, attributes = {} }: Surface,
  parts: { material: string; first: number }[],
  materialOf: MaterialMaker,
): Primitive[] {
  const [buffer] = document.getRoot().listBuffers();
  const shared = Object.entries({ POSITION: positions, ...attributes }).map(
    ([semantic, array]) =>
      [semantic, accessorOf(document, buffer, array, (3 * array.length) / positions.length)] as const,
  );
  return parts.map(({ material, first }, i) => {
    const corners = indices.subarray(3 * first, i + 1 < parts.length ? 3 * parts[i + 1].first : undefined);
    const accessor = document.createAccessor().setType('SCALAR').setBuffer(buffer);
    const primitive = document
      .createPrimitive()
      .setIndices(accessor.setArray(corners as Uint32Array<ArrayBuffer>));
    for (const [semantic, values] of shared) primitive.setAttribute(semantic, values);
    return material === ''
      ? primitive
      : primitive.setMaterial(materialOf(material, 'TEXCOORD_0' in attributes));
  });
}

function accessorOf(
  document: Document,
  buffer: Buffer,
  array: Float32Array | Uint16Array,
  size: number,
): Accessor {
  return document
    .createAccessor()
    .setType(size === 2 ? 'VEC2' : size === 3 ? 'VEC3' : 'VEC4')
    .setNormalized(array instanceof Uint16Array)
    .setBuffer(buffer)
    .setArray(array as Float32Array<ArrayBuffer> | Uint16Array<ArrayBuffer>);
}

/** A material of which only the name is known. */
export const plainMaterial = (document: Document, name: string): Material =>
  document.createMaterial(name).setMetallicFactor(0);

function plainMaker(document: Document): MaterialMaker {
  const made = new Map<string, Material>();
  return (name) => {
    const material = made.get(name) ?? plainMaterial(document, name);
    made.set(name, material);
    return material;
  };
}
