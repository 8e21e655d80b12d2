/** Faces of a body that lie on the same three vertices: back sides that are modelled, and second layers of another material. */

import { NONE } from '../core/core';
import type { CornerSources, History, MeshAt, TriangleMesh, WeldResult } from '../core/core';
import type { Body } from '../document/model';
import { spanOf } from '../document/facts/spans';

/** One face of the body on a triangle of the welded mesh. */
export interface Layer {
  /** the triangle of the body */
  source: number;
  /** corner j of the body's triangle lies at corner cornerOf[j] of the welded one */
  cornerOf: readonly number[];
}

/** The layers on the triangles of a welded mesh; the first one is what a triangle was welded from. */
export interface Layers {
  /** per triangle of the welded mesh: the triangle of the body that is its first layer */
  first: Uint32Array;
  /** per triangle of the welded mesh: cornerOf of its first layer, two bits for each corner of the body's triangle */
  firstCorners: Uint8Array;
  /** the further layers of the triangles that have any */
  further: ReadonlyMap<number, readonly Layer[]>;
  /** the most layers on one triangle */
  most: number;
  /** whether no triangle has a second layer, or is wound the other way than in the body */
  isPlain: boolean;
}

const NO_LAYERS: readonly Layer[] = [];
const BITS_PER_CORNER = 2;

/** The layers of a body that was welded. Every usable face of the body is in one of them, as it is wound there. */
export function findLayers(body: Body, weld: WeldResult): Layers {
  const { sourceOfTriangle } = weld;
  const firstCorners = new Uint8Array(sourceOfTriangle.length);
  let isPlain = true;
  for (let t = 0; t < firstCorners.length; ++t) {
    firstCorners[t] = packedCorners(body, weld, sourceOfTriangle[t], t);
    isPlain &&= cornerAt(firstCorners[t], 1) === 1;
  }
  const further = weld.duplicateFaces > 0 ? findTwins(body, weld) : new Map<number, Layer[]>();
  const most = [...further.values()].reduce((most, { length }) => Math.max(most, 1 + length), 1);
  return { first: sourceOfTriangle, firstCorners, further, most, isPlain: isPlain && most === 1 };
}

/** All layers of triangle t of the welded mesh, the first one first. */
export function layersAt({ first, firstCorners, further }: Layers, t: number): Layer[] {
  return [{ source: first[t], cornerOf: unpacked(firstCorners[t]) }, ...(further.get(t) ?? NO_LAYERS)];
}

export const layerCount = ({ further }: Layers, t: number): number => 1 + (further.get(t)?.length ?? 0);

const cornerAt = (packed: number, j: number): number => (packed >> (BITS_PER_CORNER * j)) & 3;

const unpacked = (packed: number): number[] => [0, 1, 2].map((j) => cornerAt(packed, j));

/** The layers besides the first, by the triangle of the welded mesh on whose vertices they lie. */
function findTwins(body: Body, weld: WeldResult): Map<number, Layer[]> {
  const { mesh, vertexOfSource, sourceOfTriangle } = weld;
  const keyOf = (vertices: number[]): string => vertices.sort((a, b) => a - b).join();
  const known = new Map<string, number>();
  for (let t = 0; t < sourceOfTriangle.length; ++t)
    known.set(keyOf([...mesh.triangles.subarray(3 * t, 3 * t + 3)]), t);
  const isKept = new Uint8Array(body.indices.length / 3);
  for (const source of sourceOfTriangle) isKept[source] = 1;
  const twins = new Map<number, Layer[]>();
  isKept.forEach((kept, source) => {
    const vertices = [0, 1, 2].map((j) => vertexOfSource[body.indices[3 * source + j]]);
    if (kept === 1 || vertices.includes(NONE) || new Set(vertices).size < 3) return;
    const t = known.get(keyOf(vertices));
    if (t === undefined) return;
    const layer = { source, cornerOf: unpacked(packedCorners(body, weld, source, t)) };
    twins.set(t, [...(twins.get(t) ?? NO_LAYERS), layer]);
  });
  return twins;
}

/** Per corner of the body's triangle the corner of triangle t of the welded mesh at the same vertex, packed. */
function packedCorners(
  body: Body,
  { mesh: { triangles }, vertexOfSource }: WeldResult,
  source: number,
  t: number,
): number {
  let packed = 0;
  for (let j = 0; j < 3; ++j) {
    const vertex = vertexOfSource[body.indices[3 * source + j]];
    let corner = j;
    for (let c = 2; c >= 0; --c) if (triangles[3 * t + c] === vertex) corner = c;
    packed |= corner << (BITS_PER_CORNER * j);
  }
  return packed;
}

