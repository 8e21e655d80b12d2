/** The meshes of a glTF document as bodies: plain triangles in the mesh's own space. */

import type { Accessor, Document, Mesh, Node, Primitive } from '@gltf-transform/core';
import { length3 } from '../core/exact_math';
import { GrowingFloats, GrowingIndices } from './growing';
import { counted } from '../core/words';
import type { Body, PrimitiveSpan } from './model';
import { firstNodes, meshMatrixOf } from './placements';

/** glTF's primitive modes. */
const LINES_FROM = 1;
const TRIANGLES = 4;
const TRIANGLE_STRIP = 5;
const TRIANGLE_FAN = 6;

/** At most so many names stand in a note. */
const NAMES_SHOWN = 5;

/** The data gathered from the primitives of one mesh. */
interface Gathering {
  positions: GrowingFloats;
  indices: GrowingIndices;
  spans: PrimitiveSpan[];
  /** primitives that share positions share the vertices of the body */
  firstVertex: Map<Accessor, number>;
  skipped: { points: number; lines: number; empty: number };
}

/**
 * The bodies, and notes on meshes that are none: those without triangles, and those that no node shows where others are shown. `most`: the most vertices, and the most corners, of all bodies together: meshes
 * that share their data could ask for any number. Throws an Error that names the mesh and primitive if data are broken.
 */
export function bodiesOfDocument(
  file: string,
  document: Document,
  most: number,
): { bodies: Body[]; notes: string[] } {
  const bodies: Body[] = [];
  const without: { name: string; reasons: string }[] = [];
  const nodes = firstNodes(document);
  const repeated = repeatedNames(document);
  const budget = { file, left: most };
  for (const [number, mesh] of document.getRoot().listMeshes().entries()) {
    const node = nodes.get(mesh);
    const ofNode = node?.getName() ?? '';
    const name = (repeated.has(mesh.getName()) && ofNode) || mesh.getName() || ofNode || `mesh ${number}`;
    const gathering = gather(budget, name, mesh);
    const bodyNotes = skippedNotes(gathering.skipped);
    if (gathering.indices.length === 0) {
      without.push({ name, reasons: bodyNotes.join(', ') });
      continue;
    }
    const scaling = node ? scalingOf(node) : { scale: 1, isEven: true };
    if (!scaling.isEven) bodyNotes.push('its node scales it non-uniformly: frequencies use the mean scale');
    const [positions, indices] = [gathering.positions.finish(), gathering.indices.finish()];
    const { spans } = gathering;
    bodies.push({
      ...{ name, positions, indices, notes: bodyNotes, mesh: number, spans, scale: scaling.scale },
      ...(scaling.isEven ? {} : { isScaledUnevenly: true }),
    });
  }
  const meshes = document.getRoot().listMeshes();
  const shown = bodies.filter(({ mesh }) => nodes.has(meshes[mesh]));
  if (shown.length === 0) return { bodies, notes: describeWithout(without) };
  const unseen = bodies.filter(({ mesh }) => !nodes.has(meshes[mesh])).map(({ name }) => name);
  return { bodies: shown, notes: [...describeWithout(without), ...describeUnseen(unseen)] };
}

/** Names that several meshes share, as copies of an object often do: only their nodes tell them apart. */
function repeatedNames(document: Document): Set<string> {
  const [seen, repeated] = [new Set<string>(), new Set<string>()];
  for (const mesh of document.getRoot().listMeshes()) {
    const name = mesh.getName();
    if (seen.has(name)) repeated.add(name);
    seen.add(name);
  }
  return repeated;
}

/** A note on meshes that no node shows; none where there are none. */
function describeUnseen(names: string[]): string[] {
  if (names.length === 0) return [];
  if (names.length === 1) return [`mesh "${names[0]}" is left unchanged, because no node shows it`];
  const shown = listed(names.map((name) => `"${name}"`));
  return [`${names.length} meshes (${shown}) are left unchanged, because no node shows them`];
}

const listed = (names: string[]): string =>
  names.slice(0, NAMES_SHOWN).join(', ') + (names.length > NAMES_SHOWN ? ', ...' : '');

/** One note for all meshes without triangles for the same reasons. */
function describeWithout(meshes: { name: string; reasons: string }[]): string[] {
  const byReasons = new Map<string, string[]>();
  for (const { name, reasons } of meshes) {
    if (!byReasons.has(reasons)) byReasons.set(reasons, []);
    byReasons.get(reasons)!.push(`"${name}"`);
  }
  return [...byReasons].map(([reasons, names]) => {
    const why = reasons === '' ? '' : ` (${reasons})`;
    if (names.length === 1) return `mesh ${names[0]} has no triangles${why}`;
    return `${names.length} meshes (${listed(names)}) have no triangles${why}`;
  });
}

/** Gathers the primitives of a mesh and subtracts their data from the `budget` of the file. */
function gather(budget: { file: string; left: number }, name: string, mesh: Mesh): Gathering {
  const gathering: Gathering = {
    positions: new GrowingFloats(),
    indices: new GrowingIndices(),
    spans: [],
    firstVertex: new Map(),
    skipped: { points: 0, lines: 0, empty: 0 },
  };
  mesh.listPrimitives().forEach((primitive, number) => {
    const mode: number = primitive.getMode();
    const positions = primitive.getAttribute('POSITION');
    if (mode < TRIANGLES) gathering.skipped[mode < LINES_FROM ? 'points' : 'lines'] += 1;
    else if (!positions?.getArray() || positions.getCount() === 0) gathering.skipped.empty += 1;
    else {
      takeFromBudget(budget, gathering, primitive, positions);
      const where = `${budget.file}, mesh "${name}", primitive ${number}`;
      const firstTriangle = gathering.indices.length / 3;
      const firstVertex = addPositions(gathering, positions, where);
      const vertexCount = positions.getCount();
      gathering.spans.push({ primitive: number, first: firstTriangle, firstVertex, vertexCount });
      for (const vertex of cornersOf(primitive, vertexCount, where))
        gathering.indices.push(firstVertex + vertex);
    }
  });
  return gathering;
}

