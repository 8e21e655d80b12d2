/** Settings as text and back, the same for flags and for links. */

import type { Note } from './errors';
import { rulesOf } from './kinds';
import { defaultSettings } from './methods';
import { OPTIONS, SETTING_NAMES } from './table';
import type { SettingName, Settings } from './table';
import type { OptionSpec } from './types';

/** Parses the text of a setting; text that should be a number and is not is returned unchanged, and the range check refuses it. */
export const readSetting = (option: OptionSpec, text: string): unknown =>
  rulesOf(option).read(presentChoice(option, text) ?? text);

/** The present name of a choice that had another name in an earlier version; null for every other text. */
const presentChoice = (option: OptionSpec, text: string): string | null =>
  option.kind === 'choice' && option.formerly && Object.hasOwn(option.formerly, text)
    ? option.formerly[text]
    : null;

/** A sentence about each text that is the name of a choice in an earlier version. */
export function describeRenamedChoices(
  names: readonly SettingName[],
  textOfFlag: (flag: string) => string | null | undefined,
): Note[] {
  return names.flatMap((setting) => {
    const option = OPTIONS[setting];
    const text = textOfFlag(option.flag);
    const word = typeof text === 'string' ? presentChoice(option, text) : null;
    if (word === null) return [];
    return [[{ setting }, ` ${text} of earlier versions is now ${word} (default: ${option.default})`]];
  });
}

/** Parses settings, over the defaults of the method that they name, or over `base`. Values are not checked. */
export function readSettings(
  names: readonly SettingName[],
  textOfFlag: (flag: string) => string | null | undefined,
  base: Partial<Settings> = {},
): Settings {
  const word = textOfFlag(OPTIONS.method.flag);
  const asked = names.includes('method') && OPTIONS.method.choices.find((name) => name === word);
  const settings = { ...defaultSettings((asked || base.method) as Settings['method']), ...base };
  for (const name of names) {
    const text = textOfFlag(OPTIONS[name].flag);
    if (text !== null && text !== undefined)
      Object.assign(settings, { [name]: readSetting(OPTIONS[name], text) });
  }
  return settings;
}

/** A setting that differs from the default of its method; a switch that is on has no text. */
export interface ChangedSetting {
  key: SettingName;
  flag: string;
  text: string | null;
}

/** The settings that differ from their defaults, in the order of the table, without those of the machine. */
export function changedSettings(settings: Settings): ChangedSetting[] {
  const defaults: Settings = {
    ...defaultSettings(settings.method),
    method: OPTIONS.method.default as Settings['method'],
  };
  return SETTING_NAMES.filter(
    (key) => !OPTIONS[key].isOfMachine && String(settings[key]) !== String(defaults[key]),
  ).map((key) => ({ key, flag: OPTIONS[key].flag, text: textOf(settings[key]) }));
}

function textOf(value: Settings[SettingName]): string | null {
  if (value === true) return null;
  return value === Infinity ? 'inf' : String(value);
}
