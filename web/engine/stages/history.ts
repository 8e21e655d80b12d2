/** Stage: every collapse of the body, in order, down to the fewest faces that are asked for or to the floor. */

import type { PreparedBody } from '../body/prepared_body';
import type { Core, History } from '../core/core';
import { constraintsStage } from './constraints';
import { onceIn } from './equal_work';
import { guidingCurvature, guidingStrain } from './guidance';
import { preparedStage } from './prepared';
import { SIMPLIFICATION_SETTINGS, simplificationOf, simplificationSettings } from './simplification';
import type { Guides, SimplificationSettings } from './simplification';
import { declareStage } from './stage';

export const historyStage = declareStage({
  name: 'history',
  reads: [...SIMPLIFICATION_SETTINGS, 'fewestFaces'],
  needs: {
    prepared: preparedStage,
    constraints: constraintsStage,
    guidance: guidingStrain,
    curvature: guidingCurvature,
  },
  derive: ({ fewestFaces, ...settings }): HistorySettings => ({
    ...simplificationSettings(settings),
    stopFaces: fewestFaces,
  }),
  run: ({ core, equalWork }, { prepared, constraints: { constraints }, guidance, curvature }, settings) => {
    const guides = { constraints, guidance, curvature };
    const { mesh, diagonal, attributes, costAttributes } = prepared;
    const inputs = [mesh, diagonal, attributes.charts, costAttributes, guides, settings];
    return onceIn(equalWork, 'history', inputs, () => buildHistory(core, prepared, guides, settings));
  },
});

interface HistorySettings extends SimplificationSettings {
  /** absent: the history goes down to its floor */
  stopFaces?: number;
}

/** The history, with the mirror images that it keeps. */
export function buildHistory(
  core: Core,
  prepared: PreparedBody,
  guides: Guides,
  { stopFaces, ...settings }: HistorySettings,
): History {
  const { strain, curvature, options } = simplificationOf(prepared, guides, settings);
  const simplified = core.simplify(prepared.mesh, strain, curvature, { ...options, stopFaces });
  const { mirror } = guides.constraints;
  return mirror ? { ...simplified, mirror } : simplified;
}
