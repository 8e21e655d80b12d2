/** Stage: every collapse of the body, in order, down to the floor. */

import type { PreparedBody } from '../body/prepared_body';
import type { Core, History } from '../core/core';
import { constraintsStage } from './constraints';
import { endWithin } from './deviation_limit';
import { guidingCurvature, guidingStrain } from './guidance';
import { measureDistance } from './measure';
import { preparedStage } from './prepared';
import { SIMPLIFICATION_SETTINGS, simplificationOf, simplificationSettings } from './simplification';
import type { Guides, SimplificationSettings } from './simplification';
import { declareStage } from './stage';

export const historyStage = declareStage({
  name: 'history',
  reads: SIMPLIFICATION_SETTINGS,
  needs: {
    prepared: preparedStage,
    constraints: constraintsStage,
    guidance: guidingStrain,
    curvature: guidingCurvature,
  },
  derive: simplificationSettings,
  run: ({ core }, { prepared, constraints: { constraints }, guidance, curvature }, settings) =>
    buildHistory(core, prepared, { constraints, guidance, curvature }, settings),
});

/** The core judges a largest deviation at samples while edges collapse; here the history ends where it is measured. */
export function buildHistory(
  core: Core,
  prepared: PreparedBody,
  guides: Guides,
  settings: SimplificationSettings,
): History {
  const { strain, curvature, options } = simplificationOf(prepared, guides, settings);
  const simplified = core.simplify(prepared.mesh, strain, curvature, options);
  const { mirror } = guides.constraints;
  const history = mirror ? { ...simplified, mirror } : simplified;
  if (settings.maxDeviation === 0) return history;
  const deviationAt = (faces: number) =>
    measureDistance(core, prepared, core.meshAt(prepared.mesh, history, faces).mesh).hausdorff;
  return endWithin(history, settings.maxDeviation, deviationAt);
}
