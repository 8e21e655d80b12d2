/**
 * Reads Wavefront OBJ: polygons with UVs and normals, and vertex colours. Every `o` is a body, groups belong to their
 * object, and each `usemtl` name of an object is a primitive.
 */

import { NONE } from '../core/core';
import { GrowingFloats } from './growing';
import { counted } from '../core/words';
import type { SourceFile } from './model';
import { ObjCorners, splitVertices } from './obj_corners';
import { describeTooLarge, triangulatePolygon } from './polygon';
import type { Surface, SurfaceFile } from './surface';
import { excerpt, TextScanner } from './text_scanner';
import { attributesOfRaw } from './vertex_values';

const SLASH = 47;

/** Further keywords of the format, which are skipped. */
const KNOWN = new Set('g s p l o # mg lod cstype deg surf curv curv2 end parm vp usemap'.split(' '));
const LINES_AND_POINTS = new Set(['l', 'p']);

interface ObjectFaces {
  name: string;
  /** corners by the name of their material; '' stands for none */
  parts: Map<string, ObjCorners>;
  polygons: number;
  shortFaces: number;
}

/** Indices from 0; NONE for a missing UV or normal. */
interface FaceCorner {
  vertex: number;
  uv: number;
  normal: number;
}

/** The state of reading a file. */
interface Reading {
  scan: TextScanner;
  positions: GrowingFloats;
  uvs: GrowingFloats;
  normals: GrowingFloats;
  /** sRGB; NaN for vertices without one before the last that has one; used in objects of which every vertex has one */
  colours: GrowingFloats;
  objects: Map<string, ObjectFaces>;
  object: ObjectFaces;
  material: string;
  libraries: string[];
  linesAndPoints: number;
  /** the highest vertex number that a face named before its vertex line, and the line of that face */
  ahead: { vertex: number; line: number } | null;
  /** the first unknown line, and the number of all unknown lines */
  unknownLines: { text: string; line: number; count: number } | null;
}

/** Throws an Error that names the line. Weights after the coordinates are skipped. */
export function readObj(file: SourceFile): SurfaceFile {
  const reading = startReading(file);
  const { scan } = reading;
  while (!scan.atEnd) {
    readLine(reading, scan.word());
    scan.nextLine();
  }
  const objects = [...reading.objects.values()].filter(hasFaces);
  checkReading(file.name, reading, objects.length);
  const surfaces = objects.map((object) => surfaceOf(object, reading, objects.length > 1));
  return { surfaces, notes: notesOf(reading), unread: [], libraries: [...new Set(reading.libraries)] };
}

function readLine(reading: Reading, word: string): void {
  const { scan } = reading;
  if (word === 'v') readVertex(reading);
  else if (word === 'vt') reading.uvs.push2(scan.numberOrNaN(), scan.seekWord() ? scan.numberOrNaN() : 0);
  else if (word === 'vn') reading.normals.push3(scan.numberOrNaN(), scan.numberOrNaN(), scan.numberOrNaN());
  else if (word === 'f') readFace(reading);
  else if (word === 'o') reading.object = objectNamed(reading.objects, scan.rest());
  else if (word === 'usemtl') reading.material = scan.rest();
  else if (word === 'mtllib') reading.libraries.push(scan.rest());
  else if (word !== '') readOther(reading, word);
}

const hasFaces = ({ parts }: ObjectFaces): boolean =>
  [...parts.values()].some(({ vertices }) => vertices.length > 0);

function startReading(file: SourceFile): Reading {
  const objects = new Map<string, ObjectFaces>();
  const stem = file.name.replace(/^.*[/\\]/, '').replace(/\.[^.]*$/, '');
  return {
    scan: new TextScanner(file.name, file.bytes),
    positions: new GrowingFloats(),
    uvs: new GrowingFloats(),
    normals: new GrowingFloats(),
    colours: new GrowingFloats(),
    objects,
    object: objectNamed(objects, stem),
    material: '',
    libraries: [],
    linesAndPoints: 0,
    ahead: null,
    unknownLines: null,
  };
}

