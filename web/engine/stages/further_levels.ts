/** Stages: the further levels of detail of a body, from the history that is there. */

import type { Measured } from '../body/body_result';
import type { MeshAt } from '../core/core';
import { faceCount } from '../core/mesh';
import { constraintsStage } from './constraints';
import { deviationsStage } from './budget/deviations';
import { errorCurveStage } from './budget/error_curve';
import { facesByRatio } from './budget/face_shares';
import { FIT_SETTINGS, firstFits, fitSettings } from './fit';
import { fitGuarded, unguarded } from './budget/guarded_fit';
import type { GuardFinding } from '../body/body_result';
import { keptHistoryStage } from './kept_history';
import { levelAt } from './level';
import { measureResult } from './measure';
import { preparedStage } from './prepared';
import { declareStage } from './stage';

/** What the collapses alone leave at a further level. */
interface CollapsedLevel {
  targetFaces: number;
  level: MeshAt;
}

const collapsedLevels = declareStage({
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

export interface FurtherLevel {
  targetFaces: number;
  result: MeshAt;
  guard: GuardFinding | null;
  measured: Measured;
}

/** One for each of `lods`, in their order; a target for the frequencies is that of the first level alone. */
export const furtherLevelsStage = declareStage({
  name: 'further levels',
  reads: ['maxDeviation', ...FIT_SETTINGS],
  needs: {
    prepared: preparedStage,
    constraints: constraintsStage,
    kept: keptHistoryStage,
    curve: errorCurveStage,
    deviations: deviationsStage,
    collapsed: collapsedLevels,
  },
  derive: ({ maxDeviation, ...settings }) => ({
    maxDeviation,
    settings: fitSettings({ ...settings, maxDeviation }),
  }),
  run: (
    { core, cache },
    { prepared, constraints, collapsed, ...inputs },
    { maxDeviation: limit, settings },
  ): FurtherLevel[] =>
    collapsed.map(({ targetFaces, level }) => {
      const request = { constraints: constraints.constraints, settings, cache };
      const guarded = { prepared, level: unguarded(level), limit, ...inputs };
      const { result, guard } = fitGuarded(core, guarded, request);
      return { targetFaces, result, guard, measured: measureResult(core, prepared, result) };
    }),
  firstCalls: (_context, { prepared, constraints: { constraints }, collapsed }, { settings }) =>
    firstFits(
      prepared,
      collapsed.map(({ level }) => level),
      { constraints, settings },
    ),
});
