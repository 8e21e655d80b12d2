/** Parses the words of a command line into a command with its operands, settings and flags. */

import { parseArgs } from 'node:util';
import { ENGINE_MATERIAL } from '../engine/body/material';
import { coreMemory } from '../engine/core/memory_size';
import { MATERIALS, MATERIAL_NAMES } from '../engine/settings/materials';
import {
  checkAllUsed,
  checkSettings,
  OPTIONS,
  settingsOf,
  SOLVER_SETTINGS,
} from '../engine/settings/options';
import type { Note, Settings } from '../engine/settings/options';
import { PRESET_NAMES, settingsOfPreset } from '../engine/settings/presets';
import type { PresetName } from '../engine/settings/presets';
import { readNumber } from '../engine/settings/kinds';
import { describeRenamedChoices, readSettings } from '../engine/settings/setting_text';
import { FACE_COUNT, FACE_SHARE } from '../engine/settings/targets';
import type { ValueRule } from '../engine/settings/targets';
import { SOLVER_NAMES } from '../engine/solvers/profiles';
import { checkBendRatio } from '../engine/stages/tune';
import { engineFromFile, fileOfEngine } from './engine_file';
import { UsageError } from './failure';
import { readBatchFlags } from './batch/flags';
import type { BatchFlags } from './batch/flags';
import { COMMAND_SPECS, COMMANDS, engineCommand, flagsOf, INPUT_FORMATS } from './flags';
import type { Command, Flag } from './flags';
import { nearest } from '../engine/core/nearest';

export interface Arguments {
  command: Command;
  operands: string[];
  settings: Settings;
  /** notes on words of earlier versions */
  formerWords: Note[];
  /** null: not given */
  faces: number | null;
  ratio: number | null;
  fields: boolean;
  shapes: string | null;
  /** file for the binding of the original's vertices: optimize writes it, simulate reads it */
  bind: string | null;
  /** where the settings of the solver go; see --settings */
  settingsFile: string | null;
  /** where the simulated motion goes */
  record: string | null;
  /** names of the flags that the user gave */
  asked: ReadonlySet<string>;
  /** where reports go; '-' is stdout */
  reports: string[];
  quiet: boolean;
  /** a line for every warning */
  verbose: boolean;
  /** files of the user's own may be replaced */
  force: boolean;
  /** lists what would be written, and does nothing */
  dryRun: boolean;
  /** a missed target is not a failure */
  soft: boolean;
  /** whether the result is checked by the glTF validator */
  validates: boolean;
  /** the file of --engine; null: its parameters were given in words, or not */
  engineFile: string | null;
  /** the format of stdin, of --from; null: by its bytes */
  from: string | null;
  /** bytes that the core may use, of --memory; null: the maximum */
  memory: number | null;
  /** of --preset; null: none was named */
  preset: PresetName | null;
  /** further options of batch; for other commands the defaults */
  batch: BatchFlags;
}

/** A question that is answered instead of running the command. */
export type Question = { show: 'help'; command: Command | null } | { show: 'version' };

/** Throws UsageError or SettingError. */
export function parseArguments(words: string[]): Arguments | Question {
  const [first, ...rest] = words;
  if (first === undefined || ['--help', '-h'].includes(first)) return { show: 'help', command: null };
  if (first === 'help') return { show: 'help', command: helpedCommand(rest) };
  if (['--version', '-v', 'version'].includes(first)) return { show: 'version' };
  const command = commandNamed(first);
  const { values, operands } = readFlags(command, rest);
  if (values.has('help')) return { show: 'help', command };
  if (values.has('version')) return { show: 'version' };
  checkOperands(command, operands);
  const engine = values.get('engine');
  const settings = settingsFrom(command, values);
  const report = values.get('report');
  return {
    command,
    operands,
    settings,
    formerWords: describeRenamedChoices(settingsOf(engineCommand(command)), (flag) => values.get(flag)),
    faces: readTarget(values, 'faces', FACE_COUNT),
    ratio: readTarget(values, 'ratio', FACE_SHARE),
    fields: values.has('fields'),
    shapes: values.get('shapes') ?? null,
    bind: values.get('bind') ?? null,
    settingsFile: values.get('settings') ?? null,
    record: values.get('record') ?? null,
    asked: new Set(values.keys()),
    reports: [...new Set([...(report === undefined ? [] : [report]), ...(values.has('json') ? ['-'] : [])])],
    quiet: values.has('quiet'),
    verbose: values.has('verbose'),
    force: values.has('force'),
    dryRun: values.has('dry-run'),
    soft: values.has('soft'),
    validates: !values.has('no-validate'),
    engineFile: fileOfEngine(engine),
    from: readFormat(values.get('from')),
    memory: command === 'batch' ? null : readMemory(values.get('memory')),
    preset: presetNamed(values.get('preset')),
    batch: readBatchFlags(values),
  };
}

