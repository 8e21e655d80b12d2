/** The command line that writes the same bytes as the page. */

import { readsSetting, settingsOf } from '../engine/settings/options';
import type { Settings } from '../engine/settings/options';
import { changedSettings } from '../engine/settings/setting_text';

const quoted = (word: string): string =>
  /^[\w./:,+-]+$/.test(word) ? word : `'${word.replaceAll("'", `'\\''`)}'`;

interface CommandFiles {
  faces: number;
  fields: boolean;
  /** names of further files; null: not requested */
  binding: string | null;
  settings: string | null;
  /** whether the result has more faces than requested, which would otherwise be a failure */
  isMissed: boolean;
}

/** A name that cannot be mistaken for a flag. */
const operand = (name: string): string => (name.startsWith('-') ? `./${name}` : name);

export function commandLine(
  settings: Settings,
  input: string,
  output: string,
  { faces, fields, binding, settings: file, isMissed }: CommandFiles,
): string {
  const flags = changedSettings(settings)
    .filter(({ key }) => settingsOf('optimize').includes(key) && readsSetting(settings, key))
    .flatMap(({ flag, text }) => [`--${flag}`, ...(text === null ? [] : [text])]);
  const words = ['limber', 'optimize', operand(input), operand(output), '--faces', String(faces), ...flags];
  const extras = [
    ...(fields ? ['--fields'] : []),
    ...(binding === null ? [] : ['--bind', binding]),
    ...(file === null ? [] : ['--settings', file]),
    ...(isMissed ? ['--soft'] : []),
  ];
  return [...words, ...extras].map(quoted).join(' ');
}
