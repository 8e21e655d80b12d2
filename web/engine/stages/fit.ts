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
import { isWithinDeviation, measureDeviation, measureDistance } from './measure';

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
 * The shares of the deviation limit that fits may use, tried in turn. A fit measures at samples; if these miss too much, the
 * last share leaves a margin.
 */
const DEVIATION_SHARES = [1, 0.85];

/**
 * The result, fitted to the original's surface, or with `shell` to its modes as well. Pinned and locked vertices stay where they are, and a mirror symmetry is kept.
 * If the fit would violate the largest deviation or the smallest angle of the settings, the result is returned unfitted.
 */
export function fitResult(
  core: Core,
  prepared: PreparedBody,
  result: MeshAt,
  request: FitRequest,
): FittedResult {
  if (request.settings === null) return unfitted(result, 'off', '');
  const { settings, isNearLimit } = request;
  for (const share of sharesOf(settings, isNearLimit)) {
    const fitted = fitWithin(core, prepared, result, { ...request, settings, share });
    const meshes: BeforeAndAfter = [result.mesh, fitted.result.mesh];
    if (keepsAngle(core, meshes, settings) && keepsDeviation(core, prepared, meshes, settings))
      return asFitted(fitted, result, settings);
  }
  return unfitted(result, kindOf(settings), 'the fit would break a limit of deviation or angle');
}

/** The result, fitted without a limit of its deviation; null where that does not bring it within the largest deviation. */
export function fitWithinDeviation(
  core: Core,
  prepared: PreparedBody,
  result: MeshAt,
  request: FitRequest & { settings: FitSettings },
): FittedResult | null {
  const { settings } = request;
  const fitted = fitWithin(core, prepared, result, { ...request, share: Infinity });
  const { mesh } = fitted.result;
  const isKept =
    isWithinDeviation(core, prepared, mesh, settings.maxDeviation) &&
    keepsAngle(core, [result.mesh, mesh], settings);
  return isKept ? asFitted(fitted, result, settings) : null;
}

const kindOf = ({ shell }: FitSettings): FittedResult['kind'] => (shell === null ? 'surface' : 'modal');

/** A fit to the surface that changes nothing is none. */
const asFitted = (fitted: Fitted, before: MeshAt, settings: FitSettings): FittedResult => ({
  ...fitted,
  kind: settings.shell === null && isUnchanged(fitted, before) ? 'off' : kindOf(settings),
  unfitted: describeUnfitted(fitted),
});

const isUnchanged = ({ result: { mesh }, flips }: Fitted, before: MeshAt): boolean =>
  flips === 0 && mesh.positions.every((value, i) => value === before.mesh.positions[i]);

/** The shares to try; Infinity is a fit without the limit, which comes first because it is fast and mostly stays within it. */
function sharesOf({ maxDeviation }: FitSettings, isNearLimit = false): number[] {
  if (maxDeviation === 0) return [Infinity];
  return isNearLimit ? DEVIATION_SHARES : [Infinity, ...DEVIATION_SHARES];
}

/** The calls of the core with which `fitResult` begins for each result where the fit is to the surface; otherwise none. */
export function firstFits(
  prepared: PreparedBody,
  results: (Pick<FitRequest, 'isNearLimit'> & { result: MeshAt })[],
  { constraints, settings }: Pick<FitRequest, 'constraints' | 'settings'>,
): CoreCall<'fitShape'>[] {
  if (settings === null || settings.shell !== null) return [];
  return results.map(({ result, isNearLimit }) => {
    const [share] = sharesOf(settings, isNearLimit);
    return coreCall(
      'fitShape',
      prepared.mesh,
      result,
      fitOptions(prepared, { constraints, settings, share }),
    );
  });
}

type FitOfShare = Omit<FitRequest, 'settings'> & { settings: FitSettings; share: number };

/** The fit that may use a share of the largest deviation; a fit to the surface finds no errors of frequencies. */
function fitWithin(
  core: Core,
  prepared: PreparedBody,
  result: MeshAt,
  { cache, ...request }: FitOfShare,
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
  { constraints, settings, share }: Omit<FitOfShare, 'cache'>,
): ShapeFitOptions {
  const { mesh } = prepared;
  return {
    charts: prepared.attributes.charts,
    keepsSeams: settings.seams === 'keep',
    locked: maskOf(mesh, constraints.pinned, constraints.locked) ?? new Uint8Array(),
    pinned: constraints.pinned ?? new Uint32Array(),
    mirror: constraints.mirror,
    maxDeviation: Number.isFinite(share) ? ((share * settings.maxDeviation) / 100) * prepared.diagonal : 0,
    minAngle: settings.minAngle,
    samples: prepared.samples,
  };
}

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
