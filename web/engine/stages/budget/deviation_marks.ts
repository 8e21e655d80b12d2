/** Stage: the face counts of a history at which the exported surface has moved by given deviations; the page marks them on its slider. */

import { fittedDeviationsStage } from './fitted_deviations';
import { keptHistoryStage } from '../kept_history';
import { declareStage } from '../stage';

/** The marked deviations, in % of the diagonal. */
export const MARKED_DEVIATIONS = [0.1, 0.5, 1];

export interface DeviationMark {
  /** % of the diagonal */
  deviation: number;
  /** fewest faces found whose deviation is at most that */
  faces: number;
}

/** Face counts within this ratio are the same mark on the slider. */
const CLOSE = 1.02;

export const deviationMarksStage = declareStage({
  name: 'deviation marks',
  reads: [],
  needs: { kept: keptHistoryStage, deviationAt: fittedDeviationsStage },
  run: (_context, { kept, deviationAt }): DeviationMark[] => {
    const { triangleCount: total, trianglesAfter } = kept.history;
    return markDeviations(deviationAt, { floor: trianglesAfter.at(-1) ?? total, total });
  },
});

/**
 * The fewest faces, to 2 %, that stay within each deviation, most faces first; a deviation that even the floor stays within
 * has no mark. `deviationAt` is asked at most once for each face count from `floor` to `total`. It should fall with more
 * faces; where it does not, a mark is at one of its crossings.
 */
export function markDeviations(
  deviationAt: (faces: number) => number,
  { floor, total, deviations = MARKED_DEVIATIONS }: { floor: number; total: number; deviations?: number[] },
): DeviationMark[] {
  const known = new Map([[total, 0]]);
  const at = (faces: number): number => {
    if (!known.has(faces)) known.set(faces, deviationAt(faces));
    return known.get(faces)!;
  };
  if (total <= floor) return [];
  return deviations
    .filter((deviation) => at(floor) > deviation)
    .map((deviation) => ({ deviation, faces: crossing(at, known, { floor, total, deviation }) }));
}

/** Narrows the face counts around the crossing, from those that are known already, by bisecting their ratio. */
function crossing(
  at: (faces: number) => number,
  known: Map<number, number>,
  { floor, total, deviation }: { floor: number; total: number; deviation: number },
): number {
  let [low, high] = [floor, total];
  for (const [faces, value] of [...known].sort(([a], [b]) => a - b))
    if (value > deviation) low = Math.max(low, faces);
  for (const [faces, value] of known) if (value <= deviation && faces > low) high = Math.min(high, faces);
  while (high > CLOSE * low && high > low + 1) {
    const middle = Math.min(high - 1, Math.max(low + 1, Math.round(Math.sqrt(low * high))));
    if (at(middle) > deviation) low = middle;
    else high = middle;
  }
  return high;
}
