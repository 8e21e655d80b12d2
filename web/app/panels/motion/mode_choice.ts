/** The guiding modes, and the effect of a click on a mode. */

import { resolveModes } from '../../../engine/settings/options';
import { changeSettings, wants } from '../../state/store';

/** The guiding modes, from 1. */
export const guidingModes = (): number[] => resolveModes(wants.settings.value);

/** Makes a mode the only guiding one; with `isBlending` adds it to the others or removes it from them. */
export function chooseMode(mode: number, isBlending: boolean): void {
  const chosen = guidingModes();
  if (!isBlending) return changeSettings({ modes: [mode], modeWeights: [] });
  const next = chosen.includes(mode)
    ? chosen.filter((other) => other !== mode)
    : [...chosen, mode].sort((a, b) => a - b);
  if (next.length > 0) changeSettings({ modes: next, modeWeights: [] });
}
