/** What the corners of a body carry besides positions, as simplification needs it: charts, and values that cost. */

import type { Accessor, Document, Primitive } from '@gltf-transform/core';
import { NONE } from '../core/core';
import type { Charts, CornerSources, TriangleMesh, WeldResult } from '../core/core';
import type { Body } from '../document/model';
import { length3 } from '../core/exact_math';
import { findLayers, spanOf } from './layers';
import type { Layers } from './layers';
import { sum, vertexCount } from '../core/mesh';

export interface BodyAttributes {
  /** of the welded mesh; a group is a primitive; empty wedges where there are no attributes */
  charts: Charts;
  /** charts.wedges are below it */
  wedgeCount: number;
  /** every face has its own normals: they follow from the faces and separate no charts */
  isFaceted: boolean;
}

/** The attributes of a body of which only the faces are known. */
export const NO_ATTRIBUTES: BodyAttributes = {
  charts: { wedges: new Uint32Array(), groups: new Uint32Array() },
  wedgeCount: 0,
  isFaceted: false,
};

/** What attributes cost in a collapse, as lengths divided by the bounding diagonal. */
export interface CostAttributes {
  /** values[dimension * wedge + d] */
  values: Float32Array;
  dimension: number;
}

/** A body with more distinct normals per triangle than this is faceted: a smooth one has half a normal, facets have up to three. */
const FACETED = 1.5;
/** The length that a step from black to white counts as, over the diagonal. */
const COLOUR_LENGTH = 0.05;

/** Components [from, to) of an attribute; they are equal at all corners of a wedge. */
interface Compared {
  array: ArrayLike<number>;
  size: number;
  from: number;
  to: number;
}

/** One entry per vertex of each primitive: primitives may share positions and still differ in their other attributes. */
interface Entries {
  primitives: Primitive[];
  /** per primitive its first entry, followed by the number of all entries */
  first: number[];
  /** per corner of the welded mesh */
  ofCorner: Uint32Array;
  /** per triangle of the welded mesh: the number of its primitive in `primitives` */
  spanOfTriangle: Uint32Array;
}

/**
 * Two corners at a welded vertex have the same wedge where all their attributes, joints, weights and displacements are
 * equal. Only the sign of a tangent is compared, because its direction follows from the other attributes.
 */
export function attributesOf(
  document: Document,
  body: Body,
  weld: WeldResult,
  layers: Layers = findLayers(body, weld),
): BodyAttributes {
  const first = attributesOfLayer(entriesOf(document, body, weld), weld);
  if (layers.most === 1) return first;
  const all = [first];
  for (let number = 1; number < layers.most; ++number)
    all.push(attributesOfLayer(entriesOfLayer(document, body, layers, number), weld));
  return { ...joinedCharts(all, layers), isFaceted: first.isFaceted };
}

function attributesOfLayer(entries: Entries, weld: WeldResult): BodyAttributes {
  const isFaceted = countNormals(entries, weld.mesh) > (FACETED * weld.mesh.triangles.length) / 3;
  const lists = entries.primitives.map((primitive) => comparedOf(primitive, !isFaceted));
  const hasAny = lists.some((list) => list.length > 0);
  const { wedges, count } = hasAny
    ? classify(entries, weld.mesh, lists)
    : { wedges: new Uint32Array(), count: 0 };
  const groups = entries.primitives.length > 1 ? entries.spanOfTriangle : new Uint32Array();
  return { charts: { wedges, groups }, wedgeCount: count, isFaceted };
}

/** Corners agree where they agree in every layer; triangles are of one group where all their layers are. */
function joinedCharts(all: BodyAttributes[], { of }: Layers): Pick<BodyAttributes, 'charts' | 'wedgeCount'> {
  const numbered = (keys: string[]): { ids: Uint32Array; count: number } => {
    const known = new Map<string, number>();
    const ids = Uint32Array.from(keys, (key) => {
      if (!known.has(key)) known.set(key, known.size);
      return known.get(key)!;
    });
    return { ids, count: known.size };
  };
  const wedgesOf = all.map(({ charts }) => charts.wedges);
  const groupsOf = all.map(({ charts }) => charts.groups);
  const groups = numbered(
    of.map((layers, t) => layers.map((_, number) => groupsOf[number][t] ?? 0).join(' ')),
  ).ids;
  if (wedgesOf.every(({ length }) => length === 0))
    return { charts: { wedges: new Uint32Array(), groups }, wedgeCount: 0 };
  const keys = Array.from({ length: 3 * of.length }, (_, corner) =>
    of[Math.floor(corner / 3)].map((_layer, number) => wedgesOf[number][corner] ?? 0).join(' '),
  );
  const wedges = numbered(keys);
  return { charts: { wedges: wedges.ids, groups }, wedgeCount: wedges.count };
}

