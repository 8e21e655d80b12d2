/** The flags of every command. Those of settings follow from the table of settings. */

import { COMMAND_DEFAULTS, COMMAND_GROUPS } from '../engine/settings/commands';
import { rulesOf } from '../engine/settings/kinds';
import { BATCH_FLAGS } from './batch/flags';
import type { Flag } from './flag';
export type { Flag };
import { MATERIAL_NAMES } from '../engine/settings/materials';
import { PRESET_NAMES } from '../engine/settings/presets';
import { COMMANDS as ENGINE_COMMANDS, OPTIONS, settingsOf } from '../engine/settings/options';
import type { Command as EngineCommand, OptionSpec, SettingName, Settings } from '../engine/settings/options';

export const COMMANDS = ['optimize', 'batch', 'tune', 'modes', 'compare', 'simulate', 'inspect'] as const;
export type Command = (typeof COMMANDS)[number];

/** A batch optimizes every asset. */
export const engineCommand = (command: Command): EngineCommand =>
  ENGINE_COMMANDS.find((name) => name === command) ?? 'optimize';

/** A command: its operands, and the flags that are no settings. commands.ts has those that are. */
export interface CommandSpec {
  /** in brackets where it may be left out; such ones come last. With dots where there may be several. */
  operands: string[];
  summary: string;
  flags: Flag[];
  /** defaults that differ from the engine's */
  defaults: Partial<Settings>;
  /** what a setting means here, where that differs from the table of settings */
  words?: Partial<Record<SettingName, Pick<Flag, 'help' | 'group'>>>;
}

const REPORT: Flag = {
  name: 'report',
  value: 'FILE|-',
  help: 'Write the JSON report to FILE, or alone to stdout.',
  group: 'output',
};
const SETTINGS: Flag = {
  name: 'settings',
  value: 'FILE',
  help: 'Write what the solver needs to move the result like the original (docs/formats.md).',
  group: 'output',
};
/** Sets the whole material; flags for a part of it override that part. */
const MATERIAL_PRESET: Flag = {
  name: 'material-preset',
  value: MATERIAL_NAMES.join('|'),
  help: 'A whole material by name; other flags change parts of it. Default: rubber.',
  group: 'material',
};
/** Settings for what a result is made for; flags of their own override them. */
const PRESET: Flag = {
  name: 'preset',
  value: PRESET_NAMES.join('|'),
  help: 'Settings that go well together for what the result is made for; other flags change parts of them.',
  group: 'common',
};
/** What --from can say of stdin. */
export const INPUT_FORMATS = ['glb', 'gltf', 'obj', 'stl', 'ply', 'off'] as const;

const COMMON: Flag[] = [
  REPORT,
  { name: 'json', help: 'The same as --report -.', group: 'output' },
  {
    name: 'from',
    value: INPUT_FORMATS.join('|'),
    help: 'The format of a model from stdin, where its bytes leave it open.',
    group: 'common',
  },
  {
    name: 'force',
    help: 'Replace files that limber has not written itself; without it they are refused.',
    group: 'output',
  },
  {
    name: 'dry-run',
    help: 'Check everything, say what would be written, and write nothing.',
    group: 'output',
  },
  {
    name: 'memory',
    value: 'SIZE',
    help: 'Memory that the core may take, such as 512M or 2G: a model that needs more is refused before the work. Default: 4G, the most.',
    group: 'common',
  },
  { name: 'quiet', help: 'Say nothing but errors.', group: 'common' },
  {
    name: 'verbose',
    help: 'A line for every warning; without it equal ones of several bodies share a line.',
    group: 'common',
  },
  { name: 'help', help: 'Show this help.', group: 'common' },
  { name: 'version', help: 'Show the version.', group: 'common' },
];

/** What optimize and batch are asked for. */
const TARGETS: Flag[] = [
  {
    name: 'faces',
    value: 'N',
    help: 'Keep at most N faces of the whole scene, where they hurt most to lose.',
    group: 'target',
  },
  {
    name: 'ratio',
    value: 'R',
    help: 'Keep this share of the faces of the whole scene, above 0 to 1 (default: 0.5, where no other target is asked for). Of several targets the first one reached stops.',
    group: 'target',
  },
  {
    name: 'soft',
    help: 'End with exit code 0 where a target or limit that was asked for is not reached; the reason is told.',
    group: 'target',
  },
  {
    name: 'fields',
    help: 'Write strain and curvature as attributes _STRAIN and _CURVATURE.',
    group: 'output',
  },
];

