/** Finds the fewest faces whose frequencies stay within a limit, by evaluating levels of a history. */

import type { FrequencyFinding, Tried } from '../../body/body_result';

/** The search ends where face counts that fail and that succeed are within this ratio. */
const CLOSE = 1.02;
/** Errors do not rise monotonically towards fewer faces, so these shares of the face count that was found are tried as well. */
const PROBES = [0.95, 0.88, 0.75];
/** The number of solves after which no further level is probed. */
const MAX_TRIED = 32;

/**
 * The result with the fewest faces, from `fewest` to `most`, whose error is within the limit; it has itself been evaluated.
 * Bisects ratios of face counts, then probes below what it has found, since errors do not rise monotonically. `evaluate`
 * gives the largest result of at most so many faces; the result of `most`, the original, is within any limit.
 */
export function fewestFacesWithin<T extends Tried>(
  evaluate: (faces: number) => T,
  { fewest, most, limit }: { fewest: number; most: number; limit: number },
): { best: T; finding: FrequencyFinding } {
  const tried: Tried[] = [];
  const attempt = (faces: number): T => {
    const result = evaluate(faces);
    tried.push({ faces: result.faces, error: result.error });
    return result;
  };
  const finish = (best: T, isBinding: boolean) => ({
    best,
    finding: { limit, error: best.error, isBinding, tried },
  });
  const lowest = attempt(fewest);
  if (lowest.error <= limit) return finish(lowest, false);
  let best = bisect(attempt, { failing: lowest.faces, most, limit });
  for (let probe = 0; best && probe < PROBES.length && tried.length < MAX_TRIED;) {
    const found: T = attempt(Math.floor(PROBES[probe] * best.faces));
    if (found.error > limit || found.faces <= lowest.faces) ++probe;
    else {
      const failing = highestFailure(tried, found.faces, limit);
      best = bisect(attempt, { failing, most: found.faces, limit }) ?? found;
      probe = 0;
    }
  }
  return finish(best ?? attempt(most), true);
}

/** The result with the fewest faces found between a failure and `most`; null where only `most` itself succeeds. */
function bisect<T extends Tried>(
  attempt: (faces: number) => T,
  { failing, most, limit }: { failing: number; most: number; limit: number },
): T | null {
  let [low, high]: [number, number] = [failing, most];
  let best: T | null = null;
  while (high > CLOSE * low && high > low + 1) {
    const middle = Math.min(high - 1, Math.max(low + 1, Math.round(Math.sqrt(low * high))));
    const result = attempt(middle);
    if (result.error <= limit && result.faces > low) [high, best] = [result.faces, result];
    else low = middle;
  }
  return best;
}

/** The most faces below `faces` that have failed. */
function highestFailure(tried: Tried[], faces: number, limit: number): number {
  return tried
    .filter((one) => one.error > limit && one.faces < faces)
    .reduce((highest, one) => Math.max(highest, one.faces), 0);
}