/** UV coordinates and colours of every wedge; null where there are none. UVs count by their length on the surface. */
export function costAttributesOf(
  document: Document,
  body: Body,
  weld: WeldResult,
  { charts: { wedges }, wedgeCount }: BodyAttributes,
  diagonal: number,
): CostAttributes | null {
  if (wedges.length === 0) return null;
  const entries = entriesOf(document, body, weld);
  const texture = gather(entries, wedges, wedgeCount, 'TEXCOORD_0');
  const colour = gather(entries, wedges, wedgeCount, 'COLOR_0');
  const parts = [
    ...(texture ? [{ ...texture, scale: textureScale(weld.mesh, wedges, texture.values) / diagonal }] : []),
    ...(colour ? [{ ...colour, scale: COLOUR_LENGTH }] : []),
  ];
  if (parts.length === 0) return null;
  const dimension = sum(parts.map(({ size }) => size));
  const values = new Float32Array(dimension * wedgeCount);
  let first = 0;
  for (const part of parts) {
    for (let wedge = 0; wedge < wedgeCount; ++wedge)
      for (let d = 0; d < part.size; ++d)
        values[dimension * wedge + first + d] = part.scale * part.values[part.size * wedge + d];
    first += part.size;
  }
  return { values, dimension };
}

/** Translates sources on a welded mesh to sources on the body that it was welded from, whose faces may be wound the other way. */
export function sourcesInBody(
  body: Body,
  weld: WeldResult,
  { triangle, barycentric }: CornerSources,
): CornerSources {
  const isTurned = turnedTriangles(body, weld);
  const shares = barycentric.slice();
  triangle.forEach((t, corner) => {
    if (!isTurned[t]) return;
    shares[3 * corner + 1] = barycentric[3 * corner + 2];
    shares[3 * corner + 2] = barycentric[3 * corner + 1];
  });
  return { triangle: triangle.map((t) => weld.sourceOfTriangle[t]), barycentric: shares };
}

/** The sources of a mesh in which every corner is its own source. */
export function ownSources({ triangles }: TriangleMesh): CornerSources {
  const barycentric = new Float32Array(3 * triangles.length);
  triangles.forEach((_, corner) => (barycentric[3 * corner + (corner % 3)] = 1));
  return { triangle: Uint32Array.from(triangles, (_, corner) => Math.floor(corner / 3)), barycentric };
}

/** The returned function maps a corner 3 t + c of the welded mesh to its corner of the body, an index into Body.indices. */
export function cornerInBody(body: Body, weld: WeldResult): (corner: number) => number {
  const isTurned = turnedTriangles(body, weld);
  return (corner) => {
    const t = Math.floor(corner / 3);
    const k = corner % 3;
    return 3 * weld.sourceOfTriangle[t] + (isTurned[t] && k > 0 ? 3 - k : k);
  };
}

/** Per triangle of the welded mesh: 1 where its second and third corner are swapped in comparison with the body. */
function turnedTriangles(body: Body, { mesh, vertexOfSource, sourceOfTriangle }: WeldResult): Uint8Array {
  return Uint8Array.from(sourceOfTriangle, (source, t) =>
    vertexOfSource[body.indices[3 * source + 1]] === mesh.triangles[3 * t + 1] ? 0 : 1,
  );
}

function entriesOf(document: Document, body: Body, weld: WeldResult): Entries {
  return entriesAt(document, body, weld.sourceOfTriangle, cornerInBody(body, weld));
}

/** Of layer `number`; a triangle without it has its last one. */
function entriesOfLayer(document: Document, body: Body, { of }: Layers, number: number): Entries {
  const layerAt = (t: number) => of[t][Math.min(number, of[t].length - 1)];
  const sources = Uint32Array.from(of, (_, t) => layerAt(t).source);
  return entriesAt(document, body, sources, (corner) => {
    const { source, cornerOf } = layerAt(Math.floor(corner / 3));
    return 3 * source + cornerOf.indexOf(corner % 3);
  });
}

/** `ofBody` maps a corner of the welded mesh to its corner of the body. */
function entriesAt(
  document: Document,
  body: Body,
  sources: Uint32Array,
  ofBody: (corner: number) => number,
): Entries {
  const all = document.getRoot().listMeshes()[body.mesh].listPrimitives();
  const primitives = body.spans.map(({ primitive }) => all[primitive]);
  const first = [0];
  for (const primitive of primitives)
    first.push(first[first.length - 1] + primitive.getAttribute('POSITION')!.getCount());
  const ofCorner = new Uint32Array(3 * sources.length);
  const spanOfTriangle = new Uint32Array(sources.length);
  sources.forEach((source, t) => {
    const span = spanOf(body, source);
    spanOfTriangle[t] = span;
    const base = first[span] - body.spans[span].firstVertex;
    for (let corner = 3 * t; corner < 3 * t + 3; ++corner)
      ofCorner[corner] = base + body.indices[ofBody(corner)];
  });
  return { primitives, first, ofCorner, spanOfTriangle };
}

