/** The configuration of a batch: options for all assets, and others for some of them (docs/batch.schema.json). */

import { describeJsonPosition } from '../core/json_position';
import { excerpt, quotedJson } from '../core/words';
import { checkSetting } from './check';
import { settingsOf } from './commands';
import { SettingError, wordSentence } from './errors';
import { defaultSettings } from './methods';
import { matchesPath } from './path_pattern';
import { changedSettings } from './setting_text';
import { OPTIONS } from './table';
import type { SettingName, Settings } from './table';
import { FACE_COUNT, FACE_SHARE, SWITCH } from './targets';
import type { ValueRule } from './targets';

export const BATCH_SCHEMA = 'limber-batch/1';

/** Targets and outputs of an asset besides its settings. */
export interface AssetTargets {
  /** the most faces that may be left */
  faces?: number;
  /** the share of faces to keep, in (0, 1]; 0.5 without any other target */
  ratio?: number;
  /** whether missing a target is not an error */
  soft?: boolean;
  /** write strain and curvature as attributes */
  fields?: boolean;
  /** write the report beside the result */
  reports?: boolean;
  /** write the binding of the original's vertices beside the result */
  bindings?: boolean;
  /** write the settings of the solver beside the result; needs a solver */
  settingsFiles?: boolean;
  /** measure how far frequencies are off, as limber compare does */
  frequencies?: boolean;
}

/** Settings by name, as the library takes them, and targets. */
export type AssetOptions = Partial<Settings> & AssetTargets;

export interface BatchOverride {
  /** patterns of paths below SRC, of which one has to match */
  files: string[];
  options: AssetOptions;
}

export interface BatchConfig {
  options: AssetOptions;
  /** later ones take precedence */
  overrides: BatchOverride[];
  /** patterns of paths that are not assets */
  exclude: string[];
}

export const EMPTY_CONFIG: BatchConfig = { options: {}, overrides: [], exclude: [] };

/** The rule for the value of each target. */
const TARGETS: Record<keyof AssetTargets, ValueRule> = {
  faces: FACE_COUNT,
  ratio: FACE_SHARE,
  soft: SWITCH,
  fields: SWITCH,
  reports: SWITCH,
  bindings: SWITCH,
  settingsFiles: SWITCH,
  frequencies: SWITCH,
};

export const TARGET_NAMES = Object.keys(TARGETS) as (keyof AssetTargets)[];

/** The text of a configuration that gives every asset these settings, without those of a machine or one file. */
export function writeBatchConfig(settings: Settings, targets: AssetTargets = {}): string {
  const changed = changedSettings(settings).filter(({ key }) => !OPTIONS[key].isOfFile && isOfAssets(key));
  const values = changed.map(({ key }) => [key, settings[key] === Infinity ? 'inf' : settings[key]]);
  const options = { ...Object.fromEntries(values), ...targets };
  return `${JSON.stringify({ schema: BATCH_SCHEMA, options, overrides: [] }, null, 2)}\n`;
}

/** Parses a configuration. Throws an Error whose sentence begins with `name` and says where. */
export function readBatchConfig(text: string, name: string): BatchConfig {
  const root = parse(text, name);
  checkKeys(root, ['$schema', 'schema', 'options', 'overrides', 'exclude'], name);
  if (root.schema !== BATCH_SCHEMA)
    throw new Error(`${name} has ${schemaWords(root.schema)}: give "schema": "${BATCH_SCHEMA}".`);
  const overrides = listOf(root.overrides ?? [], `${name}: overrides`).map((one, i) =>
    readOverride(one, `${name}: overrides[${i}]`),
  );
  return {
    options: readOptions(root.options ?? {}, `${name}: options`),
    overrides,
    exclude: readPatterns(root.exclude ?? [], `${name}: exclude`),
  };
}

/** The options of an asset, by its path below SRC: overrides take precedence over `flags`, and these over the rest of the configuration. */
export const optionsFor = (
  { options, overrides }: BatchConfig,
  path: string,
  flags: AssetOptions,
): AssetOptions => {
  const own = overrides.filter(({ files }) => files.some((pattern) => matchesPath(pattern, path)));
  return Object.assign({}, options, flags, ...own.map((override) => override.options)) as AssetOptions;
};

/** A clause on each pattern of an override that matches none of the paths. `name`: that of the configuration. */
export const unusedPatterns = ({ overrides }: BatchConfig, paths: string[], name: string): string[] =>
  overrides.flatMap(({ files }, i) =>
    files
      .filter((pattern) => !paths.some((path) => matchesPath(pattern, path)))
      .map(
        (pattern) =>
          `${name}: overrides[${i}].files has ${quotedJson(pattern)}, which matches no asset: check its spelling`,
      ),
  );

