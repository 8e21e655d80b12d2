/**
 * Reads PLY, as text or binary in either byte order, as one body: vertices with normals, UVs, colours and opacities, faces with any
 * number of corners, and triangle strips.
 */

import { GrowingIndices } from './growing';
import { counted } from '../core/words';
import type { SourceFile } from './model';
import { readPlyHeader } from './ply_header';
import type { PlyElement, PlyHeader, PlyProperty, PlyType } from './ply_header';
import { describeTooLarge, trianglesOfPolygon } from './polygon';
import type { SurfaceFile } from './surface';
import { excerpt, TextScanner } from './text_scanner';
import { attributesOfRaw } from './vertex_values';
import type { RawAttributes } from './vertex_values';

const INDEX_LISTS = ['vertex_indices', 'vertex_index'];
/** Properties of faces that are skipped, in plain words. */
const UNREAD: Record<string, string> = { texcoord: 'UV coordinates of faces', red: 'colours of faces' };

/** The array of each kind of vertex property; names[c] matches the property of component c. */
const COLUMNS: { key: 'positions' | keyof RawAttributes; names: RegExp[] }[] = [
  { key: 'positions', names: [/^x$/, /^y$/, /^z$/] },
  { key: 'normals', names: [/^nx$/, /^ny$/, /^nz$/] },
  { key: 'uvs', names: [/^(s|u|texture_u)$/, /^(t|v|texture_v)$/] },
  { key: 'colours', names: [/^(diffuse_)?red$/, /^(diffuse_)?green$/, /^(diffuse_)?blue$/] },
  { key: 'opacities', names: [/^(diffuse_)?alpha$/] },
];

/** The integer that stands for a full colour or opacity in each type. */
const FULL: Partial<Record<PlyType, number>> = { uint8: 255, int8: 127, uint16: 65535, int16: 32767 };

/** The destination of a property: vertex `row` is written to values[size * row + component], times `scale`. */
interface Column {
  values: Float32Array;
  size: number;
  component: number;
  scale: number;
  isPosition: boolean;
}

/** Reads value after value from either encoding. */
interface ValueSource {
  read(type: PlyType): number;
  /** NaN if a text has no finite number */
  readLoosely(type: PlyType): number;
  skip(type: PlyType): void;
  fail(problem: string): never;
}

/** The content read so far: polygons are stored as their corner counts and one list of all corners. */
interface PlyContent {
  positions: Float32Array;
  attributes: RawAttributes;
  cornerCounts: GrowingIndices;
  corners: GrowingIndices;
}

/** Throws an Error that names the line, or the element and its number. */
export function readPly(file: SourceFile): SurfaceFile {
  const header = readPlyHeader(file);
  const source = header.encoding === 'ascii' ? textSource(file, header) : binarySource(file, header);
  const vertexCount = header.elements.find((element) => element.name === 'vertex')?.count ?? 0;
  for (const element of header.elements) {
    checkElement(source, element);
    checkCount(source, element, file.bytes.length - header.bodyAt);
  }
  const content: PlyContent = {
    positions: new Float32Array(3 * vertexCount),
    attributes: emptyAttributes(header, vertexCount),
    cornerCounts: new GrowingIndices(),
    corners: new GrowingIndices(),
  };
  for (const element of header.elements) readElement(source, element, content);
  if (content.cornerCounts.length === 0) {
    const what = vertexCount > 0 ? `${counted(vertexCount, 'vertex', 'vertices')} but no faces` : 'no faces';
    throw new Error(`${file.name} has ${what}: export it as a mesh with faces.`);
  }
  const name = file.name.replace(/^.*[/\\]/, '').replace(/\.[^.]*$/, '');
  const { indices, polygons } = triangulate(file.name, content);
  const notes =
    polygons > 0 ? [`${counted(polygons, 'polygon')} with more than three corners cut into triangles`] : [];
  const attributes = attributesOfRaw(content.attributes, indices);
  const surface = { name, positions: content.positions, indices, attributes, notes };
  return { surfaces: [surface], notes: [], unread: unreadOf(header) };
}