function objectNamed(objects: Map<string, ObjectFaces>, name: string): ObjectFaces {
  const known = objects.get(name);
  if (known) return known;
  const object = { name, parts: new Map<string, ObjCorners>(), polygons: 0, shortFaces: 0 };
  objects.set(name, object);
  return object;
}

function readVertex({ scan, positions, colours }: Reading): void {
  const x = Math.fround(scan.number('x'));
  const y = Math.fround(scan.number('y'));
  const z = Math.fround(scan.number('z'));
  if (!Number.isFinite(x + y + z)) scan.fail('a coordinate is too large for a 32-bit number');
  positions.push3(x, y, z);
  if (!scan.seekWord()) return;
  // A single number after the coordinates is a weight.
  const [red, green, blue] = [scan.numberOrNaN(), scan.numberOrNaN(), scan.numberOrNaN()];
  if (Number.isNaN(blue)) return;
  while (colours.length < positions.length - 3) colours.push3(NaN, NaN, NaN);
  colours.push3(red, green, blue);
}

function readFace(reading: Reading): void {
  const { scan, object } = reading;
  const corners: FaceCorner[] = [];
  let count = 0;
  for (; scan.seekWord(); ++count) {
    const corner = readCorner(reading);
    // A repeated corner adds nothing to a polygon; the padding below still makes it a degenerate triangle.
    if (corner.vertex !== corners.at(-1)?.vertex) corners.push(corner);
  }
  while (corners.length > 1 && corners[0].vertex === corners[corners.length - 1].vertex) corners.pop();
  if (count < 3) object.shortFaces += 1;
  if (count > 3) object.polygons += 1;
  if (corners.length === 0) return;
  while (corners.length < 3) corners.push(corners[corners.length - 1]);
  const part = partOf(object, reading.material);
  for (const i of trianglesOf(corners, reading))
    part.push(corners[i].vertex, corners[i].uv, corners[i].normal);
}

function partOf({ parts }: ObjectFaces, material: string): ObjCorners {
  const known = parts.get(material);
  if (known) return known;
  const part = new ObjCorners();
  parts.set(material, part);
  return part;
}

/** Index triples into `corners`. If vertices come after their faces, their positions are not known yet and polygons become fans. */
function trianglesOf(corners: FaceCorner[], { scan, ahead, positions }: Reading): number[] {
  if (corners.length === 3) return [0, 1, 2];
  const numbers = corners.map((_, i) => i);
  if (ahead !== null) return numbers.slice(2).flatMap((i) => [0, i - 1, i]);
  const all = positions.view();
  const cornerPositions = Float32Array.from(
    { length: 3 * corners.length },
    (_, i) => all[3 * corners[Math.floor(i / 3)].vertex + (i % 3)],
  );
  return triangulatePolygon(numbers, cornerPositions) ?? scan.fail(describeTooLarge(corners.length));
}

/** Reads `v`, `v/vt`, `v//vn` or `v/vt/vn`. */
function readCorner(reading: Reading): FaceCorner {
  const { scan, positions, uvs, normals } = reading;
  const count = positions.length / 3;
  const start = scan.at;
  const number = scan.integer();
  const isCorner = scan.peek() === SLASH || scan.peek() <= 32;
  if (Number.isNaN(number) || !isCorner) {
    scan.at = start;
    scan.fail(`the corner "${excerpt(scan.word())}" is not a vertex number`);
  }
  const uv = readReference(scan, uvs.length / 2);
  const normal = readReference(scan, normals.length / 3);
  // Skip the rest of the corner.
  if (scan.peek() > 32) scan.word();
  if (number === 0) scan.fail('a face names vertex 0, but vertices are numbered from 1');
  if (number < -count) scan.fail(`a face names vertex ${number}, but only ${count} come before it`);
  if (number > count && number > (reading.ahead?.vertex ?? 0))
    reading.ahead = { vertex: number, line: scan.line };
  return { vertex: number > 0 ? number - 1 : count + number, uv, normal };
}

