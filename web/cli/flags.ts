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
  words?: Partial<Record<SettingName, SettingWords>>;
}

interface SettingWords extends Pick<Flag, 'help' | 'group'> {
  /** where the default of the setting means nothing here */
  hidesDefault?: true;
}

const REPORT: Flag = {
  name: 'report',
  value: 'FILE|-',
  help: 'Write the JSON report to FILE or, with -, to stdout, which then gets nothing else.',
  group: 'output',
};
const SETTINGS: Flag = {
  name: 'settings',
  value: 'FILE',
  help: 'Write the parameters with which the solver moves the result like the original (docs/formats.md).',
  group: 'output',
};
/** Sets the whole material; flags for a part of it override that part. */
const MATERIAL_PRESET: Flag = {
  name: 'material-preset',
  value: MATERIAL_NAMES.join('|'),
  help: 'All material parameters, by the name of a material; other flags override single ones. Default: rubber.',
  group: 'material',
};
/** Settings for what a result is made for; flags of their own override them. */
const PRESET: Flag = {
  name: 'preset',
  value: PRESET_NAMES.join('|'),
  help: 'Settings for the purpose of the result; other flags override single ones.',
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
    help: 'Format of a model read from stdin, if its bytes do not tell.',
    group: 'common',
  },
  {
    name: 'force',
    help: 'Overwrite files that limber did not write itself; without this it refuses to.',
    group: 'output',
  },
  {
    name: 'dry-run',
    help: 'Check all that can be known without solving, say what would be written, and write nothing.',
    group: 'output',
  },
  {
    name: 'memory',
    value: 'SIZE',
    help: 'Memory limit of the core, such as 512M or 2G: a model that needs more is refused before any work. Default and maximum: 4G.',
    group: 'common',
  },
  { name: 'quiet', help: 'Print nothing but errors and missed targets.', group: 'common' },
  {
    name: 'verbose',
    help: 'Print every warning on a line of its own; without this, bodies with the same warning share a line.',
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
    help: 'Keep at most N faces of the whole scene, those whose removal would do the most harm.',
    group: 'target',
  },
  {
    name: 'ratio',
    value: 'R',
    help: 'Keep this share of the faces of the whole scene, above 0 and up to 1 (default: 0.5 if no other target is given). Of several targets, the first one reached ends the reduction.',
    group: 'target',
  },
  {
    name: 'soft',
    help: 'Exit with code 0 even if a requested target or limit is not reached; the reason is still printed.',
    group: 'target',
  },
  {
    name: 'fields',
    help: 'Write strain and curvature as attributes _STRAIN and _CURVATURE.',
    group: 'output',
  },
];

/** What the patterns mean to a command that writes no model, in which other bodies could stay. */
const CHOSEN: CommandSpec['words'] = {
  mesh: {
    help: 'Look only at bodies with this name. In names, * matches any characters, ? matches one, and | separates alternatives; the flag can be repeated.',
    group: 'common',
  },
  materialName: { help: 'Look only at bodies all of whose materials have this name.', group: 'common' },
  exclude: {
    help: 'Leave out the bodies that have this name or a material with this name.',
    group: 'common',
  },
};

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
        help: 'Do not check OUT with the Khronos glTF validator, which otherwise warns of errors that IN does not have (files of more than 64 MB are never checked).',
        group: 'output',
      },
      SETTINGS,
      ...COMMON,
    ],
    defaults: {},
  },
  batch: {
    operands: ['SRC...', 'OUT'],
    summary: 'Optimize all models in folders; later, only those that have changed.',
    flags: [...BATCH_FLAGS, ...TARGETS, ...COMMON.filter(({ name }) => name !== 'from' && name !== 'memory')],
    defaults: {},
    words: {
      threads: { help: 'Threads per job; 0 divides the cores among the jobs.', group: 'common' },
    },
  },
  tune: {
    operands: ['A', 'B'],
    summary: 'Find the solver parameters with which B moves like A.',
    flags: [{ ...SETTINGS, help: `Has to be given. ${SETTINGS.help}` }, ...COMMON],
    defaults: {},
    words: {
      ...CHOSEN,
      solver: { help: `Has to be given. ${OPTIONS.solver.help}`, group: 'solver', hidesDefault: true },
    },
  },
  modes: {
    operands: ['IN'],
    summary: 'List the natural frequencies of the body.',
    flags: [
      {
        name: 'shapes',
        value: 'OUT.glb',
        help: 'Write the modes as morph targets, each with an animation.',
        group: 'output',
      },
      ...COMMON,
    ],
    defaults: COMMAND_DEFAULTS.modes,
    words: {
      ...CHOSEN,
      modes: {
        help: 'Elastic modes that --shapes writes: numbers from 1 separated by commas, all, or auto (the first six).',
        group: 'motion',
      },
    },
  },
  compare: {
    operands: ['A', 'B'],
    summary: 'Compare shape and vibration of B with those of the original A.',
    flags: COMMON,
    defaults: COMMAND_DEFAULTS.compare,
    words: { ...CHOSEN, modeCount: { help: 'Number of elastic modes to compare.', group: 'material' } },
  },
  simulate: {
    operands: ['A', '[B]'],
    summary: 'Simulate A and B: time per step, and how far B deviates from A.',
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
        help: 'Transfer pins to B with this file from limber optimize --bind, instead of by closest points.',
        group: 'simulation',
      },
      {
        name: 'settings',
        value: 'FILE',
        help: 'Simulate B with the masses and factors in this file from limber optimize --settings or limber tune, and A with the parameters of the original that it contains.',
        group: 'simulation',
      },
      ...COMMON,
    ],
    defaults: {},
    words: CHOSEN,
  },
  inspect: {
    operands: ['IN'],
    summary: 'Describe the contents and the defects of a mesh.',
    flags: COMMON,
    defaults: {},
    words: CHOSEN,
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
  const { help, group, hidesDefault }: SettingWords = COMMAND_SPECS[command].words?.[setting] ?? option;
  if (option.kind === 'switch') return { name: option.flag, help, group };
  const value = option.placeholder ?? rulesOf(option).placeholder(option);
  const usual = hidesDefault ? '' : describeDefault(command, setting);
  return { name: option.flag, value, help: `${help}${usual}`, group };
}

function describeDefault(command: Command, setting: SettingName): string {
  const option: OptionSpec = OPTIONS[setting];
  const value = COMMAND_SPECS[command].defaults[setting] ?? option.default;
  if (Array.isArray(value) || value === '') return '';
  const unit = 'unit' in option && option.unit ? ` ${option.unit}` : '';
  return ` Default: ${String(value)}${unit}.`;
}