const isCorners = (element: PlyElement, { name }: PlyProperty): boolean =>
  (element.name === 'face' || element.name === 'tristrips') && INDEX_LISTS.includes(name);

/** Vertices need three coordinates, and the corners of faces are lists. */
function checkElement(source: ValueSource, element: PlyElement): void {
  const { name, properties } = element;
  const missing = ['x', 'y', 'z'].find((axis) => properties.every((property) => property.name !== axis));
  if (name === 'vertex' && missing) source.fail(`vertices have no ${missing}: export it again`);
  const single = properties.find((property) => isCorners(element, property) && !property.countType);
  if (single) source.fail(`"${single.name}" of faces is not a list: export it again`);
}

/** Refuses counts that the file is too short for, at one byte a value, so that a wrong count cannot ask for endless memory or time. */
function checkCount(source: ValueSource, { name, count, properties }: PlyElement, bytes: number): void {
  if (count * Math.max(1, properties.length) > bytes)
    source.fail(`${count} entries of "${excerpt(name)}" do not fit into the file: export it again`);
}

function unreadOf({ elements }: PlyHeader): string[] {
  const faces = elements.filter((element) => element.name === 'face');
  const names = faces.flatMap((element) => element.properties.map((property) => property.name));
  return names.filter((name) => Object.hasOwn(UNREAD, name)).map((name) => UNREAD[name]);
}

/** Zeroed arrays for the kinds of attributes whose components all occur among the vertex properties. */
function emptyAttributes({ elements }: PlyHeader, vertexCount: number): RawAttributes {
  const vertex = elements.find((element) => element.name === 'vertex');
  const has = (name: RegExp) => vertex?.properties.some((property) => name.test(property.name));
  const found = COLUMNS.filter(({ key, names }) => key !== 'positions' && names.every(has));
  return Object.fromEntries(
    found.map(({ key, names }) => [key, new Float32Array(names.length * vertexCount)]),
  );
}

function columnOf(
  { name, type, countType }: PlyProperty,
  { positions, attributes }: PlyContent,
): Column | null {
  if (countType) return null;
  for (const { key, names } of COLUMNS) {
    const component = names.findIndex((pattern) => pattern.test(name));
    const values = key === 'positions' ? positions : attributes[key];
    if (component < 0 || !values) continue;
    const scale = key === 'colours' || key === 'opacities' ? 1 / (FULL[type] ?? 1) : 1;
    return { values, size: names.length, component, scale, isPosition: key === 'positions' };
  }
  return null;
}

function readElement(source: ValueSource, element: PlyElement, content: PlyContent): void {
  const { name, count, properties } = element;
  const columns = properties.map((property) => (name === 'vertex' ? columnOf(property, content) : null));
  const isFace = properties.map((property) => isCorners(element, property));
  for (let row = 0; row < count; ++row)
    for (let i = 0; i < properties.length; ++i) {
      const [property, column] = [properties[i], columns[i]];
      if (column?.isPosition)
        column.values[3 * row + column.component] = readCoordinate(source, property, row);
      else if (column)
        column.values[column.size * row + column.component] =
          column.scale * source.readLoosely(property.type);
      else if (!isFace[i]) skipProperty(source, property);
      else if (name === 'face') readPolygon(source, property, content);
      else readStrips(source, property, content);
    }
}

function readCoordinate(source: ValueSource, { name, type }: PlyProperty, row: number): number {
  const value = Math.fround(source.read(type));
  if (!Number.isFinite(value)) source.fail(`${name} of vertex ${row} is not a finite 32-bit number`);
  return value;
}

function skipProperty(source: ValueSource, { type, countType }: PlyProperty): void {
  const count = countType ? readLength(source, countType) : 1;
  for (let i = 0; i < count; ++i) source.skip(type);
}

function readLength(source: ValueSource, type: PlyType): number {
  const length = source.read(type);
  if (!Number.isInteger(length) || length < 0) source.fail(`${length} is not the length of a list`);
  return length;
}

