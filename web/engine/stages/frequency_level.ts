/** Finds the level that keeps the frequencies: every level that is tried is fitted and solved. */

import type { FittedResult, FrequencyFinding } from '../body/body_result';
import { materialOf } from '../body/material';
import type { MaterialSettings } from '../body/material';
import type { PreparedBody } from '../body/prepared_body';
import { faceCount } from '../core/mesh';
import { fittedLevelAt } from './fit';
import type { FitRequest } from './fit';
import { searchFaces } from './frequency_target';
import type { KeptHistory } from './kept_history';
import type { RunContext } from './stage';

/** The modes that --max-frequency-error looks at. */
const TARGET_MODES = 6;

export interface FrequencyTarget {
  /** the fewest faces that other targets allow */
  targetFaces: number;
  /** % */
  maxFrequencyError: number;
  material: MaterialSettings;
}

/**
 * The fitted level with the fewest faces, at least `targetFaces`, at which each of the first six frequencies, as
 * compareFidelity finds them, is within `maxFrequencyError` of the original's.
 */
export function findFrequencyLevel(
  { core, onTry }: RunContext,
  { prepared, kept }: { prepared: PreparedBody; kept: KeptHistory },
  request: FitRequest,
  { targetFaces, maxFrequencyError: limit, material }: FrequencyTarget,
): FittedResult & { frequency: FrequencyFinding } {
  const options = { modeCount: TARGET_MODES, ...materialOf(prepared, material) };
  const modes = core.shellModes(prepared.mesh, options);
  const evaluate = (faces: number) => {
    onTry?.(faces);
    const fitted = fittedLevelAt(core, { prepared, kept }, faces, request);
    const { mesh } = fitted.result;
    const error = core.frequencyErrors(prepared.mesh, modes, mesh, options).max;
    return { fitted, faces: faceCount(mesh), error };
  };
  const range = { fewest: targetFaces, most: faceCount(prepared.mesh), limit };
  const { best, finding } = searchFaces(evaluate, range);
  return { ...best.fitted, frequency: finding };
}
