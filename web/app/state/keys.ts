/** What each stage depends on, as text that is compared: a stage runs again when its key has changed. */

import { isFitted, resolveModel } from '../../engine/options';
import type { Settings } from '../../engine/options';

export const prepareKey = ({ weld }: Settings): string => `${weld}`;

export const pinsKey = (settings: Settings): string => `${prepareKey(settings)} ${settings.pins}`;

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
  const { maxDeviation, minAngle, borders } = settings;
  const { keep, lock, paint, symmetry, creases } = settings;
  const wishes = [borders, keep, lock, paint, symmetry, creases];
  const common = [pinsKey(settings), method, sizeWeight, maxDeviation, minAngle, ...wishes];
  if (method === 'qem') return common.join(' ');
  return [guidanceKey(settings), ...common, strainWeight, curvatureWeight, qualityWeight].join(' ');
}

/** Of what is shown and exported. */
export function resultKey(settings: Settings): string {
  const { fit, thickness, poisson } = settings;
  return isFitted(settings)
    ? [historyKey(settings), fit, thickness, poisson].join(' ')
    : historyKey(settings);
}
