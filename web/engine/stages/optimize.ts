/**
 * All the verbs of pipeline.ts in order: from a prepared body to the level of its history that the targets lead to.
 */

import type { Core, Curvature, History, MeshAt, ModeSet, StrainGuidance } from '../core/core';
import { searchFaces } from './frequency_target';
import type { FrequencyFinding } from './frequency_target';
import type { Held } from '../body/constraints';
import { methodOf } from '../settings/options';
import type { Settings } from '../settings/options';
import {
  buildHistory,
  findGuidance,
  findModes,
  fitResult,
  materialOf,
  measureResult,
  reduceTo,
  startStopwatch,
} from './pipeline';
import type { FittedResult, Measured, PreparedBody } from './pipeline';

/** Seconds by stage. */
export interface Timings {
  weld: number;
  modes: number;
  /** strain and curvature */
  fields: number;
  /** from the guidance to the whole history */
  simplify: number;
  /** for the count that keeps the frequencies, with everything that is tried on the way */
  search: number;
  /** evaluating the history at the asked count */
  reduce: number;
  /** to the original's modes */
  fit: number;
  measure: number;
}

export interface OptimizedBody {
  prepared: PreparedBody;
  /** null for a method that needs none */
  modes: ModeSet | null;
  guidance: StrainGuidance | null;
  curvature: Curvature;
  history: History;
  targetFaces: number;
  /** the final mesh */
  result: MeshAt;
  fitted: FittedResult;
  /** null where frequencies are no target */
  frequency: FrequencyFinding | null;
  measured: Measured;
  timings: Timings;
}

/** What was asked of a body: how many faces may stay, and what is held. */
export interface Target extends Held {
  targetFaces: number;
  /** called before each number of faces that is tried for the sake of the frequencies */
  onTry?: (faces: number) => void;
}

/** A result of a history, before and after the fit. */
export interface Level {
  reduced: MeshAt;
  fitted: FittedResult;
}

/** The result of at most `targetFaces` faces, fitted where the settings say so. */
export function levelAt(
  core: Core,
  prepared: PreparedBody,
  history: History,
  { settings, targetFaces, ...held }: Target & { settings: Settings },
): Level {
  const reduced = reduceTo(core, prepared, history, targetFaces);
  return { reduced, fitted: fitResult(core, prepared, reduced, { settings, ...held }) };
}

/** The modes that --max-frequency-error looks at. */
const TARGET_MODES = 6;

/**
 * The level of at least `targetFaces` faces that has fewest while each of its first six frequencies, as compareFidelity finds
 * them, is within `settings.maxFrequencyError` of the original's; every level tried is fitted and solved.
 */
export function findFrequencyLevel(
  core: Core,
  prepared: PreparedBody,
  history: History,
  target: Target & { settings: Settings },
): Level & { frequency: FrequencyFinding } {
  const { settings, targetFaces, onTry } = target;
  const options = { modeCount: TARGET_MODES, ...materialOf(prepared, settings) };
  const modes = core.shellModes(prepared.mesh, options);
  const evaluate = (faces: number) => {
    onTry?.(faces);
    const level = levelAt(core, prepared, history, { ...target, targetFaces: faces });
    const { mesh } = level.fitted.result;
    const error = core.frequencyErrors(prepared.mesh, modes, mesh, options).max;
    return { ...level, faces: mesh.triangles.length / 3, error };
  };
  const most = prepared.mesh.triangles.length / 3;
  const range = { fewest: targetFaces, most, limit: settings.maxFrequencyError };
  const { best, finding } = searchFaces(evaluate, range);
  return { reduced: best.reduced, fitted: best.fitted, frequency: finding };
}

/** Everything in order. `targetFaces` says how many of the usable faces may stay. */
export function optimizeBody(
  core: Core,
  prepared: PreparedBody,
  settings: Settings,
  target: Target,
): OptimizedBody {
  const stopwatch = startStopwatch();
  const { needsGuidance } = methodOf(settings);
  const modes = needsGuidance ? findModes(core, prepared, settings, target.pinned) : null;
  const modesTime = stopwatch();
  const guidance = modes ? findGuidance(core, prepared, modes, settings) : null;
  const curvature = core.meanCurvature(prepared.mesh);
  const fields = stopwatch();
  const history = buildHistory(core, prepared, { guidance, curvature, ...target }, settings);
  const simplify = stopwatch();
  const { fitted, frequency, times } = chooseLevel(core, prepared, history, { ...target, settings });
  stopwatch();
  const measured = measureResult(core, prepared, fitted.result);
  const timings = { weld: 0, modes: modesTime, fields, simplify, ...times, measure: stopwatch() };
  const { targetFaces } = target;
  const { result } = fitted;
  return {
    prepared,
    modes,
    guidance,
    curvature,
    history,
    targetFaces,
    result,
    fitted,
    frequency,
    measured,
    timings,
  };
}

/** The level that the targets lead to, and what it has taken. */
function chooseLevel(
  core: Core,
  prepared: PreparedBody,
  history: History,
  target: Target & { settings: Settings },
): {
  fitted: FittedResult;
  frequency: FrequencyFinding | null;
  times: Pick<Timings, 'search' | 'reduce' | 'fit'>;
} {
  const stopwatch = startStopwatch();
  if (target.settings.maxFrequencyError > 0) {
    const { fitted, frequency } = findFrequencyLevel(core, prepared, history, target);
    return { fitted, frequency, times: { search: stopwatch(), reduce: 0, fit: 0 } };
  }
  const reduced = reduceTo(core, prepared, history, target.targetFaces);
  const reduce = stopwatch();
  const fitted = fitResult(core, prepared, reduced, target);
  return { fitted, frequency: null, times: { search: 0, reduce, fit: stopwatch() } };
}
