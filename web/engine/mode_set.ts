/** Questions to a set of modes. */

import type { ModeSet } from './core';

/** Elastic modes of the component that has most; layers from here on are empty. */
export function modesAvailable({ components }: ModeSet): number {
  return components.reduce((most, { modeCount }) => Math.max(most, modeCount), 0);
}