const readMemory = (text: string | undefined): number | null =>
  text === undefined ? null : coreMemory(text, '--memory');

/** The command that limber help is asked about; null: all of them. */
function helpedCommand([word, other]: string[]): Command | null {
  if (other !== undefined)
    throw new UsageError(`"${other}" is one command too many: limber help COMMAND, or limber help.`);
  return word === undefined || word.startsWith('-') ? null : commandNamed(word);
}

function commandNamed(word: string): Command {
  const command = COMMANDS.find((candidate) => candidate === word);
  if (command) return command;
  const guess = nearest(word, COMMANDS);
  const hint = guess ? `did you mean "${guess}"?` : `use ${COMMANDS.join(', ')} (limber --help).`;
  throw new UsageError(`There is no command "${word}": ${hint}`);
}

/** Flags whose values are patterns of names: repeated, they stand for the names of any of them. */
const PATTERNS: ReadonlySet<string> = new Set(
  Object.values(OPTIONS)
    .filter(({ kind }) => kind === 'pattern')
    .map(({ flag }) => flag),
);

/** Values by flag name, of a repeated flag the last one, or all patterns; '' for a switch. Refuses unknown flags and missing values. */
function readFlags(command: Command, words: string[]): { values: Map<string, string>; operands: string[] } {
  const flags = flagsOf(command);
  const known = new Map(flags.map((flag) => [flag.name, flag]));
  const entries = flags.map(
    ({ name, value }) => [name, { type: value ? ('string' as const) : ('boolean' as const) }] as const,
  );
  const options = { ...Object.fromEntries(entries), help: { type: 'boolean' as const, short: 'h' } };
  const { tokens } = parseArgs({ args: words, options, strict: false, allowPositionals: true, tokens: true });
  const values = new Map<string, string>();
  const operands: string[] = [];
  for (const token of tokens)
    if (token.kind === 'positional') operands.push(token.value);
    else if (token.kind === 'option') {
      const value = readValue(command, known, token);
      const earlier = PATTERNS.has(token.name) ? values.get(token.name) : undefined;
      values.set(token.name, earlier === undefined ? value : `${earlier}|${value}`);
    }
  return { values, operands };
}

function readValue(
  command: Command,
  known: Map<string, Flag>,
  token: { name: string; rawName: string; value?: string },
) {
  const { name, value } = token;
  const flag = known.get(name);
  if (!flag) throw unknownFlag(command, token.rawName, [...known.keys()]);
  if (flag.value === undefined) {
    if (value !== undefined) throw new UsageError(`--${name} takes no value.`);
    return '';
  }
  if (value === undefined || value.startsWith('--') || value === '')
    // Dots at the end of what stands for a value end the sentence as well.
    throw new UsageError(`--${name} needs a value: --${name} ${flag.value}.`.replace(/\.{4}$/, '...'));
  return value;
}

function unknownFlag(command: Command, rawName: string, known: string[]): UsageError {
  const name = rawName.replace(/^-+/, '');
  const guess = nearest(name, known);
  const hint = guess ? `did you mean --${guess}?` : `see limber ${command} --help.`;
  return new UsageError(`limber ${command} has no ${rawName}: ${hint}`);
}

function checkOperands(command: Command, operands: string[]): void {
  const wanted = COMMAND_SPECS[command].operands;
  const usage = `limber ${command} ${wanted.join(' ')}`;
  if (operands.length < wanted.filter((name) => !name.startsWith('[')).length)
    throw new UsageError(describeMissing(command, operands));
  const empty = operands.indexOf('');
  if (empty >= 0)
    throw new UsageError(
      `${wanted[Math.min(empty, wanted.length - 1)]} is empty: give the name of a file: ${usage}.`,
    );
  const isOpen = wanted.some((name) => name.endsWith('...'));
  if (operands.length > wanted.length && !isOpen)
    throw new UsageError(`"${operands[wanted.length]}" is one file too many: ${usage}.`);
}

/** What the operands stand for; OUT of a batch is a folder. */
const MEANINGS: Record<string, string> = {
  IN: 'the model to read',
  OUT: 'the file to write',
  A: 'the original',
  B: 'the model to compare with it',
  'SRC...': 'the models or folders of them',
};

