/** Settings and their values in the words of their controls on the page. */

import { defaultSettings, OPTIONS, SETTING_NAMES } from '../../../engine/settings/options';
import type { OptionSpec, SettingName, Settings } from '../../../engine/settings/options';
import { say } from '../../language/say';
import { MODELS } from '../motion/motion_panel';
import { ACROSS_SEAMS } from '../reduce/stop_reason';
import { FIT_CHOICES, FIX_BORDERS } from '../reduce/reduce_panel';
import { SHELL, SOLID, SPRINGS } from '../simulate/solver_select';
import { COMPRESSION_NAMES } from './form_section';

type ChoiceWords = Partial<Record<SettingName, Readonly<Record<string, string>>>>;

const textsOf = (choices: readonly { value: string; text: string }[]): Record<string, string> =>
  Object.fromEntries(choices.map(({ value, text }) => [value, text]));

/** Words for the choices of a list or of buttons; "on" and "off" for a switch. */
const CHOICES: ChoiceWords = {
  compress: COMPRESSION_NAMES,
  fit: textsOf(FIT_CHOICES),
  model: textsOf(MODELS),
  material: { solid: SOLID.solid.text, shell: SHELL.text, springs: SPRINGS.text },
  borders: { fixed: 'on', free: 'off' },
  seams: { cross: 'on', keep: 'off' },
};

/** Names of controls that differ from the name of the setting. */
const LABELS: Partial<Record<SettingName, string>> = {
  material: 'Solver',
  borders: FIX_BORDERS,
  seams: ACROSS_SEAMS,
};

export const labelOf = (name: SettingName): string => say(LABELS[name] ?? OPTIONS[name].label);

export function valueWords(name: SettingName, value: Settings[SettingName]): string {
  if (Array.isArray(value)) return value.length > 0 ? value.join(', ') : say('none');
  if (typeof value === 'number') return numberWords(name, value);
  const text = CHOICES[name]?.[String(value)] ?? String(value);
  return say(text === '' ? 'none' : text);
}

function numberWords(name: SettingName, value: number): string {
  const option: OptionSpec = OPTIONS[name];
  if (option.kind !== 'number') return String(value);
  if (option.isOffAtZero && value === 0) return say('off');
  const { unit } = option;
  return unit ? `${value}\u00a0${unit.startsWith('%') ? '%' : say(unit)}` : String(value);
}

/** The settings of a result that differ from the defaults, except its format: "Compression: Draco, Largest deviation: 0.5 %". */
export function changedWords(settings: Settings): string {
  const usual = defaultSettings();
  return SETTING_NAMES.filter((name) => name !== 'format' && !OPTIONS[name].isOfMachine)
    .filter((name) => String(settings[name]) !== String(usual[name]))
    .map((name) => `${labelOf(name)}: ${valueWords(name, settings[name])}`)
    .join(', ');
}
