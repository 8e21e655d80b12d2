/** Stages: strain, curvature and attributes of the original, and which of them guide the collapses of a method. */

import { costAttributesOf, MAX_COST_DIMENSIONS } from '../body/cost_attributes';
import type { CostAttributes } from '../body/cost_attributes';
import type { PreparedBody } from '../body/prepared_body';
import type { ModeSet, StrainGuidance } from '../core/core';
import { faceCount } from '../core/mesh';
import { modesAvailable } from '../core/mode_set';
import { SettingError, methodOf, resolveModes } from '../settings/options';
import type { Settings } from '../settings/options';
import { modesStage } from './modes';
import { preparedStage } from './prepared';
import { coreCall, resultOf } from './many_bodies/core_call';
import type { CoreCall } from './many_bodies/core_call';
import { declareStage, where } from './stage';
import type { RunContext } from './stage';

export interface GuidanceRequest extends Pick<Settings, 'modeWeights' | 'p' | 'strainThreshold'> {
  /** the modes that guide, numbers from 1 */
  guiding: number[];
}

export const guidanceStage = declareStage({
  name: 'guidance',
  reads: ['method', 'modes', 'modeCount', 'modeWeights', 'p', 'strainThreshold'],
  needs: { prepared: preparedStage, modes: modesStage },
  derive: ({ method, modes, modeCount, modeWeights, p, strainThreshold }): GuidanceRequest => ({
    guiding: resolveModes({ method, modes, modeCount }),
    modeWeights,
    p,
    strainThreshold,
  }),
  run: (context, { prepared, modes }, request) => findGuidance(context, prepared, modes, request),
  firstCalls: (_context, { prepared, modes }, request) => {
    const call = guidanceCall(prepared, modes, request);
    return call ? [call] : [];
  },
});

export const curvatureStage = declareStage({
  name: 'curvature',
  reads: [],
  needs: { prepared: preparedStage },
  run: ({ core }, { prepared }) => core.meanCurvature(prepared.mesh),
});

/** Null where a body has no attributes; those with more values than the core accepts are ignored. */
const costsStage = declareStage({
  name: 'costs',
  reads: [],
  needs: { prepared: preparedStage },
  run: ({ document }, { prepared }): CostAttributes | null => {
    const costs = document && costAttributesOf(document, prepared);
    return costs && costs.dimension <= MAX_COST_DIMENSIONS ? costs : null;
  },
});

/** Whether the method uses modes; quadrics alone do not. */
const isGuided = (settings: Pick<Settings, 'method'>): boolean => methodOf(settings).needsGuidance;

export const guidingModes = where(modesStage, ['method'], isGuided);
export const guidingStrain = where(guidanceStage, ['method'], isGuided);
/** Only Eq. 11 has a curvature term. */
export const guidingCurvature = where(
  curvatureStage,
  ['method'],
  (settings) => methodOf(settings).needsCurvature,
);
/** Attributes that enter the cost: none in the paper's method, or if seams are crossed. */
export const attributeCosts = where(
  costsStage,
  ['method', 'seams'],
  (settings) => methodOf(settings).keepsAttributes && settings.seams !== 'cross',
);

/**
 * Strain and its rank per triangle for the guiding modes. Modes that the body lacks do not count; the strain of a body
 * without any elastic mode is 0. Throws where modes are named and none of them exists.
 */
export function findGuidance(
  { core, cache }: Pick<RunContext, 'core' | 'cache'>,
  prepared: PreparedBody,
  modes: ModeSet,
  request: GuidanceRequest,
): StrainGuidance {
  const call = guidanceCall(prepared, modes, request);
  if (call) return resultOf(core, cache, call);
  const faces = faceCount(prepared.mesh);
  return { strain: new Float32Array(faces), rank: new Float32Array(faces) };
}

/** null where the body has no elastic mode. */
function guidanceCall(
  prepared: PreparedBody,
  modes: ModeSet,
  { guiding, modeWeights, p, strainThreshold: threshold }: GuidanceRequest,
): CoreCall<'strainGuidance'> | null {
  const available = modesAvailable(modes);
  if (available === 0) return null;
  const asked = guiding.map((mode, i) => ({ ordinal: mode - 1, weight: modeWeights[i] }));
  const found = asked.filter(({ ordinal }) => ordinal < available);
  if (found.length === 0) {
    const lowest = Math.min(...asked.map(({ ordinal }) => ordinal + 1));
    throw new SettingError(
      'modes',
      `names mode ${lowest}, but "${prepared.body.name}" has only ${available}: name a lower one.`,
    );
  }
  const weights = modeWeights.length > 0 ? found.map(({ weight }) => weight) : [];
  const ordinals = found.map(({ ordinal }) => ordinal);
  return coreCall('strainGuidance', prepared.mesh, modes, { ordinals, weights, p, threshold });
}