/** The first operand that is missing, and the command with what is there. */
function describeMissing(command: Command, given: string[]): string {
  const wanted = COMMAND_SPECS[command].operands;
  const name = wanted[given.length];
  const meaning = command === 'batch' && name === 'OUT' ? 'the folder for the results' : MEANINGS[name];
  const usage = ['limber', command, ...given, ...wanted.slice(given.length)].join(' ');
  return `${name} is missing: give ${meaning}, as in ${usage} (options: limber help ${command}).`;
}

/** Throws SettingError. */
function settingsFrom(command: Command, values: Map<string, string>): Settings {
  const base = {
    ...COMMAND_SPECS[command].defaults,
    ...readPreset(values),
    ...readEngine(values),
    ...readMaterial(values),
  };
  if (values.get('substeps') === 'auto') {
    values.delete('substeps');
    values.set('converge', '');
  }
  if (values.has('like-input')) readLikeInput(values);
  const names = settingsOf(engineCommand(command));
  const settings = readSettings(names, (flag) => values.get(flag), base);
  checkSettings(settings);
  checkSolverFlags(command, settings, values);
  checkAllUsed(
    settings,
    names.filter((name) => values.has(OPTIONS[name].flag)),
  );
  return settings;
}

/** --like-input is the default, said aloud: it counts over that of a preset. */
function readLikeInput(values: Map<string, string>): void {
  const other = values.get('compress') ?? 'like-input';
  if (other !== 'like-input')
    throw new UsageError(`--like-input and --compress ${other} contradict each other: give one of them.`);
  values.set('compress', other);
}

/** Checks that options of a solver have one, and that limber tune has a settings file to write. */
function checkSolverFlags(command: Command, settings: Settings, values: Map<string, string>): void {
  const { solver } = settings;
  if (solver === 'none') {
    const ofSolver = SOLVER_SETTINGS.map((name) => OPTIONS[name].flag);
    const flags = [...ofSolver, ...(command === 'simulate' ? [] : ['settings'])];
    const flag = flags.find((name) => values.has(name));
    if (command === 'tune' || flag !== undefined)
      throw new UsageError(
        `${command === 'tune' ? 'limber tune' : `--${flag}`} needs a solver: --solver ${SOLVER_NAMES.join('|')}.`,
      );
  } else if (command === 'tune' && !values.has('settings'))
    throw new UsageError('limber tune needs a file for what it finds: --settings FILE.');
  else if (values.has('bend-ratio')) checkBendRatio(settings);
}

/** The settings of --preset; none without it. */
function readPreset(values: Map<string, string>): Partial<Settings> {
  const name = presetNamed(values.get('preset'));
  return name === null ? {} : settingsOfPreset(name);
}

function presetNamed(name: string | undefined): PresetName | null {
  if (name === undefined) return null;
  const known = PRESET_NAMES.find((candidate) => candidate === name);
  if (!known) throw new UsageError(`--preset is ${name}: give one of ${PRESET_NAMES.join(', ')}.`);
  return known;
}

/** Puts the parameters of a file that --engine names in its place; the material that they came with, of a settings file. */
function readEngine(values: Map<string, string>): Partial<Settings> {
  const value = values.get('engine');
  if (value === undefined) return {};
  const named = readMaterial(values);
  const others = ENGINE_MATERIAL.filter((name) => name in named || values.has(OPTIONS[name].flag));
  const { text, material } = engineFromFile(value, others);
  values.set('engine', text);
  return material;
}

/** The four numbers of --material-preset; none without it. */
function readMaterial(values: Map<string, string>): Partial<Settings> {
  const name = values.get('material-preset');
  if (name === undefined) return {};
  const known = MATERIAL_NAMES.find((candidate) => candidate === name);
  if (!known) throw new UsageError(`--material-preset is ${name}: give one of ${MATERIAL_NAMES.join(', ')}.`);
  return MATERIALS[known];
}

/** The format of --from. */
function readFormat(text: string | undefined): string | null {
  if (text === undefined) return null;
  const known = INPUT_FORMATS.find((format) => format === text.toLowerCase());
  if (!known) throw new UsageError(`--from is ${text}: give one of ${INPUT_FORMATS.join(', ')}.`);
  return known;
}

function readTarget(
  values: Map<string, string>,
  name: string,
  { isAllowed, words }: ValueRule,
): number | null {
  const text = values.get(name);
  if (text === undefined) return null;
  const value = readNumber(text);
  if (typeof value !== 'number' || !isAllowed(value))
    throw new UsageError(`--${name} is ${text}: give ${words}.`);
  return value;
}
