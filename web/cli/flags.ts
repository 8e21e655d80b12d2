/** The flags of every command: those of the settings come from the engine's options. */

import { SCENARIO_NAMES } from '../engine/core/scenarios';
import { MATERIAL_NAMES } from '../engine/settings/materials';
import { OPTIONS } from '../engine/settings/options';
import type { OptionGroup, Settings } from '../engine/settings/options';

export const COMMANDS = ['optimize', 'modes', 'compare', 'simulate', 'inspect'] as const;
export type Command = (typeof COMMANDS)[number];

export interface Flag {
  name: string;
  /** what stands for its value in the help; absent: the flag is a switch */
  value?: string;
  help: string;
  group: string;
}

/** A command: its operands, and which groups of settings it takes. */
export interface CommandSpec {
  /** in brackets where it may be left out; such ones come last */
  operands: string[];
  summary: string;
  groups: OptionGroup[];
  /** single settings of other groups */
  settings?: (keyof Settings)[];
  flags: Flag[];
  /** defaults that differ from the engine's */
  defaults: Partial<Settings>;
}

const REPORT: Flag = {
  name: 'report',
  value: 'FILE|-',
  help: 'Write the JSON report to FILE, or alone to stdout.',
  group: 'output',
};
/** Sets the whole material; flags that name a part of it count after it. */
const MATERIAL_PRESET: Flag = {
  name: 'material-preset',
  value: MATERIAL_NAMES.join('|'),
  help: 'A whole material by name; other flags change parts of it. Default: rubber.',
  group: 'material',
};
const COMMON: Flag[] = [
  REPORT,
  { name: 'json', help: 'The same as --report -.', group: 'output' },
  {
    name: 'mesh',
    value: 'NAME',
    help: 'Only the body of this name; others stay as they are.',
    group: 'common',
  },
  { name: 'quiet', help: 'Say nothing but errors.', group: 'common' },
  { name: 'help', help: 'Show this help.', group: 'common' },
  { name: 'version', help: 'Show the version.', group: 'common' },
];

export const COMMAND_SPECS: Record<Command, CommandSpec> = {
  optimize: {
    operands: ['IN', 'OUT.glb'],
    summary: 'Remove triangles where they matter least for how the body bends.',
    groups: ['target', 'method', 'motion', 'material', 'common'],
    settings: ['calibrate'],
    flags: [
      {
        name: 'faces',
        value: 'N',
        help: 'Keep at most N faces, shared out over the bodies.',
        group: 'target',
      },
      {
        name: 'ratio',
        value: 'R',
        help: 'Keep this share of the faces of each body, above 0 to 1 (default: 0.5, where there is no other target). Of several targets the first one reached stops.',
        group: 'target',
      },
      {
        name: 'fields',
        help: 'Write strain and curvature as attributes _STRAIN and _CURVATURE.',
        group: 'output',
      },
      {
        name: 'bind',
        value: 'FILE',
        help: 'Write where each original vertex lies on the optimized mesh (docs/formats.md).',
        group: 'output',
      },
      ...COMMON,
    ],
    defaults: {},
  },
  modes: {
    operands: ['IN'],
    summary: 'List the frequencies at which the body deforms by itself.',
    groups: ['motion', 'material', 'common'],
    flags: [
      {
        name: 'shapes',
        value: 'OUT.glb',
        help: 'Write the modes as morph targets with an animation each.',
        group: 'output',
      },
      ...COMMON,
    ],
    // qem has no model of its own: `auto` stays what suits each part.
    defaults: { modes: 'all', method: 'qem' },
  },
  compare: {
    operands: ['A', 'B'],
    summary: 'Measure how alike A, the original, and B are in shape and vibration.',
    groups: ['material', 'common'],
    flags: [
      {
        name: 'modes',
        value: 'N',
        help: 'How many elastic modes are compared (default: 10).',
        group: 'material',
      },
      ...COMMON,
    ],
    defaults: { modeCount: 10, model: 'shell' },
  },
  simulate: {
    operands: ['A', '[B]'],
    summary: 'Move A, and B beside it: times, and how far they part.',
    groups: ['simulation', 'material', 'common'],
    settings: ['pins'],
    flags: [
      {
        name: 'record',
        value: 'OUT.glb',
        help: 'Write the motion as morph targets with an animation, bodies side by side.',
        group: 'output',
      },
      {
        name: 'bind',
        value: 'FILE',
        help: 'Carry pins over to B by this file of limber optimize --bind, not by closest points.',
        group: 'simulation',
      },
      ...COMMON,
    ],
    defaults: {},
  },
  inspect: {
    operands: ['IN'],
    summary: 'Tell what is in a mesh and what is wrong with it.',
    groups: ['common'],
    flags: COMMON,
    defaults: {},
  },
};

const PLACEHOLDERS: Partial<Record<keyof Settings, string>> = {
  method: 'limber|paper|qem',
  fit: 'on|off',
  borders: 'free|fixed',
  seams: 'keep|cross',
  maxDeviation: 'PCT',
  maxFrequencyError: 'PCT',
  lods: 'R[,R...]',
  symmetry: 'off|on|x|y|z',
  creases: 'DEG',
  keep: 'NAME',
  lock: 'SPEC',
  paint: 'TEXT',
  minAngle: 'DEG',
  model: 'auto|shell|solid|laplacian',
  direction: 'all|x|y|z',
  pins: 'SPEC',
  modes: 'auto|all|K[,K...]',
  modeWeights: 'W[,W...]',
  p: 'P|inf',
  young: 'PA',
  poisson: 'NU',
  density: 'KG/M3',
  thickness: 'PCT',
  unit: 'METRES',
  weld: 'PCT',
  scenario: SCENARIO_NAMES.join('|'),
  colliders: 'SPEC',
  friction: 'MU',
  material: 'shell|springs',
  seconds: 'S',
};

/** The settings that a command takes as flags. */
export function settingsOf(command: Command): (keyof Settings)[] {
  const { groups, settings = [] } = COMMAND_SPECS[command];
  return (Object.keys(OPTIONS) as (keyof Settings)[]).filter(
    (key) => groups.includes(OPTIONS[key].group) || settings.includes(key),
  );
}

/** All flags of a command, in the order of its help. */
export function flagsOf(command: Command): Flag[] {
  const settings = settingsOf(command).map((key): Flag => {
    const { flag, help, group } = OPTIONS[key];
    if (OPTIONS[key].kind === 'switch') return { name: flag, help, group };
    return {
      name: flag,
      value: PLACEHOLDERS[key] ?? 'N',
      help: `${help}${defaultNote(command, key)}`,
      group,
    };
  });
  const preset = COMMAND_SPECS[command].groups.includes('material') ? [MATERIAL_PRESET] : [];
  return [...COMMAND_SPECS[command].flags, ...settings, ...preset];
}

function defaultNote(command: Command, key: keyof Settings): string {
  const value = COMMAND_SPECS[command].defaults[key] ?? OPTIONS[key].default;
  return Array.isArray(value) || value === ''
    ? ''
    : ` Default: ${String(value)}${OPTIONS[key].unit ? ` ${OPTIONS[key].unit}` : ''}.`;
}
