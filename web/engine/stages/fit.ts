/** Fits a level of the history to the original: to its surface, or to its modes as well. */

import type { BodyConstraints } from '../body/constraints';
import type { FittedResult } from '../body/body_result';
import { thicknessOf } from '../body/material';
import type { PreparedBody } from '../body/prepared_body';
import { maskOf } from '../body/vertex_mask';
import type { Core, Fitted, MeshAt, ShapeFitOptions, TriangleMesh } from '../core/core';
import { describeUnfitted } from '../report/fit_words';
import { fitOf } from '../settings/options';
import type { Settings } from '../settings/options';
import { coreCall, resultOf } from './many_bodies/core_call';
import type { CoreCall } from './many_bodies/core_call';
import type { ValueCache } from './many_bodies/value_cache';
import type { KeptHistory } from './kept_history';
import { levelAt } from './level';
import { estimateMean, isWithinDeviation, measureDeviation, measureDistance } from './measure';

export const FIT_SETTINGS = [
  'method',
  'fit',
  'seams',
  'maxDeviation',
  'minAngle',
  'thickness',
  'poisson',
] as const;

type AllSettings = Pick<Settings, (typeof FIT_SETTINGS)[number]>;

type Limits = Pick<AllSettings, 'seams' | 'maxDeviation' | 'minAngle'>;
type ShellSettings = Pick<AllSettings, 'thickness' | 'poisson'>;

/** The settings of a fit; a fit to the surface does not depend on the shell. */
export interface FitSettings extends Limits {
  /** null: the fit is to the surface alone */
  shell: ShellSettings | null;
}

/** The settings that the fit depends on; null: results are not fitted. */
export function fitSettings(settings: AllSettings): FitSettings | null {
  const fit = fitOf(settings);
  if (fit === 'off') return null;
  const { seams, maxDeviation, minAngle, thickness, poisson } = settings;
  return { seams, maxDeviation, minAngle, shell: fit === 'modal' ? { thickness, poisson } : null };
}

/** The inputs of a fit. */
export interface FitRequest {
  constraints: BodyConstraints;
  /** null: no fit */
  settings: FitSettings | null;
  /** whether the result is so close to its deviation limit that a fit without the limit is not worth trying first */
  isNearLimit?: boolean;
  /** see RunContext */
  cache?: ValueCache;
}

/**
 * The shares of a limit of the deviation that fits may use, tried in turn. A fit measures at samples; if these miss too much, the
 * last share leaves a margin.
 */
const DEVIATION_SHARES = [1, 0.85];

/** A limit has lost less than this factor by its conversion to units of the mesh and back. */
const ROUNDED = 1 - 1e-9;

/** % of the diagonal: smaller distances are rounding errors of float32 positions. */
const ROUNDING = 1e-4;

/** The factors by which a fit to the surface, which makes triangles more even, may raise the distances from the original. */
const GROWTH = { mean: 1.1, hausdorff: 1.5 };

/**
 * The result, fitted to the original's surface, or with `shell` to its modes as well. Pinned and locked vertices stay where they are, and a mirror symmetry is kept.
 * If the fit would violate the largest deviation or the smallest angle of the settings, or if a fit to the surface would end
 * further from the original than it began by more than `GROWTH`, the result is returned unfitted.
 */
export function fitResult(
  core: Core,
  prepared: PreparedBody,
  result: MeshAt,
  request: FitRequest,
): FittedResult {
  if (request.settings === null) return unfitted(result, 'off', '');
  const { settings, isNearLimit } = request;
  let objection = '';
  for (let limit: number | null = firstLimit(settings, isNearLimit); limit !== null;) {
    const fitted = fitWithin(core, prepared, result, { ...request, settings, limit });
    objection = objectionTo(core, prepared, [result.mesh, fitted.result.mesh], settings);
    if (objection === '') return asFitted(fitted, settings);
    const whole = wholeLimit(core, prepared, result, settings);
    limit = nextLimit(limit, whole, measureDeviation(core, prepared, fitted.result.mesh));
  }
  return unfitted(result, kindOf(settings), objection);
}

