/** In a history that keeps a mirror symmetry, a collapse and its mirror image follow each other and belong together. */

import type { History } from '../core/core';

/** The number of collapses after the first `count` and the next one, including the image of that where it has one. */
export function nextEnd({ kept, removed, mirror }: History, count: number): number {
  const isAlone =
    !mirror || (mirror[kept[count]] === kept[count] && mirror[removed[count]] === removed[count]);
  return Math.min(kept.length, count + (isAlone ? 1 : 2));
}

/** The face count to evaluate a history at for at most `faces` faces, so that no collapse is separated from its image. */
export function wholeFaces(history: History, faces: number): number {
  const whole = history.mirror ? wholePairs(history, faces) : faces;
  return Math.max(0, Math.floor(whole));
}

/** The largest face count up to `faces` that does not separate a pair; `faces` where the floor is above it. */
function wholePairs(history: History, faces: number): number {
  for (let end = 0; end < history.kept.length;) {
    end = nextEnd(history, end);
    const left = history.trianglesAfter[end - 1];
    if (left <= faces) return left;
  }
  return faces;
}
