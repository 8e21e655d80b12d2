/** Stage: the further levels of detail of a body, from the history that is there. */

import type { Measured } from '../body/body_result';
import type { MeshAt } from '../core/core';
import { faceCount } from '../core/mesh';
import { constraintsStage } from './constraints';
import { deviationsStage } from './budget/deviations';
import { errorCurveStage } from './budget/error_curve';
import { facesByRatio } from './budget/face_shares';
import { FIT_SETTINGS, fitSettings } from './fit';
import { fitGuarded, unguarded } from './budget/guarded_fit';
import type { GuardFinding } from '../body/body_result';
import { keptHistoryStage } from './kept_history';
import { levelAt } from './level';
import { measureResult } from './measure';
import { preparedStage } from './prepared';
import { declareStage } from './stage';

export interface FurtherLevel {
  targetFaces: number;
  result: MeshAt;
  guard: GuardFinding | null;
  measured: Measured;
}

/** One for each of `lods`, in their order; a target for the frequencies is that of the first level alone. */
export const furtherLevelsStage = declareStage({
  name: 'further levels',
  reads: ['lods', 'levelFaces', 'maxDeviation', ...FIT_SETTINGS],
  needs: {
    prepared: preparedStage,
    constraints: constraintsStage,
    kept: keptHistoryStage,
    curve: errorCurveStage,
    deviations: deviationsStage,
  },
  derive: ({ lods, levelFaces, maxDeviation, ...settings }) => ({
    lods,
    levelFaces,
    maxDeviation,
    settings: fitSettings({ ...settings, maxDeviation }),
  }),
  run: ({ core }, { prepared, constraints, ...inputs }, { lods, levelFaces, maxDeviation, settings }) =>
    lods.map((ratio, n): FurtherLevel => {
      const ofBody = facesByRatio(ratio, faceCount(prepared.mesh));
      const targetFaces = Math.max(1, levelFaces?.[n] ?? ofBody);
      const level = unguarded(levelAt(core, inputs.kept, targetFaces));
      const request = { constraints: constraints.constraints, settings };
      const guarded = { prepared, level, limit: maxDeviation, ...inputs };
      const { result, guard } = fitGuarded(core, guarded, request);
      return { targetFaces, result, guard, measured: measureResult(core, prepared, result) };
    }),
});