function comparedOf(primitive: Primitive, withNormals: boolean): Compared[] {
  const whole = (accessor: Accessor, from = 0): Compared => {
    const size = accessor.getElementSize();
    return { array: accessor.getArray()!, size, from, to: size };
  };
  const attributes = primitive.listSemantics().flatMap((semantic) => {
    if (semantic === 'POSITION' || (semantic === 'NORMAL' && !withNormals)) return [];
    return [whole(primitive.getAttribute(semantic)!, semantic === 'TANGENT' ? 3 : 0)];
  });
  const targets = primitive.listTargets().flatMap((target) =>
    target
      .listSemantics()
      .filter((semantic) => semantic !== 'NORMAL' && semantic !== 'TANGENT')
      .map((semantic) => whole(target.getAttribute(semantic)!)),
  );
  return [...attributes, ...targets];
}

function countNormals(entries: Entries, mesh: TriangleMesh): number {
  const normals = entries.primitives.map((primitive) => primitive.getAttribute('NORMAL'));
  if (normals.some((accessor) => accessor === null)) return 0;
  const lists = normals.map((accessor): Compared[] => [
    { array: accessor!.getArray()!, size: 3, from: 0, to: 3 },
  ]);
  return classify(entries, mesh, lists).count;
}

/** Wedge ids per corner: equal where corners at one vertex and in one primitive agree in everything compared. */
function classify(entries: Entries, mesh: TriangleMesh, lists: Compared[][]) {
  const { first, ofCorner, spanOfTriangle } = entries;
  const classOfEntry = new Uint32Array(first[first.length - 1]).fill(NONE);
  const firstClass = new Uint32Array(vertexCount(mesh)).fill(NONE);
  const nextClass: number[] = [];
  const representative: number[] = [];
  const wedges = ofCorner.map((entry, corner) => {
    if (classOfEntry[entry] !== NONE) return classOfEntry[entry];
    const vertex = mesh.triangles[corner];
    const span = spanOfTriangle[Math.floor(corner / 3)];
    const isSame = (other: number) =>
      other >= first[span] &&
      other < first[span + 1] &&
      agree(lists[span], entry - first[span], other - first[span]);
    let found = firstClass[vertex];
    while (found !== NONE && !isSame(representative[found])) found = nextClass[found];
    if (found === NONE) {
      found = representative.length;
      representative.push(entry);
      nextClass.push(firstClass[vertex]);
      firstClass[vertex] = found;
    }
    classOfEntry[entry] = found;
    return found;
  });
  return { wedges, count: representative.length };
}

function agree(list: Compared[], a: number, b: number): boolean {
  if (a === b) return true;
  for (const { array, size, from, to } of list)
    for (let c = from; c < to; ++c) if (array[size * a + c] !== array[size * b + c]) return false;
  return true;
}

/** An attribute's values per wedge, 0 where a primitive lacks it; null where all primitives lack it. */
function gather(
  { primitives, first, ofCorner, spanOfTriangle }: Entries,
  wedges: Uint32Array,
  wedgeCount: number,
  semantic: string,
) {
  const accessors = primitives.map((primitive) => primitive.getAttribute(semantic));
  const size = Math.max(0, ...accessors.map((accessor) => accessor?.getElementSize() ?? 0));
  if (size === 0) return null;
  const values = new Float32Array(size * wedgeCount);
  const element: number[] = [];
  wedges.forEach((wedge, corner) => {
    const span = spanOfTriangle[Math.floor(corner / 3)];
    accessors[span]?.getElement(ofCorner[corner] - first[span], element).forEach((value, d) => {
      if (d < size) values[size * wedge + d] = value;
    });
  });
  return { values, size };
}

/** The length on the surface of one unit of UV, as a mean over the area; 0 where the UVs enclose no area. */
function textureScale({ positions, triangles }: TriangleMesh, wedges: Uint32Array, uv: Float32Array): number {
  let [surface, texture] = [0, 0];
  for (let t = 0; t < triangles.length; t += 3) {
    const edge = (k: number, axis: number) =>
      positions[3 * triangles[t + k] + axis] - positions[3 * triangles[t] + axis];
    const part = (u: number, v: number) => edge(1, u) * edge(2, v) - edge(1, v) * edge(2, u);
    surface += length3(part(1, 2), part(2, 0), part(0, 1));
    const across = (k: number, axis: number) => uv[2 * wedges[t + k] + axis] - uv[2 * wedges[t] + axis];
    texture += Math.abs(across(1, 0) * across(2, 1) - across(1, 1) * across(2, 0));
  }
  return texture > 0 ? Math.sqrt(surface / texture) : 0;
}