function readPolygon(source: ValueSource, { type, countType }: PlyProperty, content: PlyContent): void {
  const count = readLength(source, countType!);
  for (let i = 0; i < count; ++i) content.corners.push(source.read(type));
  content.cornerCounts.push(count);
}

/** Reads strips of triangles, each ended by a negative index; every second triangle is reversed. */
function readStrips(source: ValueSource, { type, countType }: PlyProperty, content: PlyContent): void {
  const count = readLength(source, countType!);
  let [older, newer, length] = [0, 0, 0];
  for (let i = 0; i < count; ++i) {
    const vertex = source.read(type);
    if (vertex >= 0 && ++length > 2) {
      const isTurned = length % 2 === 0;
      content.corners.push(isTurned ? newer : older);
      content.corners.push(isTurned ? older : newer);
      content.corners.push(vertex);
      content.cornerCounts.push(3);
    }
    if (vertex < 0) length = 0;
    [older, newer] = [newer, vertex];
  }
}

/** Index triples of all polygons, and the number of polygons with more than three corners. */
function triangulate(file: string, { positions, cornerCounts, corners }: PlyContent) {
  const counts = cornerCounts.finish();
  const flat = corners.finish();
  const vertexCount = positions.length / 3;
  const indices = new GrowingIndices();
  let polygons = 0;
  for (let face = 0, first = 0; face < counts.length; first += counts[face], ++face) {
    const polygon = Array.from(flat.subarray(first, first + counts[face]));
    for (const vertex of polygon)
      if (vertex >= vertexCount)
        throw new Error(
          `${file}, face ${face}: it names vertex ${vertex | 0}, but vertices go from 0 to ${vertexCount - 1}: export it again.`,
        );
    if (polygon.length > 3) polygons += 1;
    const triangles = trianglesOfPolygon(polygon, positions);
    if (triangles === null) throw new Error(`${file}, face ${face}: ${describeTooLarge(polygon.length)}.`);
    for (const vertex of triangles) indices.push(vertex);
  }
  return { indices: indices.finish(), polygons };
}

function textSource(file: SourceFile, header: PlyHeader): ValueSource {
  const scan = new TextScanner(file.name, file.bytes, header.bodyAt);
  scan.line = header.bodyLine;
  const seek = () => {
    if (!scan.seekWordAnywhere()) scan.fail('the file ends too early: export it again');
  };
  return {
    read: () => {
      seek();
      return scan.number('a value');
    },
    readLoosely: () => {
      seek();
      return scan.numberOrNaN();
    },
    skip: () => {
      seek();
      scan.word();
    },
    fail: (problem) => scan.fail(problem),
  };
}

const SIZES: Record<PlyType, number> = {
  int8: 1,
  uint8: 1,
  int16: 2,
  uint16: 2,
  int32: 4,
  uint32: 4,
  float32: 4,
  float64: 8,
};

function binarySource({ name, bytes }: SourceFile, header: PlyHeader): ValueSource {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const isLittle = header.encoding === 'little';
  let at = header.bodyAt;
  const readers: Record<PlyType, (at: number) => number> = {
    int8: (at) => view.getInt8(at),
    uint8: (at) => view.getUint8(at),
    int16: (at) => view.getInt16(at, isLittle),
    uint16: (at) => view.getUint16(at, isLittle),
    int32: (at) => view.getInt32(at, isLittle),
    uint32: (at) => view.getUint32(at, isLittle),
    float32: (at) => view.getFloat32(at, isLittle),
    float64: (at) => view.getFloat64(at, isLittle),
  };
  const fail = (problem: string): never => {
    throw new Error(`${name}, byte ${at}: ${problem}.`);
  };
  const pass = (type: PlyType): number => {
    const start = at;
    if (start + SIZES[type] > bytes.length) fail('the file ends too early: export it again');
    at += SIZES[type];
    return start;
  };
  const read = (type: PlyType) => readers[type](pass(type));
  return { read, readLoosely: read, skip: pass, fail };
}
