/** The user's own parameters of an engine from a file: a JSON object, lines of name=value, or what a settings file's original was given. */

import { existsSync } from 'node:fs';
import { basename } from 'node:path';
import type { EngineMaterial } from '../engine/body/material';
import { excerpt, quotedJson } from '../engine/core/words';
import { originalMaterial, originalParameters } from '../engine/report/original_parameters';
import { readSettingsFile } from '../engine/report/settings_reader';
import { engineText } from '../engine/settings/engine_text';
import type { NativeValues } from '../engine/solvers/profile';
import { UsageError } from './failure';
import { readText } from './input_files/read_file';

/** The file that a value of --engine names; null where it has the parameters themselves, or there is none. */
export const fileOfEngine = (value: string | undefined): string | null =>
  value === undefined || (value.includes('=') && !existsSync(value)) ? null : value;

/** The user's own parameters as name=value with commas between, and of a settings file the material that the others follow from. */
interface GivenEngine {
  text: string;
  material: Partial<EngineMaterial>;
}

/** What --engine gives: itself, or the content of the file that it names. `others`: the properties of the material that other flags give. */
export function engineFromFile(value: string, others: readonly (keyof EngineMaterial)[]): GivenEngine {
  if (fileOfEngine(value) === null) return { text: value, material: {} };
  if (!value.includes('.') && !existsSync(value))
    throw new UsageError(
      `--engine ${value} is neither name=value nor a file: give name=value, separated by commas.`,
    );
  return engineOfText(value, readText(value), others);
}

/** What a file of parameters gives, see `engineFromFile`. Throws UsageError, or an Error of the reader of settings files. */
export function engineOfText(
  file: string,
  content: string,
  others: readonly (keyof EngineMaterial)[] = [],
): GivenEngine {
  const text = content.trim();
  if (!text.startsWith('{')) return { text: textOfLines(text), material: {} };
  const values = parsed(file, text);
  if (!isSettingsFile(values)) return { text: textOfValues(file, values), material: {} };
  const settings = readSettingsFile(basename(file), text);
  return { text: engineText(originalParameters(settings, others)), material: originalMaterial(settings) };
}

function parsed(file: string, text: string): object {
  try {
    return JSON.parse(text) as object;
  } catch {
    throw new UsageError(`${file} is not JSON: give an object of numbers, or lines of name=value.`);
  }
}

function textOfValues(file: string, values: object): string {
  const wrong = Object.entries(values).find(([, value]) => typeof value !== 'number');
  if (wrong)
    throw new UsageError(`${file} has ${quotedJson(wrong[1])} for ${excerpt(wrong[0])}: give a number.`);
  return engineText(values as NativeValues);
}

const isSettingsFile = (values: object): boolean => {
  const { schema } = values as Record<string, unknown>;
  return typeof schema === 'string' && schema.startsWith('limber-settings/');
};

/** Lines may end in a comment after #. */
const textOfLines = (text: string): string =>
  text
    .split('\n')
    .map((line) => line.replace(/#.*/, '').trim())
    .filter((line) => line !== '')
    .join(',');
