/** Fits a level within a deviation limit. */

import type { FittedResult, GuardFinding } from '../../body/body_result';
import type { PreparedBody } from '../../body/prepared_body';
import type { Core, MeshAt } from '../../core/core';
import { faceCount } from '../../core/mesh';
import { fitResult, fitWithinDeviation } from '../fit';
import type { FitRequest } from '../fit';
import { levelAt } from '../level';
import { isWithinDeviation, measureDistance } from '../measure';
import { fewerFacesWithin } from './deviation_limit';
import { guardLevel } from './guarded_level';
import type { GuardedLevel, GuardInputs } from './guarded_level';

export interface GuardedFit extends GuardInputs {
  prepared: PreparedBody;
  /** the level of the wanted faces */
  wanted: MeshAt;
  /** that level, guarded before the fit */
  level: GuardedLevel;
  /** % of the diagonal; 0: none */
  limit: number;
  /** see RunContext */
  hasFewFaces?: boolean;
}

/**
 * The fitted level. If it exceeds the limit although its estimates were safe, one with more faces is
 * taken instead; if the level has more faces than wanted and its fit stays below the limit, one with fewer.
 */
export function fitGuarded(
  core: Core,
  body: GuardedFit,
  request: FitRequest,
): FittedResult & { guard: GuardFinding | null } {
  const { prepared, level, limit, wanted } = body;
  const fitOf = (result: MeshAt): FittedResult =>
    fitResult(core, prepared, result, { ...request, isNearLimit: level.isStopped });
  const isWithin = ({ mesh }: MeshAt): boolean => isWithinDeviation(core, prepared, mesh, limit);
  const first = fitOf(level.result);
  if (limit === 0 || (!level.isStopped && isWithin(first.result))) return { ...first, guard: null };
  const stopped = level.isStopped ? first : fitOf(guardLevel(core, body, level.result, limit).result);
  const fitted = withFewerFaces(core, body, stopped, request);
  if (faceCount(fitted.result.mesh) <= faceCount(wanted.mesh)) return { ...fitted, guard: null };
  return { ...fitted, guard: findGuard(core, prepared, fitted.result, limit) };
}

/** The report on a result that the limit stopped; null otherwise. */
export const findGuard = (
  core: Core,
  prepared: PreparedBody,
  { mesh }: MeshAt,
  limit: number,
): GuardFinding => ({
  limit,
  deviation: measureDistance(core, prepared, mesh).hausdorff,
});

/** The level with the fewest faces, between those of `stopped` and the wanted number, whose fit is within the limit. */
function withFewerFaces(
  core: Core,
  { prepared, kept, curve, wanted, hasFewFaces }: GuardedFit,
  stopped: FittedResult,
  { settings, ...request }: FitRequest,
): FittedResult {
  if (settings === null || hasFewFaces) return stopped;
  let fewest = stopped;
  fewerFacesWithin(curve.faces, [faceCount(stopped.result.mesh), faceCount(wanted.mesh)], (faces) => {
    const level = levelAt(core, kept, faces);
    const fitted = fitWithinDeviation(core, prepared, level, { ...request, settings });
    fewest = fitted ?? fewest;
    return fitted !== null;
  });
  return fewest;
}

/** The first fit of `fitGuarded`, for `firstFits`. */
export const firstToFit = ({
  result,
  isStopped,
}: GuardedLevel): { result: MeshAt; isNearLimit: boolean } => ({
  result,
  isNearLimit: isStopped,
});
