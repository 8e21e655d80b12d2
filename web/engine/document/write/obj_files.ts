/** Writes a document as OBJ with a material library and pictures. Every node with a mesh is an object, in the scene's space. */

import type { Document } from '@gltf-transform/core';
import type { OpenModel, SourceFile } from '../model';
import { flatMeshes } from './flat_meshes';
import type { FlatMesh, FlatPrimitive } from './flat_meshes';
import { MaterialLibrary } from './obj_materials';
import { imageFiles, imageNames } from './shared_images';
import type { Companion } from './shared_images';
import { distinctTexts, shortest, toSrgb } from './text_values';

/** Lines are joined in chunks, since the text of a large mesh could exceed the maximum length of a string. */
const LINES_A_PIECE = 1 << 14;

/** The libraries of an input that say what its materials look like, as the model has them. */
type InputLibraries = Pick<OpenModel, 'libraries' | 'carried'>;

/**
 * `name`.obj, and `stem`.mtl with pictures if there are materials. If the input has `libraries`, the OBJ refers to them instead, and
 * `carried` are those that are written. `mark`: the first line, without its #.
 */
export function writeObj(
  document: Document,
  name: string,
  { libraries = [], carried = [], mark }: InputLibraries & { mark: string },
): SourceFile[] {
  const stem = name.replace(/\.obj$/i, '');
  const lines = new TextPieces();
  const meshes = flatMeshes(document);
  const materials = new MaterialLibrary(imageNames(document, stem), libraries.length > 0);
  const hasOwn =
    libraries.length === 0 && meshes.some(({ primitives }) => primitives.some((p) => p.material));
  const named = hasOwn ? [`${stem}.mtl`] : libraries;
  lines.add(`# ${mark}`);
  lines.addAll(named.map((library) => `mtllib ${library}`));
  const counts = { positions: 0, uvs: 0, normals: 0 };
  const names = new Set<string>();
  for (const mesh of meshes)
    writeMesh(lines, mesh, { counts, materials, name: uniqueName(mesh.name, names) });
  const main = { name, bytes: lines.bytes() };
  if (!hasOwn) return [main, ...carried.filter((file) => file.name !== name)];
  const library = { name: `${stem}.mtl`, bytes: new TextEncoder().encode(materials.text(mark)) };
  return [main, library, ...materials.pictures()];
}

/** The files that `writeObj` may write beside the main one. */
export function objCompanions(
  document: Document,
  name: string,
  { libraries = [], carried = [] }: InputLibraries,
): Companion[] {
  if (libraries.length > 0) return carried;
  if (document.getRoot().listMaterials().length === 0) return [];
  const stem = name.replace(/\.obj$/i, '');
  return [{ name: `${stem}.mtl`, bytes: null }, ...imageFiles(document, stem)];
}

class TextPieces {
  private readonly pieces: Uint8Array[] = [];
  private lines: string[] = [];

  add(line: string): void {
    this.lines.push(line);
    if (this.lines.length >= LINES_A_PIECE) this.flush();
  }

  addAll(lines: string[]): void {
    for (const line of lines) this.add(line);
  }

  bytes(): Uint8Array {
    this.flush();
    const bytes = new Uint8Array(this.pieces.reduce((sum, piece) => sum + piece.length, 0));
    let at = 0;
    for (const piece of this.pieces) {
      bytes.set(piece, at);
      at += piece.length;
    }
    return bytes;
  }

  private flush(): void {
    if (this.lines.length > 0) this.pieces.push(new TextEncoder().encode(`${this.lines.join('\n')}\n`));
    this.lines = [];
  }
}

/** A unique name: readers merge objects with equal names, so that a second one gets a number. */
function uniqueName(name: string, taken: Set<string>): string {
  const plain = name.replaceAll(/[\r\n]+/g, ' ').trim() || 'mesh';
  let free = plain;
  for (let number = 2; taken.has(free); ++number) free = `${plain} ${number}`;
  taken.add(free);
  return free;
}

interface ObjContext {
  counts: { positions: number; uvs: number; normals: number };
  materials: MaterialLibrary;
  name: string;
}

/** Vertices of all primitives of a mesh that have one position and colour are one vertex, as they are in the scene. */
function writeMesh(
  lines: TextPieces,
  { primitives }: FlatMesh,
  { counts, materials, name }: ObjContext,
): void {
  lines.add(`o ${name}`);
  const hasColours = primitives.every(({ colours }) => colours !== null);
  const vertices = primitives.map((primitive) => vertexLines(primitive, hasColours));
  const shared = distinctTexts(vertices.flat());
  lines.addAll(shared.values);
  let first = 0;
  primitives.forEach((primitive, i) => {
    const { material, triangles } = primitive;
    const uvs = distinctTexts(uvLines(primitive));
    const normals = distinctTexts(normalLines(primitive));
    lines.addAll(uvs.values);
    lines.addAll(normals.values);
    // In OBJ a material applies to all faces until the next one is named.
    if (material || primitives.length > 1 || !materials.isEmpty)
      lines.add(`usemtl ${materials.nameOf(material)}`);
    const corner = (v: number) => {
      const position = counts.positions + shared.indices[first + v] + 1;
      const uv = uvs.indices.length > 0 ? String(counts.uvs + uvs.indices[v] + 1) : '';
      if (normals.indices.length > 0) return `${position}/${uv}/${counts.normals + normals.indices[v] + 1}`;
      return uv === '' ? String(position) : `${position}/${uv}`;
    };
    for (let t = 0; t < triangles.length; t += 3)
      lines.add(`f ${corner(triangles[t])} ${corner(triangles[t + 1])} ${corner(triangles[t + 2])}`);
    first += vertices[i].length;
    counts.uvs += uvs.values.length;
    counts.normals += normals.values.length;
  });
  counts.positions += shared.values.length;
}

function vertexLines({ positions, colours }: FlatPrimitive, hasColours: boolean): string[] {
  return Array.from({ length: positions.length / 3 }, (_, v) => {
    const colour = hasColours
      ? [0, 1, 2].map((c) => ` ${shortest(toSrgb(colours![3 * v + c]))}`).join('')
      : '';
    return `v ${tuple(positions, v, 3)}${colour}`;
  });
}

const uvLines = ({ uvs }: FlatPrimitive): string[] =>
  uvs
    ? Array.from(
        { length: uvs.length / 2 },
        (_, v) => `vt ${shortest(uvs[2 * v])} ${shortest(1 - uvs[2 * v + 1])}`,
      )
    : [];

const normalLines = ({ normals }: FlatPrimitive): string[] =>
  normals ? Array.from({ length: normals.length / 3 }, (_, v) => `vn ${tuple(normals, v, 3)}`) : [];

const tuple = (values: Float32Array, v: number, size: number): string =>
  Array.from({ length: size }, (_, c) => shortest(values[size * v + c])).join(' ');
