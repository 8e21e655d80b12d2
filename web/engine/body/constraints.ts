/** What a simplification of one body must respect: pins, locks, keep weights and a mirror symmetry. */

import type { Document } from '@gltf-transform/core';
import { NONE } from '../core/core';
import { vertexCount } from '../core/mesh';
import type { Settings } from '../settings/options';
import { keepOfLevels, lockedIn, paintOn } from './paint';
import { findPins, firstComponents } from './pins';
import type { PinnedVertices } from './pins';
import type { PreparedBody } from './prepared_body';
import { explainMissingSymmetry } from './symmetry';

/** Vertices are those of the prepared mesh; an absent field constrains nothing. */
export interface BodyConstraints {
  /** vertices that no mode moves; collapses keep their outline */
  pinned?: PinnedVertices;
  /** vertices that neither move nor disappear */
  locked?: Uint32Array;
  /** keep weight per vertex, in [0, 1]: see SimplifyConstraints.keep */
  keep?: Float32Array;
  /** mirror image per vertex: see SimplifyConstraints.mirror */
  mirror?: Uint32Array;
}

export interface FoundConstraints {
  constraints: BodyConstraints;
  /** one sentence where a symmetry is asked for that the body does not have; otherwise '' */
  note: string;
}

/** The settings that constraints come from, besides the pins. */
export const CONSTRAINT_SETTINGS = ['lock', 'keep', 'paint', 'symmetry'] as const;

/**
 * The constraints that the settings ask for on a body that was prepared with them. `pinned`: see `findPins`. Throws one
 * sentence where the body lacks what the settings name.
 */
export function constraintsOf(
  document: Document,
  prepared: PreparedBody,
  pinned: PinnedVertices,
  settings: Pick<Settings, (typeof CONSTRAINT_SETTINGS)[number]>,
): FoundConstraints {
  const { lock, keep, paint, symmetry } = settings;
  const { images } = prepared;
  const hasMirror = images !== undefined && images.partners.length > 0;
  const levels = paintOn(paint, prepared);
  const weights = keep === '' ? null : keepWeights(keep, document, prepared);
  const named = findPins(lock, document, prepared, 'lock');
  const constraints = {
    pinned,
    locked: levels ? Uint32Array.from(new Set([...named, ...lockedIn(levels)])).sort() : named,
    ...(levels || weights ? { keep: largerOf(weights, levels && keepOfLevels(levels)) } : {}),
    ...(hasMirror ? { mirror: images.partners } : {}),
  };
  return {
    constraints,
    note: images && !hasMirror ? explainMissingSymmetry(prepared, symmetry, images) : '',
  };
}

/** The larger of the attribute's weight and the painted one at each vertex; at least one of the arrays is there. */
function largerOf(a: Float32Array | null, b: Float32Array | null): Float32Array {
  return a && b ? a.map((weight, vertex) => Math.max(weight, b[vertex])) : (a ?? b)!;
}

/** The attribute's first component per welded vertex, clamped to [0, 1]: the largest among the vertices that were welded. */
function keepWeights(name: string, document: Document, prepared: PreparedBody): Float32Array {
  const weights = new Float32Array(vertexCount(prepared.mesh));
  const { vertexOfSource } = prepared.weld;
  firstComponents(name, document, prepared, 'keep').forEach((value, source) => {
    const vertex = vertexOfSource[source];
    if (vertex !== NONE) weights[vertex] = Math.max(weights[vertex], Math.min(1, value));
  });
  return weights;
}
