/** Stage: the result of the body, which is exported. */

import type { FittedResult, FrequencyFinding } from '../body/body_result';
import { MATERIAL_SETTINGS } from '../body/material';
import { constraintsStage } from './constraints';
import { FIT_SETTINGS, fitResult, fitSettings } from './fit';
import { findFrequencyLevel } from './frequency_level';
import { keptHistoryStage } from './kept_history';
import { levelStage } from './level';
import { preparedStage } from './prepared';
import { declareStage, where } from './stage';

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

/** The level of `targetFaces`, or one of more faces where frequencies would be off too far, fitted. */
export const fittedStage = declareStage({
  name: 'fitted',
  reads: [...FIT_SETTINGS, ...MATERIAL_SETTINGS, 'maxFrequencyError', 'targetFaces'],
  needs: {
    prepared: preparedStage,
    constraints: constraintsStage,
    kept: keptHistoryStage,
    level: givenLevel,
  },
  derive: ({ young, density, unit, maxFrequencyError, targetFaces, ...settings }) => {
    const { thickness, poisson } = settings;
    const material = { young, poisson, density, thickness, unit };
    const frequency = maxFrequencyError > 0 ? { targetFaces, maxFrequencyError, material } : null;
    return { fit: fitSettings(settings), frequency };
  },
  run: (context, inputs, { fit, frequency }): FittedLevel => {
    const { prepared, kept, level } = inputs;
    const request = { constraints: inputs.constraints.constraints, settings: fit };
    if (frequency) return findFrequencyLevel(context, { prepared, kept }, request, frequency);
    return { ...fitResult(context.core, prepared, level!, request), frequency: null };
  },
});
