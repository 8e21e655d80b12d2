/** Fits a level and sees to it that the surface stays near enough. */

import type { FittedResult, GuardFinding } from '../../body/body_result';
import type { PreparedBody } from '../../body/prepared_body';
import type { Core } from '../../core/core';
import { fitResult } from '../fit';
import type { FitRequest } from '../fit';
import { guardLevel } from './guarded_level';
import type { GuardedLevel, GuardInputs } from './guarded_level';
import { isWithinDeviation } from '../measure';

export interface GuardedFit extends GuardInputs {
  prepared: PreparedBody;
  level: GuardedLevel;
  /** % of the diagonal; 0: none */
  limit: number;
}

/**
 * The level, fitted. Where that is too far from the original after all, although the estimates left no doubt, one of more faces is
 * measured and fitted instead.
 */
export function fitGuarded(
  core: Core,
  { prepared, level, limit, ...inputs }: GuardedFit,
  request: FitRequest,
): FittedResult & { guard: GuardFinding | null } {
  const fitted = fitResult(core, prepared, level.result, request);
  const isTooFar = () => !isWithinDeviation(core, prepared, fitted.result.mesh, limit);
  if (limit === 0 || level.guard || !isTooFar()) return { ...fitted, guard: level.guard };
  const { result, guard } = guardLevel(core, inputs, level.result, limit);
  return { ...fitResult(core, prepared, result, request), guard };
}
