/** Stage: the level of the wanted faces, or one of more faces where the surface would be too far from the original before any fit. */

import type { Core, MeshAt } from '../../core/core';
import { faceCount } from '../../core/mesh';
import { searchWithinDeviation } from './deviation_limit';
import { askInParallel, deviationsStage } from './deviations';
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

/** What is known of a body where its levels are searched. */
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

/** The level as it is where the estimates leave no doubt; elsewhere by `guardLevel`. */
export const guardIfUnsure = (core: Core, inputs: GuardInputs, level: MeshAt, limit: number): GuardedLevel =>
  isSurelyWithin(inputs, level, limit)
    ? { result: level, isStopped: false }
    : guardLevel(core, inputs, level, limit);

/** A body is measured where the estimate of its deviation is not below this share of the limit. */
const SURE = 0.5;

/** Whether the estimates of the collapses leave no doubt that the level is within the limit. */
export function isSurelyWithin({ curve }: GuardInputs, level: MeshAt, limit: number): boolean {
  if (limit === 0) return true;
  const within = collapsesWithin(curve, ((SURE * limit) / 100) * curve.diagonal);
  return curve.faces[curve.ends.indexOf(within)] <= faceCount(level.mesh);
}

/** `level` if it is measured to be within `limit`, in % of the diagonal; otherwise one of as few more faces as can be. */
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

/** The questions of `guardLevel`: the faces of levels that may be within the limit. Returns the faces of the level that it takes. */
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
    askInParallel(core, questions);
    for (const one of open) one.step = one.search.next(one.deviations.isWithin(one.step.value, one.limit));
  }
}