/** Reads a slash and the number of a UV or normal, of which `count` were read so far. Returns NONE if there is no number. */
function readReference(scan: TextScanner, count: number): number {
  if (scan.peek() !== SLASH) return NONE;
  scan.at += 1;
  const number = scan.integer();
  if (number > 0) return number - 1;
  return number < 0 && -number <= count ? count + number : NONE;
}

function readOther(reading: Reading, word: string): void {
  if (LINES_AND_POINTS.has(word)) reading.linesAndPoints += 1;
  else if (!KNOWN.has(word) && !word.startsWith('#')) {
    const { scan, unknownLines } = reading;
    if (unknownLines) unknownLines.count += 1;
    else reading.unknownLines = { text: `${word} ${scan.rest()}`.trim(), line: scan.line, count: 1 };
  }
}

function checkReading(name: string, { positions, ahead, unknownLines }: Reading, objectCount: number): void {
  const count = positions.length / 3;
  if (ahead && ahead.vertex > count)
    throw new Error(
      `${name}, line ${ahead.line}: a face names vertex ${ahead.vertex}, but the file has ${count}: export it again.`,
    );
  if (objectCount > 0) return;
  if (unknownLines)
    throw new Error(
      `${name}, line ${unknownLines.line}: "${excerpt(unknownLines.text)}" is not OBJ, and the file has no faces: check that it is a mesh file.`,
    );
  const what = count > 0 ? `${counted(count, 'vertex', 'vertices')} but no faces` : 'no faces';
  throw new Error(`${name} has ${what}: export it as a mesh with faces.`);
}

function surfaceOf(object: ObjectFaces, reading: Reading, isOneOfMany: boolean): Surface {
  const notes: string[] = [];
  if (object.polygons > 0)
    notes.push(`${counted(object.polygons, 'polygon')} with more than three corners cut into triangles`);
  if (object.shortFaces > 0)
    notes.push(`${counted(object.shortFaces, 'face')} with fewer than three corners`);
  const used = [...object.parts].filter(([, { vertices }]) => vertices.length > 0);
  const corners = used.map(([, part]) => part);
  const { positions, uvs, normals, colours } = reading;
  const { vertexOf, uvOf, normalOf, indices } = splitVertices(corners, positions.length / 3, isOneOfMany);
  const hasUvs = indices.some((v) => uvOf[v] !== NONE);
  const hasNormals = indices.every((v) => normalOf[v] !== NONE);
  const hasColours = vertexOf.every((v) => 3 * v < colours.length && !Number.isNaN(colours.at(3 * v + 2)));
  const raw = {
    ...(hasUvs ? { uvs: pick(uvs.view(), uvOf, 2) } : {}),
    ...(hasNormals ? { normals: pick(normals.view(), normalOf, 3) } : {}),
    ...(hasColours ? { colours: pick(colours.view(), vertexOf, 3) } : {}),
  };
  let first = 0;
  const parts = used.map(([material, { vertices }]) => {
    const part = { material, first };
    first += vertices.length / 3;
    return part;
  });
  const vertexPositions = pick(positions.view(), vertexOf, 3);
  return {
    name: object.name,
    positions: vertexPositions,
    indices,
    attributes: attributesOfRaw(raw, indices),
    parts,
    notes,
  };
}

/** The values of the elements `which`; 0 for NONE and for elements that do not exist. */
function pick(values: Float32Array, which: Uint32Array, size: number): Float32Array {
  const picked = new Float32Array(size * which.length);
  which.forEach((from, to) => {
    if (size * from + size > values.length) return;
    for (let c = 0; c < size; ++c) picked[size * to + c] = values[size * from + c];
  });
  return picked;
}

function notesOf({ linesAndPoints, unknownLines }: Reading): string[] {
  const notes: string[] = [];
  if (linesAndPoints > 0)
    notes.push(`${counted(linesAndPoints, 'line or point', 'lines and points')} skipped`);
  if (unknownLines)
    notes.push(
      `${counted(unknownLines.count, 'unknown line')} skipped, the first is line ${unknownLines.line}`,
    );
  return notes;
}
