/** Reads OFF: polygons, with normals (NOFF), colours (COFF) and UVs (STOFF) of vertices. Text only. */

import { counted } from '../core/words';
import { GrowingFloats, GrowingIndices } from './growing';
import type { SourceFile } from './model';
import { describeTooLarge, trianglesOfPolygon } from './polygon';
import type { SurfaceFile } from './surface';
import { excerpt, TextScanner } from './text_scanner';
import { attributesOfRaw } from './vertex_values';

const HASH = 35;
/** The keyword, which names the vertex attributes in the order of their values. */
const KEYWORD = /^(ST)?(C)?(N)?OFF$/;
/** The same with a fourth coordinate or any number of them. */
const HIGHER = /^(ST)?C?N?(4n?|n)OFF$/;

interface OffKind {
  hasUvs: boolean;
  hasColours: boolean;
  hasNormals: boolean;
}

interface OffVertices {
  positions: Float32Array;
  normals: Float32Array;
  colours: Float32Array;
  uvs: Float32Array;
}

/** Throws an Error that names the line. */
export function readOff(file: SourceFile): SurfaceFile {
  const scan = new TextScanner(file.name, file.bytes);
  const kind = readKind(file.name, scan);
  const [vertexCount, faceCount] = readCounts(scan);
  const vertices = readVertices(scan, kind, vertexCount);
  const { indices, polygons, hasColours } = readFaces(scan, vertices.positions, faceCount);
  if (indices.length === 0) throw new Error(`${file.name} has no faces: export it as a mesh with faces.`);
  const notes =
    polygons > 0 ? [`${counted(polygons, 'polygon')} with more than three corners cut into triangles`] : [];
  const name = file.name.replace(/^.*[/\\]/, '').replace(/\.[^.]*$/, '');
  const raw = {
    ...(kind.hasNormals ? { normals: vertices.normals } : {}),
    ...(kind.hasUvs ? { uvs: vertices.uvs } : {}),
    ...(kind.hasColours ? { colours: inUnits(vertices.colours) } : {}),
  };
  const surface = {
    name,
    positions: vertices.positions,
    indices,
    attributes: attributesOfRaw(raw, indices),
    notes,
  };
  return { surfaces: [surface], notes: [], unread: hasColours ? ['colours of faces'] : [] };
}

/** Whether the text starts with a keyword of the format. */
export const isOff = (start: string): boolean => /^\s*(#[^\n]*\n\s*)*(ST)?C?N?(4n?|n)?OFF\b/.test(start);

function readKind(name: string, scan: TextScanner): OffKind {
  seek(scan);
  const start = scan.at;
  const word = scan.word();
  if (HIGHER.test(word)) throw new Error(`${name} has more than three dimensions: export it in three.`);
  const found = KEYWORD.exec(word);
  if (!found) {
    // The keyword may be left out; then the counts come first.
    if (!/^\d+$/.test(word))
      throw new Error(
        `${name} is not OFF (it starts with "${excerpt(word)}"): check that it is a mesh file.`,
      );
    scan.at = start;
    return { hasUvs: false, hasColours: false, hasNormals: false };
  }
  if (scan.seekWord() && /^BINARY$/i.test(peekWord(scan)))
    throw new Error(`${name} is binary OFF, which cannot be read: export it as text.`);
  return {
    hasUvs: found[1] !== undefined,
    hasColours: found[2] !== undefined,
    hasNormals: found[3] !== undefined,
  };
}

function peekWord(scan: TextScanner): string {
  const start = scan.at;
  const word = scan.word();
  scan.at = start;
  return word;
}

/** Goes to the next word, past comments. Throws an Error at the end of the file. */
function seek(scan: TextScanner): void {
  while (scan.seekWordAnywhere()) {
    if (scan.peek() !== HASH) return;
    scan.nextLine();
  }
  scan.fail('the file ends too early: export it again');
}

/** Whether another value follows on this line. */
const hasMore = (scan: TextScanner): boolean => scan.seekWord() && scan.peek() !== HASH;

/** The counts of vertices and faces; that of edges is unused, and often left out. */
function readCounts(scan: TextScanner): [number, number] {
  const counts = ['vertices', 'faces'].map((what) => {
    seek(scan);
    const count = scan.number(`the number of ${what}`);
    if (!Number.isSafeInteger(count) || count < 0) scan.fail(`${count} is not a number of ${what}`);
    return count;
  });
  scan.nextLine();
  return [counts[0], counts[1]];
}

function readVertices(scan: TextScanner, kind: OffKind, count: number): OffVertices {
  const [positions, normals, colours] = [new GrowingFloats(), new GrowingFloats(), new GrowingFloats()];
  const uvs = new GrowingFloats();
  for (let v = 0; v < count; ++v) {
    seek(scan);
    const at = ['x', 'y', 'z'].map((axis) => Math.fround(scan.number(axis)));
    if (!at.every(Number.isFinite)) scan.fail('a coordinate is too large for a 32-bit number');
    positions.push3(at[0], at[1], at[2]);
    const values: number[] = [];
    while (hasMore(scan)) values.push(scan.numberOrNaN());
    scan.nextLine();
    const next = (size: number, from: 'start' | 'end' = 'start'): number[] =>
      from === 'start' ? values.splice(0, size) : values.splice(Math.max(0, values.length - size), size);
    if (kind.hasNormals) normals.push3(...triple(next(3)));
    if (kind.hasUvs) uvs.push2(...pair(next(2, 'end')));
    // A fourth value is opacity.
    if (kind.hasColours) colours.push3(...triple(next(4)));
  }
  return {
    positions: positions.finish(),
    normals: normals.finish(),
    colours: colours.finish(),
    uvs: uvs.finish(),
  };
}

const triple = ([x = NaN, y = NaN, z = NaN]: number[]): [number, number, number] => [x, y, z];
const pair = ([u = NaN, v = NaN]: number[]): [number, number] => [u, v];

/** Colours scaled to [0, 1]: files have them in that range, or as whole numbers up to 255. */
function inUnits(colours: Float32Array): Float32Array {
  return colours.some((value) => value > 1) ? colours.map((value) => value / 255) : colours;
}

function readFaces(
  scan: TextScanner,
  positions: Float32Array,
  count: number,
): { indices: Uint32Array; polygons: number; hasColours: boolean } {
  const indices = new GrowingIndices();
  let [polygons, hasColours] = [0, false];
  for (let face = 0; face < count; ++face) {
    const corners = readPolygon(scan, positions.length / 3, face);
    hasColours ||= hasMore(scan);
    scan.nextLine();
    if (corners.length > 3) polygons += 1;
    const triangles = trianglesOfPolygon(corners, positions);
    if (triangles === null) scan.fail(describeTooLarge(corners.length));
    for (const vertex of triangles ?? []) indices.push(vertex);
  }
  return { indices: indices.finish(), polygons, hasColours };
}

function readPolygon(scan: TextScanner, vertexCount: number, face: number): number[] {
  seek(scan);
  const length = scan.number('the number of corners');
  if (!Number.isSafeInteger(length) || length < 0) scan.fail(`${length} is not a number of corners`);
  const corners: number[] = [];
  for (let i = 0; i < length; ++i) {
    seek(scan);
    const vertex = scan.number('a corner');
    if (!Number.isInteger(vertex) || vertex < 0 || vertex >= vertexCount)
      scan.fail(
        `face ${face} names vertex ${vertex}, but vertices go from 0 to ${vertexCount - 1}: export it again`,
      );
    corners.push(vertex);
  }
  return corners;
}
