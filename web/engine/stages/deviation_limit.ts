/** Ends a history at its largest deviation as it is measured: while edges collapse, deviations are judged at samples alone. */

import type { History } from '../core/core';
import { nextEnd } from './collapse_pairs';

/** The first step back from the end, as a share of all collapses. */
const FIRST_STEP = 1 / 256;

/**
 * The history, ended where its measured surface is still within `limit`. `deviationAt` gives the deviation of the result of
 * at most so many faces. It should fall with more faces; where it does not, the end is at one of its crossings of the limit.
 */
export function endWithin(history: History, limit: number, deviationAt: (faces: number) => number): History {
  const ends = wholeEnds(history);
  const isWithin = (i: number): boolean =>
    ends[i] === 0 || deviationAt(history.trianglesAfter[ends[i] - 1]) <= limit;
  let bad = ends.length - 1;
  if (isWithin(bad)) return history;
  let step = Math.max(1, Math.floor(FIRST_STEP * ends.length));
  let good = Math.max(0, bad - step);
  while (!isWithin(good)) {
    bad = good;
    step *= 2;
    good = Math.max(0, bad - step);
  }
  while (bad - good > 1) {
    const middle = Math.floor((good + bad) / 2);
    if (isWithin(middle)) good = middle;
    else bad = middle;
  }
  return { ...firstCollapses(history, ends[good]), stop: 'deviation' };
}

/** Numbers of collapses, ascending from 0, that do not separate a collapse from its mirror image. */
function wholeEnds(history: History): number[] {
  const ends = [0];
  while (ends[ends.length - 1] < history.kept.length) ends.push(nextEnd(history, ends[ends.length - 1]));
  return ends;
}

function firstCollapses(history: History, count: number): History {
  return {
    ...history,
    kept: history.kept.slice(0, count),
    removed: history.removed.slice(0, count),
    positions: history.positions.slice(0, 3 * count),
    trianglesAfter: history.trianglesAfter.slice(0, count),
  };
}
