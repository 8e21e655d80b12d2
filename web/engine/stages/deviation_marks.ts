/** Stage: the face counts of a history at which the surface has moved by given deviations; the page marks them on its slider. */

import { historyStage } from './history';
import { keptHistoryStage } from './kept_history';
import { levelAt } from './level';
import { measureDistance } from './measure';
import { preparedStage } from './prepared';
import { declareStage } from './stage';

/** Per cent of the diagonal. */
export const MARKED_DEVIATIONS = [0.1, 0.5, 1];

export interface DeviationMark {
  /** % of the diagonal */
  deviation: number;
  /** fewest faces found whose deviation is at most that */
  faces: number;
}

/** Face counts within this ratio are the same mark on the slider. */
const CLOSE = 1.02;

/** Deviations of a history by face count, filled while marks are searched: a cancelled search goes on from there. */
const knownDeviations = declareStage({
  name: 'known deviations',
  reads: [],
  needs: { history: historyStage },
  run: () => new Map<number, number>(),
});

export const deviationMarksStage = declareStage({
  name: 'deviation marks',
  reads: [],
  needs: { prepared: preparedStage, kept: keptHistoryStage, known: knownDeviations },
  run: ({ core }, { prepared, kept, known }): DeviationMark[] => {
    const deviationAt = (faces: number): number => {
      const measure = () => measureDistance(core, prepared, levelAt(core, kept, faces).mesh).hausdorff;
      const deviation = known.get(faces) ?? measure();
      known.set(faces, deviation);
      return deviation;
    };
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