/** The settings that options stand for, over the defaults of the method that they name. Nothing is checked. */
export function settingsFor(options: AssetOptions): Settings {
  const names = settingsOf('optimize').filter((name) => options[name] !== undefined);
  const given = Object.fromEntries(names.map((name) => [name, options[name]])) as Partial<Settings>;
  return { ...defaultSettings(given.method), ...given };
}

export const isExcluded = ({ exclude }: BatchConfig, path: string): boolean =>
  exclude.some((pattern) => matchesPath(pattern, path));

/** Whether a setting can be given per asset: settings of the machine belong on the command line. */
const isOfAssets = (name: SettingName): boolean =>
  settingsOf('optimize').includes(name) && !OPTIONS[name].isOfMachine;

function parse(text: string, name: string): Record<string, unknown> {
  try {
    return objectOf(JSON.parse(text.replace(/^\ufeff/, '')), name);
  } catch (error) {
    if (!(error instanceof SyntaxError)) throw error;
    const where = describeJsonPosition(text, error);
    throw new Error(`${name} is not JSON${where}: check its commas, quotes and brackets.`);
  }
}

const schemaWords = (schema: unknown): string =>
  schema === undefined ? 'no schema' : `the schema ${quotedJson(schema)}`;

function readOverride(value: unknown, where: string): BatchOverride {
  const override = objectOf(value, where);
  checkKeys(override, ['files', 'options'], where);
  const { files } = override;
  const cure = 'give a pattern such as "props/**", or a list of them';
  if (files === undefined) throw new Error(`${where} has no files: ${cure}.`);
  if (typeof files !== 'string' && !Array.isArray(files))
    throw new Error(`${where}.files is ${quotedJson(files)}: ${cure}.`);
  const patterns = readPatterns([files].flat(), `${where}.files`);
  if (patterns.length === 0) throw new Error(`${where}.files is empty: ${cure}.`);
  return { files: patterns, options: readOptions(override.options, `${where}.options`) };
}

function readPatterns(value: unknown, where: string): string[] {
  const patterns = listOf(value, where);
  const wrong = patterns.find((pattern) => typeof pattern !== 'string' || pattern === '');
  if (wrong !== undefined) throw new Error(`${where} has ${quotedJson(wrong)}: give patterns as strings.`);
  return patterns as string[];
}

function readOptions(value: unknown, where: string): AssetOptions {
  const entries = Object.entries(objectOf(value, where)).map(([name, given]) => {
    if (Object.hasOwn(TARGETS, name)) checkTarget(name as keyof AssetTargets, given, where);
    else return [name, readSettingValue(name, given, where)];
    return [name, given];
  });
  return Object.fromEntries(entries) as AssetOptions;
}

function checkTarget(name: keyof AssetTargets, value: unknown, where: string): void {
  const { isAllowed, words } = TARGETS[name];
  if (!isAllowed(value)) throw new Error(`${where}: ${name} is ${quotedJson(value)}: give ${words}.`);
}

function readSettingValue(name: string, given: unknown, where: string): unknown {
  if (!Object.hasOwn(OPTIONS, name) || !settingsOf('optimize').includes(name as SettingName))
    throw new Error(`${where}: there is no option "${excerpt(name)}": see docs/batch.schema.json.`);
  if (!isOfAssets(name as SettingName))
    throw new Error(`${where}: ${name} depends on the machine: give it on the command line.`);
  const value = given === 'inf' ? Infinity : given;
  try {
    checkSetting(name as SettingName, value, 'json');
  } catch (error) {
    if (!(error instanceof SettingError)) throw error;
    throw new Error(`${where}: ${wordSentence(name, error.sentence, (other) => other)}`);
  }
  return value;
}

function objectOf(value: unknown, where: string): Record<string, unknown> {
  if (typeof value === 'object' && value !== null && !Array.isArray(value))
    return value as Record<string, unknown>;
  throw new Error(`${where} is not an object: give { ... }.`);
}

function listOf(value: unknown, where: string): unknown[] {
  if (Array.isArray(value)) return value;
  throw new Error(`${where} is not a list: give [ ... ].`);
}

function checkKeys(value: object, known: string[], where: string): void {
  const wrong = Object.keys(value).find((key) => !known.includes(key));
  if (wrong !== undefined)
    throw new Error(
      `${where} has "${excerpt(wrong)}", which is unknown: use ${known.filter((key) => !key.startsWith('$')).join(', ')}.`,
    );
}
