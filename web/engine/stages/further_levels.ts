/** Stages: the further levels of detail of a body, from the same history. */

import type { Measured } from '../body/body_result';
import type { MeshAt } from '../core/core';
import { faceCount } from '../core/mesh';
import { constraintsStage } from './constraints';
import { deviationsStage } from './budget/deviations';
import { errorCurveStage } from './budget/error_curve';
import { facesByRatio } from './budget/face_shares';
import { FIT_SETTINGS, firstFits, fitSettings } from './fit';
import { firstToFit, fitGuarded } from './budget/guarded_fit';
import { guardIfUnsure } from './budget/guarded_level';
import type { GuardFinding } from '../body/body_result';
import { keptHistoryStage } from './kept_history';
import { levelAt } from './level';
import { measureResult } from './measure';
import { preparedStage } from './prepared';
import { declareStage } from './stage';

/** A further level before its fit. */
interface CollapsedLevel {
  targetFaces: number;
  level: MeshAt;
}

export const collapsedLevelsStage = declareStage({
  name: 'collapsed levels',
  reads: ['lods', 'levelFaces'],
  needs: { prepared: preparedStage, kept: keptHistoryStage },
  run: ({ core }, { prepared, kept }, { lods, levelFaces }) =>
    lods.map((ratio, n): CollapsedLevel => {
      const ofBody = facesByRatio(ratio, faceCount(prepared.mesh));
      const targetFaces = Math.max(1, levelFaces?.[n] ?? ofBody);
      return { targetFaces, level: levelAt(core, kept, targetFaces) };
    }),
});

const guardedLevels = declareStage({
  name: 'guarded levels',
  reads: ['maxDeviation'],
  needs: {
    kept: keptHistoryStage,
    curve: errorCurveStage,
    deviations: deviationsStage,
    collapsed: collapsedLevelsStage,
  },
  run: ({ core }, { collapsed, ...inputs }, { maxDeviation }) =>
    collapsed.map(({ targetFaces, level }) => ({
      targetFaces,
      wanted: level,
      level: guardIfUnsure(core, inputs, level, maxDeviation),
    })),
});

export interface FurtherLevel {
  targetFaces: number;
  result: MeshAt;
  guard: GuardFinding | null;
  measured: Measured;
}

/** One for each of `lods`, in their order; a frequency target applies only to the first level. */
export const furtherLevelsStage = declareStage({
  name: 'further levels',
  reads: ['maxDeviation', ...FIT_SETTINGS],
  needs: {
    prepared: preparedStage,
    constraints: constraintsStage,
    kept: keptHistoryStage,
    curve: errorCurveStage,
    deviations: deviationsStage,
    guarded: guardedLevels,
  },
  derive: ({ maxDeviation, ...settings }) => ({
    maxDeviation,
    settings: fitSettings({ ...settings, maxDeviation }),
  }),
  run: (
    { core, cache, hasFewFaces },
    { prepared, constraints, guarded, ...inputs },
    { maxDeviation: limit, settings },
  ): FurtherLevel[] =>
    guarded.map(({ targetFaces, wanted, level }) => {
      const request = { constraints: constraints.constraints, settings, cache };
      const { result, guard } = fitGuarded(
        core,
        { prepared, wanted, level, limit, hasFewFaces, ...inputs },
        request,
      );
      return { targetFaces, result, guard, measured: measureResult(core, prepared, result) };
    }),
  firstCalls: (_context, { prepared, constraints: { constraints }, guarded }, { settings }) =>
    firstFits(
      prepared,
      guarded.map(({ level }) => firstToFit(level)),
      { constraints, settings },
    ),
});
