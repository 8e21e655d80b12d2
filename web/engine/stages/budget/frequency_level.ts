/** Finds the level with the fewest faces that keeps the frequencies, by fitting levels and solving for their modes. */

import type { FittedResult, FrequencyFinding } from '../../body/body_result';
import { materialOf } from '../../body/material';
import type { MaterialSettings } from '../../body/material';
import type { PreparedBody } from '../../body/prepared_body';
import type { Core, MeshAt } from '../../core/core';
import { faceCount } from '../../core/mesh';
import { fittedLevelAt } from '../fit';
import type { FitRequest } from '../fit';
import { fewestFacesWithin } from './frequency_target';
import type { KeptHistory } from '../kept_history';
import type { RunContext } from '../stage';
import { tunedErrorOf } from '../tune';
import type { TuneSettings } from '../tune';

/** The number of modes that --max-frequency-error applies to. */
const TARGET_MODES = 6;

export interface FrequencyTarget {
  /** the fewest faces that other targets allow */
  targetFaces: number;
  /** % */
  maxFrequencyError: number;
  material: MaterialSettings;
  /** the solver in which the frequencies are judged, tuned; null: as shells, untouched */
  tune: TuneSettings | null;
}

/**
 * The fitted level with the fewest faces, at least `targetFaces`, at which the frequencies are within `maxFrequencyError` of the
 * original's: each of the first six, as compareFidelity finds them; with a solver the first ten there on average, tuned.
 */
export function findFrequencyLevel(
  { core, onTry }: RunContext,
  { prepared, kept }: { prepared: PreparedBody; kept: KeptHistory },
  request: FitRequest,
  target: FrequencyTarget,
): FittedResult & { frequency: FrequencyFinding } {
  const errorOf = target.tune
    ? tunedErrors(core, prepared, request, target.tune)
    : shellErrors(core, prepared, target.material);
  const evaluate = (faces: number) => {
    onTry?.(faces);
    const fitted = fittedLevelAt(core, { prepared, kept }, faces, request);
    return { fitted, faces: faceCount(fitted.result.mesh), error: errorOf(fitted.result) };
  };
  const range = {
    fewest: target.targetFaces,
    most: faceCount(prepared.mesh),
    limit: target.maxFrequencyError,
  };
  const { best, finding } = fewestFacesWithin(evaluate, range);
  return { ...best.fitted, frequency: finding };
}

type ErrorOf = (result: MeshAt) => number;

function shellErrors(core: Core, prepared: PreparedBody, material: MaterialSettings): ErrorOf {
  const options = { modeCount: TARGET_MODES, ...materialOf(prepared, material) };
  const modes = core.shellModes(prepared.mesh, options);
  return ({ mesh }) => core.frequencyErrors(prepared.mesh, modes, mesh, options).max;
}

function tunedErrors(
  core: Core,
  prepared: PreparedBody,
  { constraints }: FitRequest,
  settings: TuneSettings,
): ErrorOf {
  const pinned = constraints.pinned ?? new Uint32Array();
  return (result) => tunedErrorOf(core, prepared, { result, pinned }, settings);
}
