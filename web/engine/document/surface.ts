/** Formats without a scene of their own (OBJ, STL, PLY) become a document with one node and mesh per body. */

import { Document } from '@gltf-transform/core';
import type { Body, Format, OpenModel } from './model';

/** One body as a reader found it. */
export interface Surface {
  name: string;
  positions: Float32Array;
  indices: Uint32Array;
  notes: string[];
}

/** What a reader found in a file. */
export interface SurfaceFile {
  surfaces: Surface[];
  notes: string[];
  /** what was there and is not carried, in plain words */
  unread: string[];
}

export function modelOfSurfaces(name: string, format: Format, file: SurfaceFile): OpenModel {
  const document = new Document();
  const buffer = document.createBuffer();
  const scene = document.createScene();
  document.getRoot().setDefaultScene(scene);
  const bodies = file.surfaces.map((surface, index): Body => {
    const positions = document.createAccessor().setType('VEC3').setBuffer(buffer);
    const indices = document.createAccessor().setType('SCALAR').setBuffer(buffer);
    positions.setArray(surface.positions as Float32Array<ArrayBuffer>);
    indices.setArray(surface.indices as Uint32Array<ArrayBuffer>);
    const primitive = document.createPrimitive().setAttribute('POSITION', positions).setIndices(indices);
    const mesh = document.createMesh(surface.name).addPrimitive(primitive);
    scene.addChild(document.createNode(surface.name).setMesh(mesh));
    return { ...surface, mesh: index, spans: [{ primitive: 0, first: 0, firstVertex: 0 }], scale: 1 };
  });
  return { name, format, document, bodies, notes: file.notes, unread: file.unread };
}