/** Why a fit is not kept, as a clause; empty if it is. */
function objectionTo(
  core: Core,
  prepared: PreparedBody,
  meshes: BeforeAndAfter,
  settings: FitSettings,
): string {
  if (!keepsAngle(core, meshes, settings) || !keepsDeviation(core, prepared, meshes, settings))
    return 'the fit would break a limit of deviation or angle';
  if (settings.shell === null && isFurther(core, prepared, meshes, settings.maxDeviation))
    return 'the fit would end further from the original than it began';
  return '';
}

/** The result, fitted without a limit of its deviation; null where that does not bring it within the largest deviation. */
export function fitWithinDeviation(
  core: Core,
  prepared: PreparedBody,
  result: MeshAt,
  request: FitRequest & { settings: FitSettings },
): FittedResult | null {
  const { settings } = request;
  const fitted = fitWithin(core, prepared, result, { ...request, limit: Infinity });
  const { mesh } = fitted.result;
  const isKept =
    isWithinDeviation(core, prepared, mesh, settings.maxDeviation) &&
    objectionTo(core, prepared, [result.mesh, mesh], settings) === '';
  return isKept ? asFitted(fitted, settings) : null;
}

const kindOf = ({ shell }: FitSettings): FittedResult['kind'] => (shell === null ? 'surface' : 'modal');

const asFitted = (fitted: Fitted, settings: FitSettings): FittedResult => ({
  ...fitted,
  kind: kindOf(settings),
  unfitted: describeUnfitted(fitted),
});

/** The limit of the first fit in %; Infinity is a fit without a limit, which is fast and mostly ends closer to the original. */
const firstLimit = ({ maxDeviation }: FitSettings, isNearLimit = false): number =>
  isNearLimit && maxDeviation > 0 ? maxDeviation : Infinity;

/** The limit after one with which a fit has a deviation; null if there is none, or if a tighter one would not help. */
function nextLimit(limit: number, whole: number, deviation: number): number | null {
  if (deviation <= whole) return null;
  return DEVIATION_SHARES.map((share) => share * whole).find((next) => next < ROUNDED * limit) ?? null;
}

/** The limit in % if the first fit is not kept: the largest deviation, and for a fit to the surface what `GROWTH` permits. */
function wholeLimit(
  core: Core,
  prepared: PreparedBody,
  { mesh }: Pick<MeshAt, 'mesh'>,
  { maxDeviation, shell }: Pick<FitSettings, 'maxDeviation' | 'shell'>,
): number {
  const largest = maxDeviation === 0 ? Infinity : maxDeviation;
  if (shell !== null) return largest;
  return Math.min(largest, GROWTH.hausdorff * Math.max(ROUNDING, measureDeviation(core, prepared, mesh)));
}

/** The calls of the core with which `fitResult` begins for each result where the fit is to the surface; otherwise none. */
export function firstFits(
  prepared: PreparedBody,
  results: (Pick<FitRequest, 'isNearLimit'> & { result: MeshAt })[],
  { constraints, settings }: Pick<FitRequest, 'constraints' | 'settings'>,
): CoreCall<'fitShape'>[] {
  if (settings === null || settings.shell !== null) return [];
  return results.map(({ result, isNearLimit }) => {
    const limit = firstLimit(settings, isNearLimit);
    return coreCall(
      'fitShape',
      prepared.mesh,
      result,
      fitOptions(prepared, { constraints, settings, limit }),
    );
  });
}

/** A fit of a result to the surface. */
export interface TriedFit {
  prepared: PreparedBody;
  call: CoreCall<'fitShape'>;
  fitted: MeshAt;
}

/** The call with which `fitResult` goes on if this fit is not kept; null if there is none. */
export function nextFit(
  core: Core,
  { prepared, call, fitted }: TriedFit,
  maxDeviation: number,
): CoreCall<'fitShape'> | null {
  const [original, level, options] = call.values;
  const { diagonal } = prepared;
  const whole = wholeLimit(core, prepared, level, { maxDeviation, shell: null });
  const limit = options.maxDeviation === 0 ? Infinity : (100 / diagonal) * options.maxDeviation;
  const next = nextLimit(limit, whole, measureDeviation(core, prepared, fitted.mesh));
  if (next === null) return null;
  return coreCall('fitShape', original, level, { ...options, maxDeviation: inUnits(next, prepared) });
}

