/** Wavefront OBJ: `v` and `f` (polygons too); every `o` is a body, groups belong to their object. */

import { GrowingFloats, GrowingIndices } from './growing';
import { counted } from './model';
import type { SourceFile } from './model';
import { triangulatePolygon } from './polygon';
import type { Surface, SurfaceFile } from './surface';
import { excerpt, TextScanner } from './text_scanner';

const SLASH = 47;

/** What else the format knows; lines of the first kind carry something that is not taken along. */
const UNREAD: Record<string, string> = { vt: 'UV coordinates', usemtl: 'materials' };
const KNOWN = new Set(
  'vn g s mtllib p l o # mg lod cstype deg surf curv curv2 end parm vp usemap'.split(' '),
);
const LINES_AND_POINTS = new Set(['l', 'p']);

interface ObjectFaces {
  name: string;
  indices: GrowingIndices;
  polygons: number;
  shortFaces: number;
}

/** What is gathered on the way through the file. */
interface Reading {
  scan: TextScanner;
  positions: GrowingFloats;
  objects: Map<string, ObjectFaces>;
  object: ObjectFaces;
  unread: Set<string>;
  linesAndPoints: number;
  /** the highest vertex number that did not exist yet where a face named it */
  ahead: { vertex: number; line: number } | null;
  stranger: { text: string; line: number; count: number } | null;
}

/** Throws an Error that names the line. Vertex colours and weights after the coordinates are passed over. */
export function readObj(file: SourceFile): SurfaceFile {
  const reading = startReading(file);
  const { scan } = reading;
  while (!scan.atEnd) {
    const word = scan.word();
    if (word === 'v') readVertex(reading);
    else if (word === 'f') readFace(reading);
    else if (word === 'o') reading.object = objectNamed(reading.objects, scan.rest());
    else if (word !== '') readOther(reading, word);
    scan.nextLine();
  }
  const objects = [...reading.objects.values()].filter((object) => object.indices.length > 0);
  checkReading(file.name, reading, objects.length);
  const surfaces = objects.map((object) => surfaceOf(object, reading.positions, objects.length > 1));
  return { surfaces, notes: notesOf(reading), unread: [...reading.unread] };
}

function startReading(file: SourceFile): Reading {
  const objects = new Map<string, ObjectFaces>();
  const stem = file.name.replace(/^.*[/\\]/, '').replace(/\.[^.]*$/, '');
  return {
    scan: new TextScanner(file.name, file.bytes),
    positions: new GrowingFloats(),
    objects,
    object: objectNamed(objects, stem),
    unread: new Set(),
    linesAndPoints: 0,
    ahead: null,
    stranger: null,
  };
}

function objectNamed(objects: Map<string, ObjectFaces>, name: string): ObjectFaces {
  const known = objects.get(name);
  if (known) return known;
  const object = { name, indices: new GrowingIndices(), polygons: 0, shortFaces: 0 };
  objects.set(name, object);
  return object;
}

function readVertex({ scan, positions }: Reading): void {
  const x = Math.fround(scan.number('x'));
  const y = Math.fround(scan.number('y'));
  const z = Math.fround(scan.number('z'));
  if (!Number.isFinite(x + y + z)) scan.fail('a coordinate is too large for a 32-bit number');
  positions.push3(x, y, z);
}

function readFace(reading: Reading): void {
  const { scan, object, positions } = reading;
  const corners: number[] = [];
  let count = 0;
  for (; scan.seekWord(); ++count) {
    const corner = readCorner(reading);
    // A repeated neighbour adds nothing to a polygon; the triangle rule below still counts it as degenerate.
    if (corner !== corners[corners.length - 1]) corners.push(corner);
  }
  while (corners.length > 1 && corners[0] === corners[corners.length - 1]) corners.pop();
  if (count < 3) object.shortFaces += 1;
  if (count > 3) object.polygons += 1;
  if (corners.length === 0) return;
  while (corners.length < 3) corners.push(corners[corners.length - 1]);
  const isReady = reading.ahead === null;
  const triangles = isReady ? triangulatePolygon(corners, positions.view()) : fanOf(corners);
  for (const corner of triangles) object.indices.push(corner);
}

