/** Stages: the measurements of the result, and the factor on its stiffness. */

import { MATERIAL_SETTINGS } from '../body/material';
import { calibrationOf } from '../motion/simulation';
import { fittedStage } from './fitted';
import { measureResult } from './measure';
import { preparedStage } from './prepared';
import { declareStage } from './stage';

export const measuredStage = declareStage({
  name: 'measured',
  reads: [],
  needs: { prepared: preparedStage, fitted: fittedStage },
  run: ({ core }, { prepared, fitted }) => measureResult(core, prepared, fitted.result),
});

/** See CalibrationReport. */
export const calibrationStage = declareStage({
  name: 'calibration',
  reads: MATERIAL_SETTINGS,
  needs: { prepared: preparedStage, fitted: fittedStage },
  run: ({ core }, { prepared, fitted }, material) =>
    calibrationOf(core, prepared, fitted.result.mesh, material),
});
