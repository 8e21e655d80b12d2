/** Stage: the level of the wanted faces, or one of more faces where the surface would be too far from the original. */

import type { GuardFinding } from '../../body/body_result';
import type { Core, MeshAt } from '../../core/core';
import { faceCount } from '../../core/mesh';
import { facesWithin } from './deviation_limit';
import { deviationsStage } from './deviations';
import type { Deviations } from './deviations';
import { collapsesWithin, errorCurveStage } from './error_curve';
import type { ErrorCurve } from './error_curve';
import { keptHistoryStage } from '../kept_history';
import type { KeptHistory } from '../kept_history';
import { levelAt, levelStage } from '../level';
import { declareStage } from '../stage';

export interface GuardedLevel {
  result: MeshAt;
  /** null where the wanted faces are within the limit, or there is none */
  guard: GuardFinding | null;
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
  run: ({ core }, { level, ...inputs }, { maxDeviation }): GuardedLevel =>
    isSurelyWithin(inputs, level, maxDeviation)
      ? { result: level, guard: null }
      : guardLevel(core, inputs, level, maxDeviation),
});

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
  const isWithin = (faces: number): boolean => deviations.isWithin(faces, limit);
  const wanted = faceCount(level.mesh);
  if (deviations.isWithin(wanted, limit, level)) return { result: level, guard: null };
  const guess = collapsesWithin(curve, (limit / 100) * curve.diagonal);
  const faces = facesWithin(kept.history, wanted, { isWithin, guess });
  const result = levelAt(core, kept, faces);
  return { result, guard: { limit, deviation: deviations.at(faces, result) } };
}
