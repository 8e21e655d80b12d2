/** The user's own parameters of an engine from a file: a JSON object, lines of name=value, or a settings file's original. */

import { existsSync } from 'node:fs';
import { basename } from 'node:path';
import { excerpt, quotedJson } from '../engine/core/words';
import { originalParameters } from '../engine/report/original_parameters';
import { readSettingsFile } from '../engine/report/settings_reader';
import type { NativeValues } from '../engine/solvers/profile';
import { UsageError } from './failure';
import { readText } from './input_files/read_file';

/** The file that a value of --engine names; null where it has the parameters themselves, or there is none. */
export const fileOfEngine = (value: string | undefined): string | null =>
  value === undefined || (value.includes('=') && !existsSync(value)) ? null : value;

/** The value of --engine as name=value with commas: itself, or the content of the file that it names. */
export function engineFromFile(value: string): string {
  if (fileOfEngine(value) === null) return value;
  if (!value.includes('.') && !existsSync(value))
    throw new UsageError(
      `--engine ${value} is neither name=value nor a file: give name=value with commas between.`,
    );
  return engineOfText(value, readText(value));
}

/** The content of a file of parameters as name=value with commas. Throws UsageError. */
export function engineOfText(file: string, content: string): string {
  const text = content.trim();
  return text.startsWith('{') ? textOfJson(file, text) : textOfLines(text);
}

function textOfJson(file: string, text: string): string {
  let values: unknown;
  try {
    values = JSON.parse(text);
  } catch {
    throw new UsageError(`${file} is not JSON: give an object of numbers, or lines of name=value.`);
  }
  const entries = Object.entries(isSettingsFile(values) ? originalOf(file, text) : (values as object));
  const wrong = entries.find(([, value]) => typeof value !== 'number');
  if (wrong)
    throw new UsageError(`${file} has ${quotedJson(wrong[1])} for ${excerpt(wrong[0])}: give a number.`);
  return entries.map(([name, value]) => `${name}=${value}`).join(',');
}

const isSettingsFile = (values: unknown): boolean => {
  const { schema } = values as Record<string, unknown>;
  return typeof schema === 'string' && schema.startsWith('limber-settings/');
};

/** What a settings file was tuned to: the numbers of its original, under the names of the engine. */
const originalOf = (file: string, text: string): NativeValues =>
  originalParameters(readSettingsFile(basename(file), text));

/** Lines may end in a comment after #. */
const textOfLines = (text: string): string =>
  text
    .split('\n')
    .map((line) => line.replace(/#.*/, '').trim())
    .filter((line) => line !== '')
    .join(',');
