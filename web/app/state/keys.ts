/** What each stage depends on, as text that is compared: a stage runs again when its key has changed. */

import { resolveModel } from '../../engine/options';
import type { Settings } from '../../engine/options';

export const prepareKey = ({ weld }: Settings): string => `${weld}`;

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
  const { method, strainWeight, curvatureWeight, qualityWeight } = settings;
  if (method === 'qem') return `${prepareKey(settings)} qem`;
  return [guidanceKey(settings), strainWeight, curvatureWeight, qualityWeight].join(' ');
}