/** A mesh as it is written, with every layer, and where its triangles and corners come from in the body. */
export interface Layered {
  mesh: TriangleMesh;
  inputOfTriangle: Uint32Array;
  sources: CornerSources;
}

/**
 * Each triangle of the result once for every layer of the triangle that it comes from, wound as that layer is in the body. `sources`: on
 * the welded mesh. Attributes of a further layer come from the same points as those of the first one; where it has no layer there,
 * from its own corner.
 */
export function withLayers(layers: Layers, body: Body, result: MeshAt, sources: CornerSources): Layered {
  const { mesh, inputOfTriangle } = result;
  const triangles: number[] = [];
  const written: number[] = [];
  const from: number[] = [];
  const shares: number[] = [];
  // Layer by layer, so that the first one has the order that it would have alone.
  for (let number = 0; number < layers.most; ++number)
    inputOfTriangle.forEach((input, t) => {
      const layer = layersAt(layers, input)[number] as Layer | undefined;
      if (!layer) return;
      written.push(layer.source);
      layer.cornerOf.forEach((c, j) => {
        triangles.push(mesh.triangles[3 * t + c]);
        const corner = 3 * t + c;
        const there = layerLike(layersAt(layers, sources.triangle[corner]), layer, body);
        from.push((there ?? layer).source);
        const barycentric = (k: number) => sources.barycentric[3 * corner + k];
        shares.push(...(there ? there.cornerOf.map(barycentric) : [0, 1, 2].map((k) => (k === j ? 1 : 0))));
      });
    });
  return {
    mesh: { positions: mesh.positions, triangles: Uint32Array.from(triangles) },
    inputOfTriangle: Uint32Array.from(written),
    sources: { triangle: Uint32Array.from(from), barycentric: Float32Array.from(shares) },
  };
}

/** The triangles of a result, each as often as it has layers. */
export function trianglesOfLayers(
  layers: Layers,
  triangles: Uint32Array,
  inputOfTriangle: Uint32Array,
): Uint32Array {
  const all: number[] = [];
  inputOfTriangle.forEach((input, t) => {
    for (const { cornerOf } of layersAt(layers, input))
      all.push(...cornerOf.map((c) => triangles[3 * t + c]));
  });
  return Uint32Array.from(all);
}

/** How many faces the welded mesh has with all their layers. */
export const allFaces = ({ first, further }: Layers): number =>
  [...further.values()].reduce((sum, { length }) => sum + length, first.length);

/** How many faces a result has with all their layers. */
export const layeredFaces = (layers: Layers, inputOfTriangle: Uint32Array): number =>
  inputOfTriangle.reduce((sum, input) => sum + layerCount(layers, input), 0);

/** Among the layers at another place the one of the same primitive, and of the same side where there are several. */
function layerLike(layers: readonly Layer[], wanted: Layer, body: Body): Layer | undefined {
  const same = layers.filter(({ source }) => spanOf(body, source) === spanOf(body, wanted.source));
  return same.find(({ cornerOf }) => isEven(cornerOf) === isEven(wanted.cornerOf)) ?? same[0];
}

const isEven = (corners: readonly number[]): boolean => (corners[1] - corners[0] + 3) % 3 === 1;

/** Per number of collapses in `ends`, ascending: the faces with all their layers that are left of the welded mesh. */
export function writtenFaces(
  layers: Layers,
  { triangles }: TriangleMesh,
  history: History,
  ends: Uint32Array,
): Uint32Array {
  const lost = new Uint32Array(history.kept.length + 1);
  const mergedAt = mergeTimes(history);
  let left = 0;
  layers.first.forEach((_, t) => {
    const count = layerCount(layers, t);
    const [a, b, c] = triangles.subarray(3 * t, 3 * t + 3);
    const time = Math.min(mergedAt(a, b), mergedAt(b, c), mergedAt(c, a));
    left += count;
    if (time < Infinity) lost[time + 1] += count;
  });
  let done = 0;
  return ends.map((end) => {
    for (; done < end; ++done) left -= lost[done + 1];
    return left;
  });
}

/** Finds the collapse after which two vertices are one; Infinity: they never are. */
function mergeTimes({ vertexCount, kept, removed }: History): (u: number, v: number) => number {
  const time = new Float64Array(vertexCount).fill(Infinity);
  const into = new Uint32Array(vertexCount);
  removed.forEach((vertex, i) => {
    time[vertex] = i;
    into[vertex] = kept[i];
  });
  return (u, v) => {
    let last = 0;
    while (u !== v) {
      if (time[u] > time[v]) [u, v] = [v, u];
      last = time[u];
      if (last === Infinity) return last;
      u = into[u];
    }
    return last;
  };
}
