/** Writes a document as one binary PLY: all that its scene shows in one list of vertices and one of triangles. */

import type { Document } from '@gltf-transform/core';
import type { SourceFile } from '../model';
import { flatMeshes } from './flat_meshes';
import type { FlatPrimitive } from './flat_meshes';
import { toSrgb } from './text_values';

const FACE_BYTES = 13;

/** What vertices have besides positions. */
interface Written {
  normals: boolean;
  uvs: boolean;
  colours: boolean;
  opacities: boolean;
}

/** `mark`: a comment. Normals, UVs and colours are written where every primitive has them, opacities where a colour has one. */
export function writePly(document: Document, name: string, mark: string): SourceFile {
  const primitives = flatMeshes(document).flatMap((mesh) => mesh.primitives);
  const sum = (count: (primitive: FlatPrimitive) => number) =>
    primitives.reduce((all, primitive) => all + count(primitive), 0);
  const vertices = sum(({ positions }) => positions.length / 3);
  const faces = sum(({ triangles }) => triangles.length / 3);
  const hasColours = primitives.every(({ colours }) => colours !== null);
  const has: Written = {
    normals: primitives.every(({ normals }) => normals !== null),
    uvs: primitives.every(({ uvs }) => uvs !== null),
    colours: hasColours,
    opacities: hasColours && primitives.some(({ opacities }) => opacities !== null),
  };
  const channels = [...(has.colours ? ['red', 'green', 'blue'] : []), ...(has.opacities ? ['alpha'] : [])];
  const floats = ['x', 'y', 'z', ...(has.normals ? ['nx', 'ny', 'nz'] : []), ...(has.uvs ? ['s', 't'] : [])];
  const header = [
    'ply',
    'format binary_little_endian 1.0',
    `comment ${mark}`,
    `element vertex ${vertices}`,
    ...floats.map((property) => `property float ${property}`),
    ...channels.map((property) => `property uchar ${property}`),
    `element face ${faces}`,
    'property list uchar int vertex_indices',
    'end_header\n',
  ].join('\n');
  const stride = 4 * floats.length + channels.length;
  const start = new TextEncoder().encode(header);
  const bytes = new Uint8Array(start.length + stride * vertices + FACE_BYTES * faces);
  bytes.set(start);
  const view = new DataView(bytes.buffer);
  let at = start.length;
  for (const primitive of primitives) at = writeVertices(view, at, primitive, has);
  writeFaces(view, at, primitives);
  return { name, bytes };
}

function writeVertices(
  view: DataView,
  start: number,
  { positions, normals, uvs, colours, opacities }: FlatPrimitive,
  has: Written,
): number {
  let at = start;
  const float = (value: number) => {
    view.setFloat32(at, value, true);
    at += 4;
  };
  for (let v = 0; v < positions.length / 3; ++v) {
    for (let c = 0; c < 3; ++c) float(positions[3 * v + c]);
    if (has.normals) for (let c = 0; c < 3; ++c) float(normals![3 * v + c]);
    if (has.uvs) {
      float(uvs![2 * v]);
      float(1 - uvs![2 * v + 1]);
    }
    if (has.colours)
      for (let c = 0; c < 3; ++c) view.setUint8(at++, Math.round(255 * toSrgb(colours![3 * v + c])));
    if (has.opacities) view.setUint8(at++, Math.round(255 * Math.min(1, Math.max(0, opacities?.[v] ?? 1))));
  }
  return at;
}

function writeFaces(view: DataView, start: number, primitives: FlatPrimitive[]): void {
  let [at, first] = [start, 0];
  for (const { positions, triangles } of primitives) {
    for (let t = 0; t < triangles.length; t += 3, at += FACE_BYTES) {
      view.setUint8(at, 3);
      for (let c = 0; c < 3; ++c) view.setInt32(at + 1 + 4 * c, first + triangles[t + c], true);
    }
    first += positions.length / 3;
  }
}
