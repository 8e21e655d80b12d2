/** Stage: what keeps each vertex of a level. */

import { wholeFaces } from './collapse_pairs';
import { constraintsStage } from './constraints';
import { attributeCosts, guidingCurvature, guidingStrain } from './guidance';
import { keptHistoryStage } from './kept_history';
import { preparedStage } from './prepared';
import { SIMPLIFICATION_SETTINGS, simplificationOf, simplificationSettings } from './simplification';
import { declareStage } from './stage';

/** In the order of the vertices of the level at `targetFaces`. */
export const explanationStage = declareStage({
  name: 'explanation',
  reads: [...SIMPLIFICATION_SETTINGS, 'targetFaces'],
  needs: {
    prepared: preparedStage,
    constraints: constraintsStage,
    costs: attributeCosts,
    guidance: guidingStrain,
    curvature: guidingCurvature,
    kept: keptHistoryStage,
  },
  derive: ({ targetFaces, ...settings }) => ({ targetFaces, settings: simplificationSettings(settings) }),
  run: ({ core }, inputs, { targetFaces, settings }) => {
    const { prepared, costs, guidance, curvature, kept } = inputs;
    const guides = { constraints: inputs.constraints.constraints, costs, guidance, curvature };
    const simplification = simplificationOf(prepared, guides, settings);
    const reduction = { ...simplification, mesh: kept.meshHandle, history: kept.historyHandle };
    return core.whyKept(reduction, wholeFaces(kept.history, targetFaces));
  },
});
