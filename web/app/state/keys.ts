/** What each stage depends on, as text that is compared: a stage runs again when its key has changed. */

import { isFitted, methodOf, resolveModel } from '../../engine/settings/options';
import type { Settings } from '../../engine/settings/options';
import type { ExportRequest } from '../worker/protocol';

/** A symmetry may take other cuts of quads. */
export const prepareKey = ({ weld, symmetry }: Settings): string => `${weld} ${symmetry}`;

export const pinsKey = (settings: Settings): string => `${prepareKey(settings)} ${settings.pins}`;

export const heldKey = (settings: Settings): string => {
  const { keep, lock, paint } = settings;
  return [pinsKey(settings), keep, lock, paint].join(' ');
};

export function modesKey(settings: Settings): string {
  const { modeCount, direction, pins, exact, young, poisson, density, thickness, unit } = settings;
  return [
    prepareKey(settings),
    resolveModel(settings),
    modeCount,
    direction,
    pins,
    exact,
    young,
    poisson,
    density,
    thickness,
    unit,
  ].join(' ');
}

export function guidanceKey(settings: Settings): string {
  const { method, modes, modeWeights, p, strainThreshold } = settings;
  return [modesKey(settings), method, modes, modeWeights, p, strainThreshold].join(' ');
}

export function historyKey(settings: Settings): string {
  const { method, strainWeight, curvatureWeight, qualityWeight, sizeWeight } = settings;
  const { maxDeviation, minAngle, borders, seams, creases } = settings;
  const common = [heldKey(settings), method, sizeWeight, maxDeviation, minAngle, borders, seams, creases];
  if (!methodOf(settings).needsGuidance) return common.join(' ');
  return [guidanceKey(settings), ...common, strainWeight, curvatureWeight, qualityWeight].join(' ');
}

/** Of what is shown and exported. */
export function resultKey(settings: Settings): string {
  const { fit, thickness, poisson, maxFrequencyError, young, density, unit } = settings;
  const words = [historyKey(settings)];
  if (isFitted(settings)) words.push(fit, `${thickness} ${poisson}`);
  if (maxFrequencyError > 0)
    words.push([maxFrequencyError, thickness, young, poisson, density, unit].join(' '));
  return words.join(' ');
}

/** `faces` per body. */
export function exportKey(settings: Settings, faces: number[], request: ExportRequest): string {
  const { fields, binding, output } = request;
  return [resultKey(settings), faces, settings.lods, fields, binding, output].join(' ');
}
