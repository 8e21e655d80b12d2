/** The fewest faces whose frequencies stay within a limit, found along a history by solving for them. */

/** A number of faces that was tried. */
export interface Tried {
  faces: number;
  /** the largest frequency error there, in % */
  error: number;
}

export interface FrequencyFinding {
  /** that was asked for, in % */
  limit: number;
  /** at the faces that were found: of the first six modes, in % */
  error: number;
  /** whether fewer faces would have been enough for everything else */
  isBinding: boolean;
  /** in the order of the search */
  tried: Tried[];
}

/** The search ends where the faces that fail are this close to those that hold. */
const CLOSE = 1.02;
/** Errors do not rise evenly towards fewer faces: these shares of the faces found are tried as well. */
const PROBES = [0.95, 0.88, 0.75];
/** After so many solves the best one so far has to do. */
const MOST_TRIED = 32;

/**
 * The result with fewest faces, from `fewest` up to `most`, whose error is within the limit; it has been evaluated itself.
 * Bisects in proportion, then looks below what it has found, for errors do not rise evenly. `evaluate` gives the largest
 * result of at most so many faces; the result of `most`, the input itself, is within any limit.
 */
export function searchFaces<T extends Tried>(
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
  for (let probe = 0; best && probe < PROBES.length && tried.length < MOST_TRIED;) {
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

/** The result with fewest faces that was found between a failure and `most`; null where none but `most` itself holds. */
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
