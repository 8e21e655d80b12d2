/** Presets: combinations of settings for a purpose. They do not set the number of faces. */

import type { SettingName, Settings } from './table';

export interface Preset {
  /** its name on the page */
  label: string;
  /** why these settings, in one sentence */
  why: string;
  settings: Partial<Settings>;
}

export const PRESETS = {
  web: {
    label: 'Web',
    why: 'A small download: meshopt compresses vertices, and three.js, Babylon.js and model-viewer decode them quickly.',
    settings: { compress: 'meshopt' },
  },
  mobile: {
    label: 'Mobile',
    why: 'Vertices take half the memory and need no decoding, and two further levels are used where the model is small on the screen.',
    settings: { compress: 'quantized', lods: [0.25, 0.1] },
  },
  cloth: {
    label: 'Cloth',
    why: 'A sheet without volume: its borders stay where they are, and after the collapses vertices are moved until it vibrates at the frequencies of the original.',
    settings: { model: 'shell', material: 'shell', borders: 'fixed', fit: 'modal' },
  },
  'soft-body': {
    label: 'Soft body',
    why: 'A closed body with volume: faces are kept where its volume bends, and collapses stop before an angle falls below 10 degrees, because thin triangles make soft bodies stiff and unstable.',
    settings: { model: 'solid', material: 'solid', minAngle: 10 },
  },
  print: {
    label: '3D print',
    why: 'The surface stays within 0.1 % of its size (0.1 mm of 10 cm), edges above 30 degrees stay sharp, and texture seams, which do not matter in print, do not limit collapses.',
    settings: { maxDeviation: 0.1, creases: 30, seams: 'cross', compress: 'none' },
  },
} as const satisfies Record<string, Preset>;

export type PresetName = keyof typeof PRESETS;

export const PRESET_NAMES = Object.keys(PRESETS) as PresetName[];

/** A setting that a preset changes. */
export interface PresetChange {
  name: SettingName;
  from: Settings[SettingName];
  to: Settings[SettingName];
}

/** The changes that a preset makes to these settings; empty if there are none. */
export function presetChanges(preset: PresetName, settings: Settings): PresetChange[] {
  const asked: Partial<Settings> = settingsOfPreset(preset);
  return (Object.keys(asked) as SettingName[])
    .filter((name) => String(asked[name]) !== String(settings[name]))
    .map((name) => ({ name, from: settings[name], to: asked[name]! }));
}

/** A fresh copy of the settings of a preset. */
export const settingsOfPreset = (preset: PresetName): Partial<Settings> =>
  structuredClone(PRESETS[preset].settings) as unknown as Partial<Settings>;
