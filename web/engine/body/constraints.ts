/** What a simplification holds on to: pinned and locked vertices, keep weights, a mirror symmetry. */

import type { Document } from '@gltf-transform/core';
import { NONE } from '../core/core';
import type { Settings } from '../settings/options';
import { keepOfLevels, lockedIn, paintOn } from './paint';
import { findPins, firstComponents } from './pins';
import type { PreparedBody } from '../stages/pipeline';
import { describeLack } from './symmetry';

/** In terms of the prepared mesh; what is absent is not wished. */
export interface Held {
  /** vertices that keep their outline, held in place in every mode */
  pinned?: Uint32Array;
  /** vertices that neither move nor go */
  locked?: Uint32Array;
  /** per vertex, in [0, 1]: see SimplifyConstraints.keep */
  keep?: Float32Array;
  /** SimplifyConstraints.mirror */
  mirror?: Uint32Array;
}

/**
 * What the settings hold in a body that was prepared with them, and one sentence where a symmetry is wished that it does not
 * have.
 */
export function findHeld(
  document: Document,
  prepared: PreparedBody,
  settings: Settings,
): { held: Held; note: string } {
  const { pins, lock, keep, symmetry } = settings;
  const { images } = prepared;
  const isFound = images !== undefined && images.partners.length > 0;
  const levels = paintOn(settings.paint, prepared);
  const weights = keep === '' ? null : keepWeights(keep, document, prepared);
  const named = findPins(lock, document, prepared, 'lock');
  const held = {
    pinned: findPins(pins, document, prepared),
    locked: levels ? Uint32Array.from(new Set([...named, ...lockedIn(levels)])).sort() : named,
    ...(levels || weights ? { keep: largerOf(weights, levels && keepOfLevels(levels)) } : {}),
    ...(isFound ? { mirror: images.partners } : {}),
  };
  return { held, note: images && !isFound ? describeLack(prepared, symmetry, images) : '' };
}

/** Of the attribute's weights and the painted ones, where both are there. */
function largerOf(a: Float32Array | null, b: Float32Array | null): Float32Array {
  return a && b ? a.map((weight, vertex) => Math.max(weight, b[vertex])) : (a ?? b)!;
}

/** The attribute's first component per welded vertex, the largest of those that were welded, within [0, 1]. */
function keepWeights(name: string, document: Document, prepared: PreparedBody): Float32Array {
  const weights = new Float32Array(prepared.mesh.positions.length / 3);
  const { vertexOfSource } = prepared.weld;
  firstComponents(name, document, prepared, 'keep').forEach((value, source) => {
    const vertex = vertexOfSource[source];
    if (vertex !== NONE) weights[vertex] = Math.max(weights[vertex], Math.min(1, value));
  });
  return weights;
}
