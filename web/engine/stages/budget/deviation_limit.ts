/** Finds the level with the fewest faces within a deviation limit, by measuring levels. */

import type { History } from '../../core/core';
import { nextEnd } from '../collapse_pairs';

/** The first step back from a level beyond the limit, as a share of the collapses that lead to it. */
const FIRST_STEP = 1 / 128;
/** The search ends where a level that is within the limit has at most this many times the faces of one that is not. */
const CLOSE = 1.01;

/** A deviation limit as a predicate on levels. */
export interface DeviationLimit {
  /** whether the level of at most `faces` faces is within it */
  isWithin: (faces: number) => boolean;
  /** an estimate of the number of collapses that stay within the limit, which saves measuring */
  guess?: number;
}

/**
 * The fewest faces, at least those of the level at `faces`, whose level is within the limit: to 1 %, and never beyond it. Where the
 * deviation does not fall with more faces, they are at one of its crossings of the limit.
 */
export function facesWithin(history: History, faces: number, { isWithin, guess }: DeviationLimit): number {
  const search = searchWithinDeviation(history, faces, guess);
  let step = search.next();
  while (!step.done) step = search.next(isWithin(step.value));
  return step.value;
}

/** `facesWithin` as a generator that yields the face counts of levels to be tested, so that those of many bodies can be tested together. */
export function* searchWithinDeviation(
  history: History,
  faces: number,
  guess?: number,
): Generator<number, number, boolean> {
  const ends = wholeEnds(history);
  const facesAt = (i: number): number =>
    ends[i] === 0 ? history.triangleCount : history.trianglesAfter[ends[i] - 1];
  const isWithin = function* (i: number): Generator<number, boolean, boolean> {
    return ends[i] === 0 || (yield facesAt(i));
  };
  let bad = ends.findIndex((_, i) => facesAt(i) <= faces);
  if (bad < 0) bad = ends.length - 1;
  if (yield* isWithin(bad)) return facesAt(bad);
  let step = Math.max(1, Math.floor(FIRST_STEP * bad));
  const guessed = guess === undefined ? -1 : ends.findLastIndex((end) => end <= guess);
  let good = guessed >= 0 && guessed < bad ? guessed : Math.max(0, bad - step);
  while (!(yield* isWithin(good))) {
    bad = good;
    good = Math.max(0, bad - step);
    step *= 2;
  }
  while (bad - good > 1 && facesAt(good) > CLOSE * facesAt(bad)) {
    const middle = Math.floor((good + bad) / 2);
    if (yield* isWithin(middle)) good = middle;
    else bad = middle;
  }
  return facesAt(good);
}

/** The share of the faces that the first step of `fewerFacesWithin` removes at least; each further step doubles it. */
const FEWER = 0.02;

/**
 * Steps down from the level at `from`, which is within the limit, to the one at `to` at most, as long as levels stay within it; then
 * bisects the last step. Returns the faces of the last level within the limit: to 1 %, or those of `from` where the first step goes
 * beyond it, which is then the only question. `faces`: of all levels, falling.
 */
export function fewerFacesWithin(
  faces: ArrayLike<number>,
  [from, to]: [from: number, to: number],
  isWithin: (faces: number) => boolean,
): number {
  const last = levelOf(faces, to);
  const first = levelOf(faces, from);
  let [good, bad] = [first, last + 1];
  for (let fewer = FEWER; good < last && bad > last; fewer *= 2) {
    const next = Math.min(last, levelOf(faces, (1 - fewer) * faces[good]));
    if (isWithin(faces[next])) good = next;
    else bad = next;
  }
  if (bad > last || good === first) return faces[good];
  while (bad - good > 1 && faces[good] > CLOSE * faces[bad]) {
    const middle = Math.floor((good + bad) / 2);
    if (isWithin(faces[middle])) good = middle;
    else bad = middle;
  }
  return faces[good];
}

/** The first level with at most `count` faces; the last one where none has. */
function levelOf(faces: ArrayLike<number>, count: number): number {
  let [low, high] = [0, faces.length - 1];
  while (low < high) {
    const middle = Math.floor((low + high) / 2);
    if (faces[middle] <= count) high = middle;
    else low = middle + 1;
  }
  return low;
}

/** Numbers of collapses, ascending from 0, that do not separate a collapse from its mirror image. */
export function wholeEnds(history: History): number[] {
  const ends = [0];
  while (ends[ends.length - 1] < history.kept.length) ends.push(nextEnd(history, ends[ends.length - 1]));
  return ends;
}