export const COMMAND_SPECS: Record<Command, CommandSpec> = {
  optimize: {
    operands: ['IN', 'OUT'],
    summary: 'Remove triangles where they matter least for how the body bends.',
    flags: [
      ...TARGETS,
      {
        name: 'bind',
        value: 'FILE',
        help: 'Write where each original vertex lies on the optimized mesh (docs/formats.md).',
        group: 'output',
      },
      {
        name: 'like-input',
        help: 'Store vertices as IN does: the same as --compress like-input, which is the default.',
        group: 'output',
      },
      {
        name: 'no-validate',
        help: 'Do not check OUT by the Khronos glTF validator, which otherwise warns of errors that IN does not have (files of more than 64 MB are never checked).',
        group: 'output',
      },
      SETTINGS,
      ...COMMON,
    ],
    defaults: {},
  },
  batch: {
    operands: ['SRC...', 'OUT'],
    summary: 'Optimize all models of folders, and later those that have changed.',
    flags: [...BATCH_FLAGS, ...TARGETS, ...COMMON.filter(({ name }) => name !== 'from' && name !== 'memory')],
    defaults: {},
    words: {
      threads: { help: 'Threads of each job; 0: the cores are shared out.', group: 'common' },
    },
  },
  tune: {
    operands: ['A', 'B'],
    summary: 'Find the parameters of a solver with which B moves like A.',
    flags: [SETTINGS, ...COMMON],
    defaults: {},
  },
  modes: {
    operands: ['IN'],
    summary: 'List the frequencies at which the body deforms by itself.',
    flags: [
      {
        name: 'shapes',
        value: 'OUT.glb',
        help: 'Write the modes as morph targets with an animation each.',
        group: 'output',
      },
      ...COMMON,
    ],
    defaults: COMMAND_DEFAULTS.modes,
  },
  compare: {
    operands: ['A', 'B'],
    summary: 'Measure how alike A, the original, and B are in shape and vibration.',
    flags: COMMON,
    defaults: COMMAND_DEFAULTS.compare,
    words: { modeCount: { help: 'How many elastic modes are compared.', group: 'material' } },
  },
  simulate: {
    operands: ['A', '[B]'],
    summary: 'Move A, and B beside it: times, and how far they part.',
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
      {
        name: 'settings',
        value: 'FILE',
        help: 'Give B the masses and factors of this file of limber optimize --settings or limber tune; A keeps the parameters that it was tuned to.',
        group: 'simulation',
      },
      ...COMMON,
    ],
    defaults: {},
  },
  inspect: {
    operands: ['IN'],
    summary: 'Tell what is in a mesh and what is wrong with it.',
    flags: COMMON,
    defaults: {},
  },
};

/** All flags of a command, in the order of its help. */
export function flagsOf(command: Command): Flag[] {
  const settings = settingsOf(engineCommand(command)).map((setting) => flagOfSetting(command, setting));
  const preset = COMMAND_GROUPS[engineCommand(command)].includes('material') ? [MATERIAL_PRESET] : [];
  const whole = engineCommand(command) === 'optimize' ? [PRESET] : [];
  return [...COMMAND_SPECS[command].flags, ...settings, ...preset, ...whole];
}

function flagOfSetting(command: Command, setting: SettingName): Flag {
  const option: OptionSpec = OPTIONS[setting];
  const { help, group } = COMMAND_SPECS[command].words?.[setting] ?? option;
  if (option.kind === 'switch') return { name: option.flag, help, group };
  const value = option.placeholder ?? rulesOf(option).placeholder(option);
  return { name: option.flag, value, help: `${help}${describeDefault(command, setting)}`, group };
}

function describeDefault(command: Command, setting: SettingName): string {
  const option: OptionSpec = OPTIONS[setting];
  const value = COMMAND_SPECS[command].defaults[setting] ?? option.default;
  if (Array.isArray(value) || value === '') return '';
  const unit = 'unit' in option && option.unit ? ` ${option.unit}` : '';
  return ` Default: ${String(value)}${unit}.`;
}

/** The settings that a command takes, for its report; texts that are empty are left out. */
export function settingsAsUsed(command: Command, settings: Settings): Partial<Settings> {
  const used = settingsOf(engineCommand(command)).filter((setting) => settings[setting] !== '');
  return Object.fromEntries(used.map((setting) => [setting, settings[setting]]));
}
