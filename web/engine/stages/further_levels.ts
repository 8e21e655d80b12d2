/** Stage: the further levels of detail of a body, from the history that is there. */

import type { Measured } from '../body/body_result';
import type { MeshAt } from '../core/core';
import { faceCount } from '../core/mesh';
import { constraintsStage } from './constraints';
import { facesByRatio } from './face_shares';
import { FIT_SETTINGS, fitSettings, fittedLevelAt } from './fit';
import { keptHistoryStage } from './kept_history';
import { measureResult } from './measure';
import { preparedStage } from './prepared';
import { declareStage } from './stage';

export interface FurtherLevel {
  targetFaces: number;
  result: MeshAt;
  measured: Measured;
}

/** One for each of `lods`, in their order; a target for the frequencies is that of the first level alone. */
export const furtherLevelsStage = declareStage({
  name: 'further levels',
  reads: ['lods', ...FIT_SETTINGS],
  needs: { prepared: preparedStage, constraints: constraintsStage, kept: keptHistoryStage },
  derive: ({ lods, ...settings }) => ({ lods, settings: fitSettings(settings) }),
  run: ({ core }, { prepared, constraints: { constraints }, kept }, { lods, settings }) =>
    lods.map((ratio): FurtherLevel => {
      const targetFaces = Math.max(1, facesByRatio(ratio, faceCount(prepared.mesh)));
      const request = { constraints, settings };
      const { result } = fittedLevelAt(core, { prepared, kept }, targetFaces, request);
      return { targetFaces, result, measured: measureResult(core, prepared, result) };
    }),
});
