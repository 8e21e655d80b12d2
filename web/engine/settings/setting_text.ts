/** Settings as text and back, the same for flags and for links. */

import { OPTIONS, defaultSettings } from './options';
import type { OptionSpec, Settings } from './options';

const DECIMAL = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

/** The value that `text` stands for; text that is no number comes back as it is, and the range check refuses it. */
export function readSetting(option: OptionSpec, text: string): unknown {
  if (option.kind === 'switch') return true;
  const isWord =
    ['pins', 'paint', 'colliders', 'name', 'choice'].includes(option.kind) ||
    (option.kind === 'modes' && ['auto', 'all'].includes(text));
  if (isWord) return text;
  const isList = option.kind === 'modes' || option.kind === 'numbers';
  return isList ? text.split(',').map(readNumber) : readNumber(text);
}

export function readNumber(text: string): number | string {
  if (/^\+?inf(inity)?$/i.test(text)) return Infinity;
  return DECIMAL.test(text) ? Number(text) : text;
}

/** A setting that is not as its method has it; a switch that is on has no text. */
export interface ChangedSetting {
  key: keyof Settings;
  flag: string;
  text: string | null;
}

/** What makes these settings of the defaults, in the order of OPTIONS; threads change no result. */
export function changedSettings(settings: Settings): ChangedSetting[] {
  const defaults = defaultSettings(settings.method);
  const isChanged = (key: keyof Settings) =>
    key === 'method'
      ? settings.method !== OPTIONS.method.default
      : String(settings[key]) !== String(defaults[key]);
  return (Object.keys(OPTIONS) as (keyof Settings)[])
    .filter((key) => key !== 'threads' && isChanged(key))
    .map((key) => ({ key, flag: OPTIONS[key].flag, text: textOf(settings[key]) }));
}

function textOf(value: Settings[keyof Settings]): string | null {
  if (value === true) return null;
  return value === Infinity ? 'inf' : String(value);
}
