/** The attributes of a body's corners besides positions, as simplification needs them: charts, and values that enter its costs. */

import type { Accessor, Document, Primitive } from '@gltf-transform/core';
import { DistinctMembers, extendHash } from '../core/distinct_members';
import type { LastMembers } from '../core/distinct_members';
import { NONE } from '../core/core';
import type { Charts, CornerSources, TriangleMesh, WeldResult } from '../core/core';
import type { Body } from '../document/model';
import { spanOf } from '../document/facts/spans';
import { cosinesOf, endsOf, innerEdgesOf, hardCosineOf } from './hard_edges';
import { JoinedClasses } from './joined_classes';
import type { Classes } from './joined_classes';
import { findLayers, layerCount, layersAt } from './layers';
import type { Layers } from './layers';
import { vertexCount } from '../core/mesh';

export interface BodyAttributes {
  /** of the welded mesh; a group is a primitive; empty wedges where there are no attributes */
  charts: Charts;
  /** charts.wedges are below it */
  wedgeCount: number;
  /**
   * the cosine below which the angle between two faces makes their edge hard, so that normals there follow from the faces and
   * separate no charts (see hardCosineOf); null: every normal is a value like any other
   */
  hardCosine: number | null;
  /** whether the file has nothing but positions, so that results need no sources of their corners */
  isBare: boolean;
}

/** The attributes of a body that has nothing but positions and faces. */
export const NO_ATTRIBUTES: BodyAttributes = {
  charts: { wedges: new Uint32Array(), groups: new Uint32Array() },
  wedgeCount: 0,
  hardCosine: null,
  isBare: true,
};

/** Components [from, to) of an attribute; they are equal at all corners of a wedge. */
interface Compared {
  array: ArrayLike<number>;
  size: number;
  from: number;
  to: number;
}

/** One entry per vertex of each primitive: primitives may share positions and still differ in their other attributes. */
export interface Entries {
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
  return { ...joinedCharts(all, layers), hardCosine: first.hardCosine, isBare: first.isBare };
}

function attributesOfLayer(entries: Entries, { mesh }: WeldResult): BodyAttributes {
  const lists = entries.primitives.map((primitive) => comparedOf(primitive, true));
  const hasAny = lists.some((list) => list.length > 0);
  const all = hasAny ? classify(entries, mesh, lists) : { wedges: new Uint32Array(), count: 0 };
  const { wedges, count, hardCosine } = withoutHardEdges(entries, mesh, all);
  const groups = entries.primitives.length > 1 ? entries.spanOfTriangle : new Uint32Array();
  return {
    charts: { wedges, groups },
    wedgeCount: count,
    hardCosine,
    isBare: entries.primitives.every(isBare),
  };
}

const isBare = (primitive: Primitive): boolean =>
  primitive.listSemantics().every((semantic) => semantic === 'POSITION') &&
  primitive.listTargets().length === 0;

/** Joins classes of corners across hard edges that follow from the angle between faces, where nothing but normals differs. */
function withoutHardEdges(entries: Entries, mesh: TriangleMesh, all: Classes) {
  const none = { ...all, hardCosine: null };
  const normals = classifyNormals(entries, mesh);
  const positions = classify(
    entries,
    mesh,
    entries.primitives.map(() => []),
  );
  if (!normals || normals.count === positions.count) return none;
  const edges = innerEdgesOf(mesh);
  const cosines = cosinesOf(mesh, edges);
  const ends = (edge: number) => endsOf(mesh, edges, edge);
  const isHard = (edge: number) => ends(edge).some(([a, b]) => normals.wedges[a] !== normals.wedges[b]);
  const hardCosine = hardCosineOf(mesh, edges, cosines, isHard);
  if (hardCosine === null) return none;
  const others = classify(
    entries,
    mesh,
    entries.primitives.map((primitive) => comparedOf(primitive, false)),
  );
  const joined = new JoinedClasses(all.count);
  cosines.forEach((cosine, edge) => {
    if (cosine >= hardCosine) return;
    for (const [a, b] of ends(edge))
      if (others.wedges[a] === others.wedges[b]) joined.join(all.wedges[a], all.wedges[b]);
  });
  return { ...joined.classesOf(all.wedges), hardCosine };
}

