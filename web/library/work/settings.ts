/** The options of a call as settings, checked. */

import {
  checkSettings,
  COMMAND_DEFAULTS,
  defaultSettings,
  SETTING_NAMES,
  settingsOf,
} from '../../engine/settings/options';
import type { Command, SettingName, Settings } from '../../engine/settings/options';

/** What calls take besides settings. */
const OTHER_OPTIONS: Record<Command, readonly string[]> = {
  optimize: ['faces', 'ratio', 'fields', 'bind', 'validate', 'wantsBodies'],
  tune: [],
  modes: ['writesShapes'],
  compare: [],
  simulate: ['binding', 'settingsFile', 'records'],
  inspect: [],
};

/**
 * The settings of a command over the defaults of the method that they name. An option that is undefined is not given. Throws an
 * Error for an option that the command does not take, and SettingError for a value that is refused.
 */
export function settingsFrom(command: Command, options: object): Settings {
  const taken: readonly string[] = settingsOf(command);
  const given = Object.entries(options).filter(([, value]) => value !== undefined);
  for (const [name] of given)
    if (!taken.includes(name) && !OTHER_OPTIONS[command].includes(name)) throw unknownOption(command, name);
  const chosen = Object.fromEntries(given.filter(([name]) => taken.includes(name))) as Partial<Settings>;
  const base = { ...COMMAND_DEFAULTS[command], ...chosen };
  const settings: Settings = { ...defaultSettings(base.method), ...base };
  checkSettings(settings);
  return settings;
}

function unknownOption(command: Command, name: string): Error {
  const isSetting = (SETTING_NAMES as readonly string[]).includes(name);
  const why = isSetting
    ? 'is a setting of other calls: leave it out'
    : 'is no option: see the README of the package';
  return new Error(`${command} does not take "${name}", which ${why}.`);
}

/** The settings that a command takes, for its report; texts that are empty are left out. */
export function settingsAsUsed(command: Command, settings: Settings): Partial<Settings> {
  const used = settingsOf(command).filter((setting: SettingName) => settings[setting] !== '');
  return Object.fromEntries(used.map((setting) => [setting, settings[setting]]));
}

/** Throws an Error where a target is none. */
export function checkTarget(
  name: string,
  value: number | undefined,
  isAllowed: boolean,
  range: string,
): void {
  if (value !== undefined && !isAllowed) throw new Error(`${name} is ${value}: give ${range}.`);
}
