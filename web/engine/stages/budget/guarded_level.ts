/** Stage: the level with the wanted faces, or one with more if its deviation before any fit would exceed the limit. */

import type { Core, MeshAt } from '../../core/core';
import { faceCount } from '../../core/mesh';
import { searchWithinDeviation } from './deviation_limit';
import { compareInParallel, deviationsStage } from './deviations';
import type { Deviations } from './deviations';
import { collapsesWithin, errorCurveStage } from './error_curve';
import type { ErrorCurve } from './error_curve';
import { keptHistoryStage } from '../kept_history';
import type { KeptHistory } from '../kept_history';
import { levelAt, levelStage } from '../level';
import { declareStage } from '../stage';

export interface GuardedLevel {
  result: MeshAt;
  /** whether the level of the wanted faces is beyond the limit */
  isStopped: boolean;
}

/** The inputs of a search over the levels of a body. */
export interface GuardInputs {
  kept: KeptHistory;
  curve: ErrorCurve;
  deviations: Deviations;
}

export const guardedLevelStage = declareStage({
  name: 'guarded level',
  reads: ['targetFaces', 'maxDeviation'],
  needs: { kept: keptHistoryStage, curve: errorCurveStage, deviations: deviationsStage, level: levelStage },
  run: ({ core }, { level, ...inputs }, { maxDeviation }) => guardIfUnsure(core, inputs, level, maxDeviation),
});

/** The level itself if the estimates are safely within the limit; otherwise the result of `guardLevel`. */
export const guardIfUnsure = (core: Core, inputs: GuardInputs, level: MeshAt, limit: number): GuardedLevel =>
  isSurelyWithin(inputs, level, limit)
    ? { result: level, isStopped: false }
    : guardLevel(core, inputs, level, limit);

/** A body is measured unless the estimate of its deviation is below this share of the limit. */
const SURE = 0.5;

/** Whether the level is within the limit by a safe margin according to the estimates of its collapses. */
export function isSurelyWithin({ curve }: GuardInputs, level: MeshAt, limit: number): boolean {
  if (limit === 0) return true;
  const within = collapsesWithin(curve, ((SURE * limit) / 100) * curve.diagonal);
  return curve.faces[curve.ends.indexOf(within)] <= faceCount(level.mesh);
}

/** `level` if it measures within `limit`, in % of the diagonal; otherwise the level with the fewest additional faces that does. */
export function guardLevel(
  core: Core,
  { kept, curve, deviations }: GuardInputs,
  level: MeshAt,
  limit: number,
): GuardedLevel {
  const wanted = faceCount(level.mesh);
  const search = searchLevel({ kept, curve }, wanted, limit);
  let step = search.next();
  while (!step.done)
    step = search.next(deviations.isWithin(step.value, limit, step.value === wanted ? level : undefined));
  const faces = step.value;
  if (faces === wanted) return { result: level, isStopped: false };
  return { result: levelAt(core, kept, faces), isStopped: true };
}

/** `guardLevel` as a generator that yields the face counts of levels to be tested. Returns the face count that it chooses. */
function* searchLevel(
  { kept, curve }: Pick<GuardInputs, 'kept' | 'curve'>,
  wanted: number,
  limit: number,
): Generator<number, number, boolean> {
  if (yield wanted) return wanted;
  const guess = collapsesWithin(curve, (limit / 100) * curve.diagonal);
  return yield* searchWithinDeviation(kept.history, wanted, guess);
}

/** A level for which `guardIfUnsure` is about to be called. */
export interface LevelToGuard extends GuardInputs {
  level: MeshAt;
  /** % of the diagonal; 0: none */
  limit: number;
}

/** Makes the calls of the core for `guardIfUnsure` of many levels in parallel; the deviations of their bodies remember the results. */
export function guardInParallel(core: Core, levels: LevelToGuard[]): void {
  const unsure = levels.filter(({ level, limit, ...inputs }) => !isSurelyWithin(inputs, level, limit));
  const searches = unsure.map((one) => {
    const wanted = faceCount(one.level.mesh);
    const search = searchLevel(one, wanted, one.limit);
    return { ...one, search, step: search.next() };
  });
  for (;;) {
    const open = searches.filter(({ step }) => !step.done);
    if (open.length === 0) break;
    const questions = open.map(({ deviations, limit, step }) => ({ deviations, limit, faces: step.value }));
    compareInParallel(core, questions);
    for (const one of open) one.step = one.search.next(one.deviations.isWithin(one.step.value, one.limit));
  }
}
