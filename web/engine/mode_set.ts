/** Questions to a set of modes. */

import type { ModeSet } from './core';

/** Elastic modes of the component that has most; layers from here on are empty. */
export function modesAvailable({ components }: ModeSet): number {
  return components.reduce((most, { modeCount }) => Math.max(most, modeCount), 0);
}

/** Of the largest copy that was solved in the place of a part; 0 where all were solved as they are. */
export function coarseVerticesOf({ components }: ModeSet): number {
  return components.reduce((most, { coarseVertices }) => Math.max(most, coarseVertices), 0);
}