/** Subtracts the data of a primitive from what the file may have. Throws an Error where nothing is left. */
function takeFromBudget(
  budget: { file: string; left: number },
  { firstVertex }: Gathering,
  primitive: Primitive,
  positions: Accessor,
): void {
  const vertices = firstVertex.has(positions) ? 0 : positions.getCount();
  budget.left -= Math.max(vertices, primitive.getIndices()?.getCount() ?? positions.getCount());
  if (budget.left < 0)
    throw new Error(
      `${budget.file} has primitives that repeat its data too often: share meshes between nodes instead.`,
    );
}

/** Adds the decoded positions unless another primitive has already; returns the body's index of the first vertex. */
function addPositions({ positions, firstVertex }: Gathering, accessor: Accessor, where: string): number {
  const known = firstVertex.get(accessor);
  if (known !== undefined) return known;
  const first = positions.length / 3;
  const read = elementReader(accessor);
  for (let v = 0; v < accessor.getCount(); ++v) {
    const [x, y, z] = read(v);
    if (!Number.isFinite(x + y + z))
      throw new Error(
        `${where}: vertex ${v} is at (${x}, ${y}, ${z}), which is not finite: repair the mesh and export it again.`,
      );
    positions.push3(x, y, z);
  }
  firstVertex.set(accessor, first);
  return first;
}

/** Reads element after element as 32-bit numbers into one array; those that are stored so are not decoded one by one. */
function elementReader(accessor: Accessor): (v: number) => ArrayLike<number> & Iterable<number> {
  const array = accessor.getArray();
  const element = [0, 0, 0];
  if (!(array instanceof Float32Array) || accessor.getElementSize() !== 3)
    return (v) => accessor.getElement(v, element).map(Math.fround);
  return (v) => {
    for (let c = 0; c < 3; ++c) element[c] = array[3 * v + c];
    return element;
  };
}

/** Three vertex indices per triangle, from a list, strip or fan. */
function cornersOf(primitive: Primitive, vertexCount: number, where: string): Uint32Array {
  const indices = primitive.getIndices()?.getArray() ?? numbersTo(vertexCount);
  const wrong = (indices as Uint32Array).find((vertex) => vertex >= vertexCount);
  if (wrong !== undefined)
    throw new Error(
      `${where}: index ${wrong} is out of range, there are ${vertexCount} vertices: repair the mesh and export it again.`,
    );
  const mode: number = primitive.getMode();
  if (![TRIANGLES, TRIANGLE_STRIP, TRIANGLE_FAN].includes(mode))
    throw new Error(`${where}: its mode is not a number from 0 to 6: repair the mesh and export it again.`);
  if (mode === TRIANGLES) return Uint32Array.from(indices.subarray(0, indices.length - (indices.length % 3)));
  const triangles = new Uint32Array(3 * Math.max(0, indices.length - 2));
  for (let t = 0; t < triangles.length / 3; ++t)
    triangles.set(
      stripCorners(mode, t).map((at) => indices[at]),
      3 * t,
    );
  return triangles;
}

function numbersTo(count: number): Uint32Array {
  const numbers = new Uint32Array(count);
  for (let i = 0; i < count; ++i) numbers[i] = i;
  return numbers;
}

/** Offsets of the corners of triangle t in the index list; every second triangle of a strip is reversed. */
function stripCorners(mode: number, t: number): [number, number, number] {
  if (mode === TRIANGLE_FAN) return [0, t + 1, t + 2];
  return t % 2 === 0 ? [t, t + 1, t + 2] : [t + 1, t, t + 2];
}

function skippedNotes({ points, lines, empty }: Gathering['skipped']): string[] {
  const kinds: [number, string][] = [
    [points, 'primitive of points'],
    [lines, 'primitive of lines'],
    [empty, 'primitive without positions'],
  ];
  return kinds
    .filter(([count]) => count > 0)
    .map(([count, kind]) => `${counted(count, kind, kind.replace('primitive', 'primitives'))} skipped`);
}

/** The scale of the mesh of a node. For a skinned mesh it is exact to six digits only, because inverse bind matrices are 32-bit floats. */
function scalingOf(node: Node): { scale: number; isEven: boolean } {
  const { scale, isEven } = scaleOf(meshMatrixOf(node));
  return { scale: node.getSkin() ? Number(scale.toPrecision(6)) : scale, isEven };
}

/** The scale of a matrix of four columns, a root mean square over its three axes, and whether the axes agree to 0.1 %. */
function scaleOf(matrix: readonly number[]): { scale: number; isEven: boolean } {
  const [x, y, z] = [0, 4, 8].map((at) => length3(matrix[at], matrix[at + 1], matrix[at + 2]));
  const [smallest, largest] = [Math.min(x, y, z), Math.max(x, y, z)];
  if (!(smallest > 0) || !Number.isFinite(largest)) return { scale: 1, isEven: true };
  const isEven = largest <= 1.001 * smallest;
  return { scale: isEven ? x : Math.sqrt((x * x + y * y + z * z) / 3), isEven };
}
