/** Stage: the result of the body, which is exported. */

import type { FittedResult, FrequencyFinding, GuardFinding } from '../body/body_result';
import { faceCount } from '../core/mesh';
import { constraintsStage } from './constraints';
import type { Settings } from '../settings/options';
import { deviationsStage } from './budget/deviations';
import { errorCurveStage } from './budget/error_curve';
import { FIT_SETTINGS, firstFits, fitSettings } from './fit';
import { findFrequencyLevel } from './budget/frequency_level';
import type { FrequencyTarget } from './budget/frequency_level';
import { findGuard, firstToFit, fitGuarded } from './budget/guarded_fit';
import { guardedLevelStage } from './budget/guarded_level';
import { keptHistoryStage } from './kept_history';
import { levelStage } from './level';
import { preparedStage } from './prepared';
import { declareStage } from './stage';
import { TUNE_SETTINGS, tuneSettings } from './tune';

export interface FittedLevel extends FittedResult {
  /** null without a frequency target */
  frequency: FrequencyFinding | null;
  /** null unless the deviation limit stopped it */
  guard: GuardFinding | null;
}

function frequencyTarget(
  settings: Pick<Settings, (typeof TUNE_SETTINGS)[number] | 'maxFrequencyError'> & { targetFaces: number },
): FrequencyTarget | null {
  const { young, poisson, density, thickness, unit, targetFaces, maxFrequencyError } = settings;
  if (maxFrequencyError === 0) return null;
  const { solver, tune, engine, bendRatio, massRule } = settings;
  const material = { young, poisson, density, thickness, unit };
  const asked = { solver, tune, engine, bendRatio, massRule, ...material };
  return { targetFaces, maxFrequencyError, material, tune: tuneSettings(asked) };
}

/** The fitted level with `targetFaces`, or one with more faces if the frequency errors would be too large. */
export const fittedStage = declareStage({
  name: 'fitted',
  reads: [...FIT_SETTINGS, ...TUNE_SETTINGS, 'maxFrequencyError', 'targetFaces'],
  needs: {
    prepared: preparedStage,
    constraints: constraintsStage,
    kept: keptHistoryStage,
    wanted: levelStage,
    level: guardedLevelStage,
    curve: errorCurveStage,
    deviations: deviationsStage,
  },
  derive: (settings) => {
    const { method, fit, seams, maxDeviation, minAngle, thickness, poisson } = settings;
    const ofFit = { method, fit, seams, maxDeviation, minAngle, thickness, poisson };
    return { fit: fitSettings(ofFit), frequency: frequencyTarget(settings), maxDeviation };
  },
  run: (context, { constraints, ...inputs }, { fit, frequency, maxDeviation }): FittedLevel => {
    const { prepared, kept, level } = inputs;
    const { cache, hasFewFaces } = context;
    const request = { constraints: constraints.constraints, settings: fit, cache };
    if (!frequency) {
      const guarded = fitGuarded(context.core, { ...inputs, hasFewFaces, limit: maxDeviation }, request);
      return { ...guarded, frequency: null };
    }
    const target = { ...frequency, targetFaces: faceCount(level.result.mesh) };
    const found = findFrequencyLevel(context, { prepared, kept }, request, target);
    const isGuarded = level.isStopped && !found.frequency.isBinding;
    const guard = isGuarded ? findGuard(context.core, prepared, found.result, maxDeviation) : null;
    return { ...found, guard };
  },
  firstCalls: (_context, { prepared, constraints: { constraints }, level }, { fit, frequency }) =>
    frequency ? [] : firstFits(prepared, [firstToFit(level)], { constraints, settings: fit }),
});
