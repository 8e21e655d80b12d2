/** Which vertices of a body the terms of pins stand for; see settings/pin_text.ts. */

import { vertexCount } from '../core/mesh';
import type { Document, Mesh } from '@gltf-transform/core';
import { NONE } from '../core/core';
import { SettingError } from '../settings/errors';
import { parsePins } from '../settings/pin_text';
import type { PinTerm, PinTerms } from '../settings/pin_text';
import type { SettingName } from '../settings/table';
import type { PreparedBody } from './prepared_body';

/** Vertices of a prepared mesh that are held in place, in its modes and in simulation: indices, ascending and distinct. */
export type PinnedVertices = Uint32Array;

/**
 * The vertices of `prepared.mesh` that the text of a setting stands for. Throws SettingError where the text has not the form
 * of pins, or a name or number is not in the body.
 */
export const findPins = (
  text: string,
  document: Document,
  prepared: PreparedBody,
  setting: SettingName = 'pins',
): PinnedVertices => resolvePins(parsePins(text, setting), document, prepared, setting);

/** The vertices of `prepared.mesh` that the terms of a setting stand for. Throws SettingError where one is not in the body. */
export function resolvePins(
  terms: PinTerms,
  document: Document,
  prepared: PreparedBody,
  setting: SettingName,
): PinnedVertices {
  const pinned = new Set<number>();
  for (const term of terms)
    for (const vertex of verticesOf(term, document, prepared, setting)) pinned.add(vertex);
  return Uint32Array.from(pinned).sort();
}

function verticesOf(
  term: PinTerm,
  document: Document,
  prepared: PreparedBody,
  setting: SettingName,
): number[] {
  const { positions } = prepared.mesh;
  switch (term.kind) {
    case 'box':
      return inBox(positions, term);
    case 'low':
    case 'high':
      return atEnd(positions, term);
    case 'vertices':
      return weldedVertices(term.vertices, prepared, setting);
    case 'attribute':
      return weldedVertices(attributeVertices(term.name, document, prepared, setting), prepared, setting);
  }
}

const verticesWhere = (positions: Float32Array, isWanted: (at: number) => boolean): number[] =>
  Array.from({ length: positions.length / 3 }, (_, v) => v).filter((v) => isWanted(3 * v));

const inBox = (positions: Float32Array, { low, high }: { low: number[]; high: number[] }): number[] =>
  verticesWhere(positions, (at) =>
    [0, 1, 2].every((c) => positions[at + c] >= low[c] && positions[at + c] <= high[c]),
  );

/** The vertices within `percent` of the length of the longest axis from its lower or upper end. */
function atEnd(positions: Float32Array, { kind, percent }: { kind: 'low' | 'high'; percent: number }) {
  const { axis, low, high } = longestAxis(positions);
  const depth = (percent / 100) * (high - low);
  return verticesWhere(positions, (at) =>
    kind === 'low' ? positions[at + axis] <= low + depth : positions[at + axis] >= high - depth,
  );
}

/** The axis of the longest side of the bounding box, the first of equal ones, and its range. */
function longestAxis(positions: Float32Array): { axis: number; low: number; high: number } {
  const ranges = [0, 1, 2].map((axis) => {
    let [low, high] = [Infinity, -Infinity];
    for (let at = axis; at < positions.length; at += 3) {
      low = Math.min(low, positions[at]);
      high = Math.max(high, positions[at]);
    }
    return { axis, low, high };
  });
  return ranges.reduce((longest, one) => (one.high - one.low > longest.high - longest.low ? one : longest));
}

/** The welded vertices of vertices of the body; those that no usable face needs are left out. */
function weldedVertices(sources: number[], { body, weld }: PreparedBody, setting: SettingName): number[] {
  const { vertexOfSource } = weld;
  for (const source of sources)
    if (source >= vertexOfSource.length)
      throw new SettingError(
        setting,
        `names vertex ${source}, but "${body.name}" has only ${vertexOfSource.length}: name one below that.`,
      );
  return sources.map((source) => vertexOfSource[source]).filter((vertex) => vertex !== NONE);
}

/** The body's vertices where the first component of an attribute is above one half. */
const attributeVertices = (
  name: string,
  document: Document,
  prepared: PreparedBody,
  setting: SettingName,
): number[] =>
  [...firstComponents(name, document, prepared, setting)].flatMap((value, vertex) =>
    value > 0.5 ? [vertex] : [],
  );

/**
 * The first component of an attribute at every vertex of the body; 0 where a primitive has none. Throws SettingError about
 * `setting` where no mesh of the document has the attribute.
 */
export function firstComponents(
  name: string,
  document: Document,
  { body }: PreparedBody,
  setting: SettingName,
): Float32Array {
  const meshes = document.getRoot().listMeshes();
  const primitives = meshes[body.mesh].listPrimitives();
  const values = new Float32Array(vertexCount(body));
  for (const { primitive, firstVertex } of body.spans) {
    const attribute = primitives[primitive].getAttribute(name);
    if (!attribute) continue;
    const element: number[] = [];
    for (let v = 0; v < attribute.getCount(); ++v)
      values[firstVertex + v] = attribute.getElement(v, element)[0];
  }
  if (meshes.some((mesh) => hasAttribute(mesh, name))) return values;
  const names = [...new Set(primitives.flatMap((primitive) => primitive.listSemantics()))].join(', ');
  throw new SettingError(
    setting,
    `names the attribute ${name}, but "${body.name}" has ${names}: name one of these.`,
  );
}

const hasAttribute = (mesh: Mesh, name: string): boolean =>
  mesh.listPrimitives().some((primitive) => primitive.getAttribute(name) !== null);
