/** Whether a value is one that a setting allows, and the sentence where it is not. */

import { parseColliders } from '../motion/colliders';
import type { OptionSpec, Settings } from './options';
import { parsePaint } from '../body/paint';
import { parsePins } from '../body/pins';

/** `range` in words: "a number from 0 to 1". */
function describeRange(option: OptionSpec): string {
  const { min, max, kind } = option;
  const noun = kind === 'integer' || kind === 'modes' ? 'a whole number' : 'a number';
  const range = max === Infinity ? `${noun} of at least ${min}, or inf` : `${noun} from ${min} to ${max}`;
  if (kind === 'choice') return `one of ${option.choices!.join(', ')}`;
  if (kind === 'switch') return 'true or false';
  if (kind === 'name') return 'the name of an attribute';
  if (kind === 'paint') return 'what the brush of the page writes';
  if (kind === 'modes') return `auto, all, or numbers from ${min} to ${max} with commas`;
  return kind === 'numbers' ? `numbers from ${min} to ${max} with commas` : range;
}

/** Throws one sentence that names the flag, its range and its default. */
export function checkOption(option: OptionSpec, value: Settings[keyof Settings]): void {
  if (option.kind === 'pins') parsePins(String(value), option.flag);
  if (option.kind === 'paint') parsePaint(String(value));
  if (option.kind === 'colliders') parseColliders(String(value));
  if (isAllowed(option, value)) return;
  const shown = Array.isArray(value) ? value.join(',') || 'an empty list' : String(value);
  throw new Error(
    `--${option.flag} is ${shown}: give ${describeRange(option)} (default: ${describeDefault(option)}).`,
  );
}

function describeDefault(option: OptionSpec): string {
  const value = option.default;
  return Array.isArray(value) || value === '' ? (option.emptyMeans ?? 'none') : String(value);
}

function isAllowed(option: OptionSpec, value: Settings[keyof Settings]): boolean {
  const { kind, choices } = option;
  if (kind === 'choice') return choices!.includes(String(value));
  if (['pins', 'paint', 'colliders', 'name'].includes(kind)) return typeof value === 'string';
  if (kind === 'switch') return typeof value === 'boolean';
  if (kind === 'modes' && (value === 'auto' || value === 'all')) return true;
  const entries: unknown[] = Array.isArray(value) ? value : [value];
  const isList = kind === 'modes' || kind === 'numbers';
  if (isList !== Array.isArray(value) || (kind === 'modes' && !areDistinct(entries))) return false;
  return entries.every((entry) => isInRange(option, entry));
}

function areDistinct(entries: unknown[]): boolean {
  return entries.length > 0 && new Set(entries).size === entries.length;
}

function isInRange({ kind, min, max }: OptionSpec, value: unknown): boolean {
  const isWhole = kind === 'integer' || kind === 'modes';
  return typeof value === 'number' && value >= min && value <= max && (!isWhole || Number.isInteger(value));
}
