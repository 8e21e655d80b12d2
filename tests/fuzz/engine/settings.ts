/** Fuzz targets of settings: options as text, command lines, settings files, patterns. */

import { parseArguments } from '../../../web/cli/arguments';
import { engineOfText } from '../../../web/cli/engine_file';
import { readSettingsFile } from '../../../web/engine/report/settings_reader';
import { SETTINGS_SCHEMA } from '../../../web/engine/report/settings_file';
import { COMMANDS, OPTIONS, SETTING_NAMES, checkSettings } from '../../../web/engine/settings/options';
import { matchesPattern } from '../../../web/engine/settings/name_pattern';
import { parsePaint } from '../../../web/engine/settings/paint_text';
import { defaultSettings } from '../../../web/engine/settings/methods';
import { engineValues } from '../../../web/engine/settings/engine_text';
import { readSetting } from '../../../web/engine/settings/setting_text';
import { SOLVER_NAMES } from '../../../web/engine/solvers/profiles';
import type { Choices } from './choices';
import type { FuzzTarget } from './fuzz_target';
import { anyWord, mutateText, mutatedJsonText } from './mutate';

/** Texts that some option takes. */
const TEXTS = [
  '0.5',
  '12',
  '1,2,3',
  '1-4,7',
  'limber',
  'shell',
  'none',
  'auto',
  'low',
  'box:0,0,0:1,1,1',
  'ids:1,2,3',
  '0:ball:0,0,0:1',
  'ball:0,0,0:1;ground:-1',
  'stretch=1,bend=2',
  'wheel|door*',
  '0:A1B2C3',
  'x',
  '',
];

const anyText = (choices: Choices): string => {
  let text = choices.pick(TEXTS);
  for (let left = choices.below(4); left > 0; --left) text = mutateText(text, choices);
  return text;
};

const optionTexts: FuzzTarget = {
  name: 'options',
  run: (choices) => {
    const settings = defaultSettings();
    for (let left = 1 + choices.below(3); left > 0; --left) {
      const name = choices.pick(SETTING_NAMES);
      Object.assign(settings, { [name]: readSetting(OPTIONS[name], anyText(choices)) });
    }
    checkSettings(settings);
  },
};

const commandLines: FuzzTarget = {
  name: 'command lines',
  run: (choices) => {
    const words: string[] = [choices.chance(0.9) ? choices.pick(COMMANDS) : anyText(choices)];
    for (let left = choices.below(5); left > 0; --left) {
      const flag = `--${OPTIONS[choices.pick(SETTING_NAMES)].flag}`;
      words.push(choices.chance(0.9) ? flag : mutateText(flag, choices));
      if (choices.chance(0.8)) words.push(anyText(choices));
    }
    for (let left = choices.below(3); left > 0; --left)
      words.push(choices.pick(['in.glb', 'out.glb', '-', '']));
    parseArguments(words);
  },
};

/** A settings file that is read. */
export const SETTINGS_FILE = {
  schema: SETTINGS_SCHEMA,
  solver: SOLVER_NAMES[0],
  tune: 'global',
  units: { length: 1 },
  material: { young: 1e6, poisson: 0.3, density: 1100, thickness: 2, bendRatio: 0.05 },
  given: ['young'],
  bodies: [
    {
      ...{ name: 'a', level: 0, meshNumber: 0, unit: 1 },
      engine: { young: 1e6 },
      original: { vertices: 9, faces: 8, totalMass: 4, stretch: 1, bend: 1, young: 1e6 },
      mesh: { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0], triangles: [0, 1, 2, 2, 1, 3] },
      renderVertices: [0, 1, 2, 3, -1],
      mass: { rule: 'area', perVertex: [1, 1, 1, 1] },
      vertex: { stretch: [1, 1, 1, 1], bend: [1, 1, 1, 1] },
      stretch: { constant: 1, pairs: [0, 1, 1, 2, 2, 0, 1, 3, 2, 3], factors: [1, 1, 1, 1, 1] },
      bend: { constant: 1, hinges: [1, 2, 0, 3], factors: [1] },
      pins: [0],
    },
  ],
};

const settingsFiles: FuzzTarget = {
  name: 'settings files',
  run: (choices) => {
    readSettingsFile('a.json', mutatedJsonText(SETTINGS_FILE, 1 + choices.below(4), choices));
  },
};

/** Files of --engine: as JSON, or as lines. */
const engineFiles: FuzzTarget = {
  name: 'engine files',
  run: (choices) => {
    const solver = choices.pick(SOLVER_NAMES);
    const values = { stretch: 1e4, bend: 0.01, compliance: 1e-5, young: 1e6, mass: 2, nothing: 1 };
    const text = choices.chance(0.5)
      ? mutatedJsonText(values, choices.below(3), choices)
      : mutateText('# mine\nstretch=1e4 # N/m\nbend=0.01\n', choices);
    engineValues(solver, engineOfText('a.txt', text).text);
  },
};

const patterns: FuzzTarget = {
  name: 'patterns',
  run: (choices) => {
    const letters = ['a', 'b', '*', '?', '|', '\\', '[', ']', '(', '😀', '\n', '\0'];
    matchesPattern(anyWord(letters, 24, choices), anyWord(letters, 24, choices));
  },
};

const paint: FuzzTarget = {
  name: 'paint',
  run: (choices) => void parsePaint(anyText(choices)),
};

export const settingsTargets: FuzzTarget[] = [
  optionTexts,
  commandLines,
  settingsFiles,
  engineFiles,
  patterns,
  paint,
];
