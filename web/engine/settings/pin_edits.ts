/** Changes to the text of the pins, as buttons and the pick tool make them. The forms are those of pin_text.ts. */

import { NONE } from '../core/core';

const termsOf = (text: string): string[] => (text === '' ? [] : text.split('+'));
const isOfKind = (kind: string) => (term: string) => term.startsWith(`${kind}:`);

/** Whether the text has a term of this kind: `low`, `high`, `box`, `attribute`, `vertices`. */
export const hasPins = (text: string, kind: string): boolean => termsOf(text).some(isOfKind(kind));

/** The text after the colon of the first term of a kind; '' where there is none. */
export function pinValue(text: string, kind: string): string {
  const term = termsOf(text).find(isOfKind(kind));
  return term ? term.slice(kind.length + 1) : '';
}

/** The text with this as the only term of its kind; an empty value removes the kind. */
export function withPins(text: string, kind: string, value: string): string {
  const others = termsOf(text).filter((term) => !isOfKind(kind)(term));
  return [...others, ...(value === '' ? [] : [`${kind}:${value}`])].join('+');
}

/** Per vertex of the welded mesh the lowest of its source vertices; `vertexOfSource` as WeldResult has it. */
export function sourcesOfVertices(vertexOfSource: Uint32Array): Map<number, number> {
  const sources = new Map<number, number>();
  vertexOfSource.forEach((vertex, source) => {
    if (vertex !== NONE && !sources.has(vertex)) sources.set(vertex, source);
  });
  return sources;
}

/** Welded vertices to pin or to release. */
export interface PinEdit {
  isPinning: boolean;
  vertices: number[];
}

/**
 * The text after an edit of the vertices that it pins, `pinned`. Where the edit releases a vertex that is not listed by number,
 * all remaining vertices are listed; otherwise the other terms stay as they are.
 */
export function editPins(
  text: string,
  pinned: Uint32Array,
  { isPinning, vertices }: PinEdit,
  vertexOfSource: Uint32Array,
): string {
  const listed = listedVertices(text, vertexOfSource);
  const before = new Set(pinned);
  if (isPinning) {
    const added = vertices.filter((vertex) => !before.has(vertex));
    return withVertices(text, [...listed, ...added], vertexOfSource);
  }
  const removed = new Set(vertices.filter((vertex) => before.has(vertex)));
  const isListed = new Set(listed);
  // A vertex that another term pins can only be released by replacing all terms with a list of the remaining vertices.
  const needsList = [...removed].some((vertex) => !isListed.has(vertex));
  const kept = (needsList ? [...pinned] : listed).filter((vertex) => !removed.has(vertex));
  return withVertices(needsList ? '' : text, kept, vertexOfSource);
}

function listedVertices(text: string, vertexOfSource: Uint32Array): number[] {
  return termsOf(text)
    .filter(isOfKind('vertices'))
    .flatMap((term) => term.slice('vertices:'.length).split(','))
    .map((source) => vertexOfSource[Number(source)])
    .filter((vertex) => vertex !== undefined && vertex !== NONE);
}

function withVertices(text: string, vertices: number[], vertexOfSource: Uint32Array): string {
  const sources = sourcesOfVertices(vertexOfSource);
  const numbers = [...new Set(vertices)].map((vertex) => sources.get(vertex)!).sort((a, b) => a - b);
  return withPins(text, 'vertices', numbers.join(','));
}
