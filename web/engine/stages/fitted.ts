/** Stage: the result of the body, which is exported. */

import type { FittedResult, FrequencyFinding } from '../body/body_result';
import { constraintsStage } from './constraints';
import type { Settings } from '../settings/options';
import { FIT_SETTINGS, fitResult, fitSettings } from './fit';
import { findFrequencyLevel } from './frequency_level';
import type { FrequencyTarget } from './frequency_level';
import { keptHistoryStage } from './kept_history';
import { levelStage } from './level';
import { preparedStage } from './prepared';
import { declareStage, where } from './stage';
import { TUNE_SETTINGS, tuneSettings } from './tune';

export interface FittedLevel extends FittedResult {
  /** null where frequencies are no target */
  frequency: FrequencyFinding | null;
}

/** Where frequencies are a target, the search evaluates its own levels. */
const givenLevel = where(
  levelStage,
  ['maxFrequencyError'],
  ({ maxFrequencyError }) => maxFrequencyError === 0,
);

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

/** The level of `targetFaces`, or one of more faces where frequencies would be off too far, fitted to the modes. */
export const fittedStage = declareStage({
  name: 'fitted',
  reads: [...FIT_SETTINGS, ...TUNE_SETTINGS, 'maxFrequencyError', 'targetFaces'],
  needs: {
    prepared: preparedStage,
    constraints: constraintsStage,
    kept: keptHistoryStage,
    level: givenLevel,
  },
  derive: (settings) => {
    const { method, fit, seams, maxDeviation, minAngle, thickness, poisson } = settings;
    const ofFit = { method, fit, seams, maxDeviation, minAngle, thickness, poisson };
    return { fit: fitSettings(ofFit), frequency: frequencyTarget(settings) };
  },
  run: (context, inputs, { fit, frequency }): FittedLevel => {
    const { prepared, kept, level } = inputs;
    const request = { constraints: inputs.constraints.constraints, settings: fit };
    if (frequency) return findFrequencyLevel(context, { prepared, kept }, request, frequency);
    return { ...fitResult(context.core, prepared, level!, request), frequency: null };
  },
});