/** `limit`: of the deviation, in %. */
type LimitedFit = Omit<FitRequest, 'settings'> & { settings: FitSettings; limit: number };

/** A fit to the surface finds no errors of frequencies. */
function fitWithin(
  core: Core,
  prepared: PreparedBody,
  result: MeshAt,
  { cache, ...request }: LimitedFit,
): Fitted {
  const { mesh } = prepared;
  const { shell } = request.settings;
  const options = fitOptions(prepared, request);
  if (shell === null)
    return { ...NO_ERRORS, ...resultOf(core, cache, coreCall('fitShape', mesh, result, options)) };
  return core.fitModes(mesh, result, {
    ...options,
    thickness: thicknessOf(prepared, shell),
    poisson: shell.poisson,
  });
}

function fitOptions(
  prepared: PreparedBody,
  { constraints, settings, limit }: Omit<LimitedFit, 'cache'>,
): ShapeFitOptions {
  const { mesh } = prepared;
  return {
    charts: prepared.attributes.charts,
    keepsSeams: settings.seams === 'keep',
    locked: maskOf(mesh, constraints.pinned, constraints.locked) ?? new Uint8Array(),
    pinned: constraints.pinned ?? new Uint32Array(),
    mirror: constraints.mirror,
    maxDeviation: inUnits(limit, prepared),
    minAngle: settings.minAngle,
    samples: prepared.samples,
  };
}

/** A limit in units of the mesh, as the core takes it: 0 is none. */
const inUnits = (limit: number, { diagonal }: PreparedBody): number =>
  Number.isFinite(limit) ? (limit / 100) * diagonal : 0;

/** The level of at most `faces` faces, fitted. */
export function fittedLevelAt(
  core: Core,
  { prepared, kept }: { prepared: PreparedBody; kept: KeptHistory },
  faces: number,
  request: FitRequest,
): FittedResult {
  return fitResult(core, prepared, levelAt(core, kept, faces), request);
}

/** The frequency errors of a fit that does not compute them. */
const NO_ERRORS = {
  errorBefore: new Float64Array(),
  errorAfter: new Float64Array(),
  large: 0,
  tooLarge: 0,
};

const unfitted = (result: MeshAt, kind: FittedResult['kind'], why: string): FittedResult => ({
  ...NO_ERRORS,
  result,
  kind,
  flips: 0,
  unfitted: why,
});

type BeforeAndAfter = [before: TriangleMesh, after: TriangleMesh];

/** Whether `after` satisfies the smallest angle, or violates it no more than `before`. */
function keepsAngle(core: Core, [before, after]: BeforeAndAfter, { minAngle }: FitSettings): boolean {
  const angleOf = (mesh: TriangleMesh) => core.measureQuality(mesh).minAngle;
  return minAngle === 0 || angleOf(after) >= Math.min(minAngle, angleOf(before));
}

/** The same for the largest deviation. */
function keepsDeviation(
  core: Core,
  prepared: PreparedBody,
  [before, after]: BeforeAndAfter,
  { maxDeviation }: FitSettings,
): boolean {
  // A kept result is measured in full later anyway, and the measurement is cached.
  if (maxDeviation === 0 || measureDistance(core, prepared, after).hausdorff <= maxDeviation) return true;
  if (isWithinDeviation(core, prepared, before, maxDeviation)) return false;
  return measureDeviation(core, prepared, after) <= measureDeviation(core, prepared, before);
}

/**
 * Whether `after` is further from the original than `before` by more than `GROWTH`. The mean may grow more where the fit
 * brings the farthest point back within the largest deviation.
 */
function isFurther(
  core: Core,
  prepared: PreparedBody,
  [before, after]: BeforeAndAfter,
  maxDeviation: number,
): boolean {
  const first = measureDeviation(core, prepared, before);
  // A kept result is measured in full later anyway, and the measurement is cached.
  const last = measureDistance(core, prepared, after).hausdorff;
  if (last <= maxDeviation && maxDeviation < first) return false;
  if (last > GROWTH.hausdorff * Math.max(ROUNDING, first)) return true;
  const [mean, fittedMean] = [before, after].map((mesh) => estimateMean(core, prepared, mesh));
  return fittedMean > GROWTH.mean * Math.max(ROUNDING, mean);
}