/** Corners agree where they agree in every layer; triangles are of one group where all their layers are. */
function joinedCharts(all: BodyAttributes[], layers: Layers): Pick<BodyAttributes, 'charts' | 'wedgeCount'> {
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
  const keyOf = (t: number, lists: Uint32Array[], at: number): string =>
    Array.from({ length: layerCount(layers, t) }, (_, number) => lists[number][at] ?? 0).join(' ');
  const groups = numbered(Array.from(layers.first, (_, t) => keyOf(t, groupsOf, t))).ids;
  if (wedgesOf.every(({ length }) => length === 0))
    return { charts: { wedges: new Uint32Array(), groups }, wedgeCount: 0 };
  const keys = Array.from({ length: 3 * layers.first.length }, (_, corner) =>
    keyOf(Math.floor(corner / 3), wedgesOf, corner),
  );
  const wedges = numbered(keys);
  return { charts: { wedges: wedges.ids, groups }, wedgeCount: wedges.count };
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

/** Per triangle of the welded mesh: 1 where its winding is reversed compared with the body's. */
function turnedTriangles(body: Body, { mesh, vertexOfSource, sourceOfTriangle }: WeldResult): Uint8Array {
  const isTurned = new Uint8Array(sourceOfTriangle.length);
  for (let t = 0; t < isTurned.length; ++t) {
    const second = body.indices[3 * sourceOfTriangle[t] + 1];
    isTurned[t] = vertexOfSource[second] === mesh.triangles[3 * t + 1] ? 0 : 1;
  }
  return isTurned;
}

export function entriesOf(document: Document, body: Body, weld: WeldResult): Entries {
  return entriesAt(document, body, weld.sourceOfTriangle, cornerInBody(body, weld));
}

/** The entries of layer `number`, or of the last layer of a triangle that has fewer. */
function entriesOfLayer(document: Document, body: Body, layers: Layers, number: number): Entries {
  const layerAt = (t: number) => layersAt(layers, t)[Math.min(number, layerCount(layers, t) - 1)];
  const sources = layers.first.map((_, t) => layerAt(t).source);
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

/** Classes of corners by normals alone; null where a primitive has no normals. */
function classifyNormals(entries: Entries, mesh: TriangleMesh): Classes | null {
  const normals = entries.primitives.map((primitive) => primitive.getAttribute('NORMAL'));
  if (normals.some((accessor) => accessor === null)) return null;
  const lists = normals.map((accessor): Compared[] => [
    { array: accessor!.getArray()!, size: 3, from: 0, to: 3 },
  ]);
  return classify(entries, mesh, lists);
}

/** Wedge ids per corner: equal where corners at one vertex and in one primitive agree in everything compared. */
function classify(entries: Entries, mesh: TriangleMesh, lists: Compared[][]): Classes {
  const { first, ofCorner, spanOfTriangle } = entries;
  const classOfEntry = new Uint32Array(first[first.length - 1]).fill(NONE);
  const representative: number[] = [];
  const spanOfClass: number[] = [];
  const hashOf = (entry: number, span: number) => hashAt(lists[span], entry - first[span]);
  const classes = new DistinctMembers(
    (one) => hashOf(representative[one], spanOfClass[one]),
    lastOf(new Uint32Array(vertexCount(mesh)).fill(NONE)),
  );
  const wedges = ofCorner.map((entry, corner) => {
    if (classOfEntry[entry] !== NONE) return classOfEntry[entry];
    const vertex = mesh.triangles[corner];
    const span = spanOfTriangle[Math.floor(corner / 3)];
    const isSame = (other: number) =>
      spanOfClass[other] === span &&
      agree(lists[span], entry - first[span], representative[other] - first[span]);
    let found = classes.find(vertex, isSame, () => hashOf(entry, span));
    if (found === NONE) {
      representative.push(entry);
      spanOfClass.push(span);
      found = classes.add(vertex);
    }
    classOfEntry[entry] = found;
    return found;
  });
  return { wedges, count: representative.length };
}

/** The last class of each vertex. */
const lastOf = (classes: Uint32Array): LastMembers => ({
  get: (vertex) => classes[vertex],
  set: (vertex, one) => (classes[vertex] = one),
});

/** A hash of an entry's compared values; equal for entries that agree. */
function hashAt(list: Compared[], entry: number): number {
  let hash = 0;
  for (const { array, size, from, to } of list)
    for (let c = from; c < to; ++c) hash = extendHash(hash, array[size * entry + c]);
  return hash;
}

function agree(list: Compared[], a: number, b: number): boolean {
  if (a === b) return true;
  for (const { array, size, from, to } of list)
    for (let c = from; c < to; ++c) if (array[size * a + c] !== array[size * b + c]) return false;
  return true;
}
