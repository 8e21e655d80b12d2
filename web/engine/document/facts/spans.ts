/** Which triangles of a body come from which primitive of its mesh. */

import type { Body } from '../model';

/** The number of the span that a triangle of the body lies in: the last one that begins at or before it. */
export function spanOf({ spans }: Pick<Body, 'spans'>, triangle: number): number {
  let [low, high] = [0, spans.length - 1];
  while (low < high) {
    const middle = (low + high + 1) >>> 1;
    if (spans[middle].first > triangle) high = middle - 1;
    else low = middle;
  }
  return low;
}
