/** The settings of samples, by the names of their files, so that they move as their cards say. */

import { MATERIALS } from '../../../engine/settings/materials';
import { defaultSettings, modelDefaults } from '../../../engine/settings/options';
import type { SettingName, Settings } from '../../../engine/settings/options';
import type { Wanted } from '../link';

/** The three vertices of each upper corner of its grid of 33 x 33. */
const CORNERS = 'vertices:0,1,33,31,32,65';

const BROUGHT: Readonly<Record<string, Partial<Settings>>> = {
  'cloth.glb': { ...MATERIALS.cotton, pins: CORNERS, scenario: 'hang' },
  // A twist rotates only its spire.
  'tower.glb': { scenario: 'sway' },
};

/** The request for a sample with its own settings, applied to `settings`, those of before; undefined for other samples. */
export function wantedOfSample(file: string, settings: Settings): Wanted | undefined {
  const brought = BROUGHT[file];
  if (!brought) return undefined;
  const own = { ...settings, ...modelDefaults(), ...brought };
  return { settings: own, faces: null, own: new Map(), body: 0, file: null };
}

/** The defaults, for the next model, of settings that the sample of this name has set and nobody has changed since. */
export function afterSample(file: string | undefined, settings: Settings): Partial<Settings> {
  const brought = BROUGHT[file ?? ''] ?? {};
  const defaults = defaultSettings();
  const kept = (Object.keys(brought) as SettingName[]).filter((name) => brought[name] === settings[name]);
  return Object.fromEntries(kept.map((name) => [name, defaults[name]]));
}
