/** The command that makes the same bytes as the page. */

import { OPTIONS, defaultSettings } from '../engine/options';
import type { Settings } from '../engine/options';

const quoted = (word: string): string =>
  /^[\w./:-]+$/.test(word) ? word : `'${word.replaceAll("'", `'\\''`)}'`;

/** A switch stands alone. */
const valueOf = (value: Settings[keyof Settings]): string[] =>
  value === true ? [] : [value === Infinity ? 'inf' : String(value)];

export function commandLine(
  settings: Settings,
  input: string,
  output: string,
  { faces, fields }: { faces: number; fields: boolean },
): string {
  const defaults = defaultSettings(settings.method);
  const isChanged = (key: keyof Settings) =>
    key === 'method'
      ? settings.method !== OPTIONS.method.default
      : String(settings[key]) !== String(defaults[key]);
  const flags = (Object.keys(OPTIONS) as (keyof Settings)[])
    .filter((key) => key !== 'threads' && isChanged(key))
    .flatMap((key) => [`--${OPTIONS[key].flag}`, ...valueOf(settings[key])]);
  const words = ['limber', 'optimize', input, output, '--faces', String(faces), ...flags];
  return [...words, ...(fields ? ['--fields'] : [])].map(quoted).join(' ');
}