/** Where vertices come after their faces, polygons cannot be looked at yet. */
function fanOf(corners: number[]): number[] {
  return corners.slice(2).flatMap((corner, i) => [corners[0], corners[i + 1], corner]);
}

/** Reads `v`, `v/vt`, `v//vn` or `v/vt/vn` and returns the vertex index from 0. */
function readCorner(reading: Reading): number {
  const { scan, positions } = reading;
  const count = positions.length / 3;
  const start = scan.at;
  const number = scan.integer();
  const isCorner = scan.peek() === SLASH || scan.peek() <= 32;
  if (Number.isNaN(number) || !isCorner) {
    scan.at = start;
    scan.fail(`the corner "${excerpt(scan.word())}" is not a vertex number`);
  }
  if (scan.peek() === SLASH) scan.word();
  if (number === 0) scan.fail('a face names vertex 0, but vertices are numbered from 1');
  if (number < -count) scan.fail(`a face names vertex ${number}, but only ${count} come before it`);
  if (number > count && number > (reading.ahead?.vertex ?? 0))
    reading.ahead = { vertex: number, line: scan.line };
  return number > 0 ? number - 1 : count + number;
}

function readOther(reading: Reading, word: string): void {
  if (word in UNREAD) reading.unread.add(UNREAD[word]);
  else if (LINES_AND_POINTS.has(word)) reading.linesAndPoints += 1;
  else if (!KNOWN.has(word) && !word.startsWith('#')) {
    const { scan, stranger } = reading;
    if (stranger) stranger.count += 1;
    else reading.stranger = { text: `${word} ${scan.rest()}`.trim(), line: scan.line, count: 1 };
  }
}

function checkReading(name: string, { positions, ahead, stranger }: Reading, objectCount: number): void {
  const count = positions.length / 3;
  if (ahead && ahead.vertex > count)
    throw new Error(
      `${name}, line ${ahead.line}: a face names vertex ${ahead.vertex}, but the file has ${count}: export it again.`,
    );
  if (objectCount > 0) return;
  if (stranger)
    throw new Error(
      `${name}, line ${stranger.line}: "${excerpt(stranger.text)}" is not OBJ, and the file has no faces: is it a mesh?`,
    );
  const what = count > 0 ? `${counted(count, 'vertex', 'vertices')} but no faces` : 'no faces';
  throw new Error(`${name} has ${what}: export it as a mesh with faces.`);
}

function surfaceOf(object: ObjectFaces, positions: GrowingFloats, isOneOfMany: boolean): Surface {
  const notes: string[] = [];
  if (object.polygons > 0)
    notes.push(`${counted(object.polygons, 'polygon')} with more than three corners cut into triangles`);
  if (object.shortFaces > 0)
    notes.push(`${counted(object.shortFaces, 'face')} with fewer than three corners`);
  const indices = object.indices.finish();
  const used = isOneOfMany ? compact(positions.view(), indices) : positions.finish();
  return { name: object.name, positions: used, indices, notes };
}

/** The positions that `indices` name, in order of first use; renumbers `indices` in place. */
function compact(positions: Float32Array, indices: Uint32Array): Float32Array {
  const renumbered = new Map<number, number>();
  const used = new GrowingFloats();
  indices.forEach((vertex, corner) => {
    let place = renumbered.get(vertex);
    if (place === undefined) {
      place = renumbered.size;
      renumbered.set(vertex, place);
      used.push3(positions[3 * vertex], positions[3 * vertex + 1], positions[3 * vertex + 2]);
    }
    indices[corner] = place;
  });
  return used.finish();
}

function notesOf({ linesAndPoints, stranger }: Reading): string[] {
  const notes: string[] = [];
  if (linesAndPoints > 0)
    notes.push(`${counted(linesAndPoints, 'line or point', 'lines and points')} skipped`);
  if (stranger)
    notes.push(`${counted(stranger.count, 'unknown line')} skipped, the first is line ${stranger.line}`);
  return notes;
}
