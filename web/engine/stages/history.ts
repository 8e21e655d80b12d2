/** Stage: every collapse of the body, in order, down to the fewest faces that are asked for or to the floor. */

import type { PreparedBody } from '../body/prepared_body';
import type { History } from '../core/core';
import { constraintsStage } from './constraints';
import { coreCall, resultOf } from './many_bodies/core_call';
import type { CoreCall } from './many_bodies/core_call';
import { attributeCosts, guidingCurvature, guidingStrain } from './guidance';
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
    costs: attributeCosts,
    guidance: guidingStrain,
    curvature: guidingCurvature,
  },
  derive: ({ fewestFaces, ...settings }): HistorySettings => ({
    ...simplificationSettings(settings),
    stopFaces: fewestFaces,
  }),
  run: ({ core, cache }, { prepared, constraints: { constraints }, ...fields }, settings): History => {
    const call = historyCall(prepared, { constraints, ...fields }, settings);
    const history = resultOf(core, cache, call);
    // The collapses keep mirror images, so that the history has them too.
    const { mirror } = constraints;
    return mirror ? { ...history, mirror } : history;
  },
  firstCalls: (_context, { prepared, constraints: { constraints }, ...fields }, settings) => [
    historyCall(prepared, { constraints, ...fields }, settings),
  ],
});

interface HistorySettings extends SimplificationSettings {
  /** absent: the history goes down to its floor */
  stopFaces?: number;
}

export function historyCall(
  prepared: PreparedBody,
  guides: Guides,
  { stopFaces, ...settings }: HistorySettings,
): CoreCall<'simplify'> {
  const { strain, curvature, options } = simplificationOf(prepared, guides, settings);
  return coreCall('simplify', prepared.mesh, strain, curvature, { ...options, stopFaces });
}
