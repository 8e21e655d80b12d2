/** The options of a call as settings, checked. */

import { nearest } from '../../engine/core/nearest';
import { excerpt, quotedValue } from '../../engine/core/words';
import {
  checkAllUsed,
  checkSetting,
  checkSettings,
  COMMAND_DEFAULTS,
  defaultSettings,
  OPTIONS,
  SETTING_NAMES,
  SettingError,
  settingsOf,
  SOLVER_SETTINGS,
} from '../../engine/settings/options';
import type { Command, SettingName, Settings } from '../../engine/settings/options';
import { FACE_COUNT, FACE_SHARE, SWITCH } from '../../engine/settings/targets';
import type { ValueRule } from '../../engine/settings/targets';
import { SOLVER_NAMES } from '../../engine/solvers/profiles';
import { checkBendRatio } from '../../engine/stages/tune';

const textOf = (file: string): ValueRule => ({
  isAllowed: (value) => typeof value === 'string' || value === null,
  words: `the text of a ${file}, or null`,
});

/** Options of calls besides settings. */
const OTHER_OPTIONS: Record<Command, Readonly<Record<string, ValueRule>>> = {
  optimize: {
    faces: FACE_COUNT,
    ratio: FACE_SHARE,
    fields: SWITCH,
    bind: SWITCH,
    validate: SWITCH,
    wantsBodies: SWITCH,
  },
  tune: {},
  modes: { writesShapes: SWITCH },
  compare: {},
  simulate: { binding: textOf('binding file'), settingsFile: textOf('settings file'), records: SWITCH },
  inspect: {},
};

/**
 * The settings of a command over the defaults of the method that they name. An option that is undefined is not given. Throws an
 * Error for an option that the command does not take or that is no setting, and SettingError for a setting that is refused.
 */
export function settingsFrom(command: Command, options: object): Settings {
  const taken: readonly string[] = settingsOf(command);
  const given = Object.entries(options).filter(([, value]) => value !== undefined);
  for (const [name, value] of given) if (!taken.includes(name)) checkOther(command, name, value);
  const chosen = Object.fromEntries(given.filter(([name]) => taken.includes(name))) as Partial<Settings>;
  const base = { ...COMMAND_DEFAULTS[command], ...chosen };
  // The defaults of the others follow from it.
  if (base.method !== undefined) checkSetting('method', base.method, 'script');
  const settings: Settings = { ...defaultSettings(base.method), ...base };
  checkSettings(settings, 'script');
  checkSolver(command, settings);
  if (chosen.bendRatio !== undefined) checkBendRatio(settings);
  checkAllUsed(settings, Object.keys(chosen) as SettingName[], 'script');
  return settings;
}

/** Throws an Error where the command does not take the option, or not with this value. */
function checkOther(command: Command, name: string, value: unknown): void {
  const rules = OTHER_OPTIONS[command];
  if (!Object.hasOwn(rules, name)) throw unknownOption(command, name);
  const { isAllowed, words } = rules[name];
  if (!isAllowed(value)) throw new Error(`${name} is ${quotedValue(value)}: give ${words}.`);
}

/** Throws an Error for options that need a solver without one. */
function checkSolver(command: Command, settings: Settings): void {
  if (settings.solver !== 'none') return;
  const cure = `needs a solver: name one of ${SOLVER_NAMES.join(', ')} as "solver".`;
  if (command === 'tune') throw new Error(`tune ${cure}`);
  const setting = SOLVER_SETTINGS.find((name) => settings[name] !== OPTIONS[name].default);
  if (setting !== undefined) throw new SettingError(setting, cure);
}

function unknownOption(command: Command, name: string): Error {
  const isSetting = (SETTING_NAMES as readonly string[]).includes(name);
  const why = isSetting
    ? 'is a setting of other calls: leave it out.'
    : `is no option: ${adviceOn(command, name)}`;
  return new Error(`${command} does not take "${excerpt(name)}", which ${why}`);
}

/** What was probably meant by the name of an option that does not exist: a flag of the command line, or another spelling. */
function adviceOn(command: Command, name: string): string {
  const settings = settingsOf(command);
  const known = [...settings, ...Object.keys(OTHER_OPTIONS[command]).filter((one) => one !== 'wantsBodies')];
  const meant = settings.find((setting) => OPTIONS[setting].flag === name) ?? nearest(name, known);
  return meant === null ? 'see the README of the package.' : `did you mean "${meant}"?`;
}
