/** Collapses of a history that keeps a mirror symmetry come with their images. */

import type { History } from '../core/core';

/** How many collapses there are after the first `count` and the one that follows, with its image if it has one. */
export function nextEnd({ kept, removed, mirror }: History, count: number): number {
  const isAlone =
    !mirror || (mirror[kept[count]] === kept[count] && mirror[removed[count]] === removed[count]);
  return Math.min(kept.length, count + (isAlone ? 1 : 2));
}
