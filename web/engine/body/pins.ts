/**
 * Which vertices are held in place, as text: `low:6`, `high:6` (the lowest, highest 6 % along the longest axis of the
 * bounding box), `box:x0,y0,z0,x1,y1,z1` (units of the body), `attribute:NAME` (where its first component is above
 * one half), `vertices:i,j` (numbers in the file, from 0), joined by `+`.
 */

import { NONE } from '../core/core';
import type { Document } from '@gltf-transform/core';
import type { PreparedBody } from './prepared_body';

export type PinTerm =
  | { kind: 'low'; percent: number }
  | { kind: 'high'; percent: number }
  | { kind: 'box'; low: number[]; high: number[] }
  | { kind: 'attribute'; name: string }
  | { kind: 'vertices'; vertices: number[] };

const FORMS = 'low:PCT, high:PCT, box:x0,y0,z0,x1,y1,z1, attribute:NAME or vertices:i,j, joined by +';

/** The terms of the text of a flag; none for an empty one. Throws one sentence that shows the forms. */
export function parsePins(text: string, flag = 'pins'): PinTerm[] {
  return text === '' ? [] : text.split('+').map((term) => parseTerm(term, flag));
}

function parseTerm(term: string, flag: string): PinTerm {
  const colon = term.indexOf(':');
  const [kind, value] = [term.slice(0, colon), term.slice(colon + 1)];
  const numbers = value.split(',').map((word) => (word.trim() === '' ? NaN : Number(word)));
  const refuse = (): never => {
    throw new Error(`--${flag} has "${term}": give ${FORMS}.`);
  };
  if (colon < 1 || value === '') return refuse();
  if (kind === 'attribute') return { kind, name: value };
  if (!numbers.every(Number.isFinite)) return refuse();
  if (kind === 'low' || kind === 'high') {
    if (numbers.length !== 1 || numbers[0] < 0 || numbers[0] > 100) return refuse();
    return { kind, percent: numbers[0] };
  }
  if (kind === 'box') {
    if (numbers.length !== 6) return refuse();
    const [low, high] = [numbers.slice(0, 3), numbers.slice(3)];
    return {
      kind,
      low: low.map((x, i) => Math.min(x, high[i])),
      high: low.map((x, i) => Math.max(x, high[i])),
    };
  }
  if (kind !== 'vertices' || !numbers.every((n) => Number.isInteger(n) && n >= 0)) return refuse();
  return { kind, vertices: numbers };
}

/**
 * The vertices of `prepared.mesh` that the text of a flag names, ascending. Throws where a name or number is not in the
 * body.
 */
export function findPins(
  text: string,
  document: Document,
  prepared: PreparedBody,
  flag = 'pins',
): Uint32Array {
  const pinned = new Set<number>();
  for (const term of parsePins(text, flag))
    for (const vertex of pinnedBy(term, document, prepared, flag)) pinned.add(vertex);
  return Uint32Array.from(pinned).sort();
}

function pinnedBy(term: PinTerm, document: Document, prepared: PreparedBody, flag: string): number[] {
  const { positions } = prepared.mesh;
  const inside = (isPinned: (at: number) => boolean) =>
    Array.from({ length: positions.length / 3 }, (_, v) => v).filter((v) => isPinned(3 * v));
  if (term.kind === 'box') {
    const { low, high } = term;
    return inside((at) =>
      [0, 1, 2].every((c) => positions[at + c] >= low[c] && positions[at + c] <= high[c]),
    );
  }
  if (term.kind === 'low' || term.kind === 'high') {
    const { axis, low, high } = longestExtent(positions);
    const depth = (term.percent / 100) * (high - low);
    return term.kind === 'low'
      ? inside((at) => positions[at + axis] <= low + depth)
      : inside((at) => positions[at + axis] >= high - depth);
  }
  const sources =
    term.kind === 'vertices' ? term.vertices : attributeVertices(term.name, document, prepared, flag);
  const { vertexOfSource } = prepared.weld;
  for (const source of sources)
    if (source >= vertexOfSource.length)
      throw new Error(
        `--${flag} names vertex ${source}, but "${prepared.body.name}" has only ${vertexOfSource.length}: name one below that.`,
      );
  return sources.map((source) => vertexOfSource[source]).filter((vertex) => vertex !== NONE);
}

/** The longest side of the bounding box; of equal ones the first. */
function longestExtent(positions: Float32Array): { axis: number; low: number; high: number } {
  const extents = [0, 1, 2].map((axis) => {
    let [low, high] = [Infinity, -Infinity];
    for (let at = axis; at < positions.length; at += 3) {
      low = Math.min(low, positions[at]);
      high = Math.max(high, positions[at]);
    }
    return { axis, low, high };
  });
  return extents.reduce((longest, one) => (one.high - one.low > longest.high - longest.low ? one : longest));
}

/** The body's vertices where the first component of an attribute is above one half. */
function attributeVertices(name: string, document: Document, prepared: PreparedBody, flag: string): number[] {
  return [...firstComponents(name, document, prepared, flag)].flatMap((value, vertex) =>
    value > 0.5 ? [vertex] : [],
  );
}

/**
 * The first component of an attribute at every vertex of the body; 0 where a primitive lacks it. Throws one sentence that
 * names the flag where all do.
 */
export function firstComponents(
  name: string,
  document: Document,
  { body }: PreparedBody,
  flag: string,
): Float32Array {
  const primitives = document.getRoot().listMeshes()[body.mesh].listPrimitives();
  const found = new Float32Array(body.positions.length / 3);
  let isThere = false;
  for (const { primitive, firstVertex } of body.spans) {
    const attribute = primitives[primitive].getAttribute(name);
    if (!attribute) continue;
    isThere = true;
    const element: number[] = [];
    for (let v = 0; v < attribute.getCount(); ++v)
      found[firstVertex + v] = attribute.getElement(v, element)[0];
  }
  if (isThere) return found;
  const names = [...new Set(primitives.flatMap((primitive) => primitive.listSemantics()))].join(', ');
  throw new Error(
    `--${flag} names the attribute ${name}, but "${body.name}" has ${names}: name one of these.`,
  );
}
