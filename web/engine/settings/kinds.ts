/** The rules of each kind of setting: how a value is read from text, which values are allowed, and how they are described. */

import { parseColliders } from './collider_text';
import { parseEngine } from './engine_text';
import { SettingError } from './errors';
import { parsePaint } from './paint_text';
import { parsePins } from './pin_text';
import type { SettingName } from './table';
import type { OptionKind, OptionOf, OptionSpec } from './types';

/** How values are written in errors: as in command lines and links, as in JSON, or as in a program. */
export type Notation = 'text' | 'json' | 'script';

interface KindRules<Kind extends OptionKind> {
  /** Parses a value. Text that should be a number and is not is returned unchanged, and `isAllowed` refuses it. */
  read(text: string): unknown;
  isAllowed(value: unknown, option: OptionOf<Kind>): boolean;
  /** Throws SettingError where an allowed text has not the form of its kind. */
  parse?(text: string, setting: SettingName): unknown;
  /** describes the allowed values: "a number from 0 to 1" */
  describe(option: OptionOf<Kind>, notation: Notation): string;
  /** what stands for a value in the help */
  placeholder(option: OptionOf<Kind>): string;
}

const DECIMAL = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

/** The number that `text` stands for; `text` itself if it is not a number. */
export function readNumber(text: string): number | string {
  if (/^\+?inf(inity)?$/i.test(text)) return Infinity;
  return DECIMAL.test(text) ? Number(text) : text;
}

const readList = (text: string) => text.split(',').map(readNumber);
const verbatim = (text: string) => text;
const isText = (value: unknown) => typeof value === 'string';

const isWithin = (value: unknown, { min, max }: { min: number; max: number }): boolean =>
  typeof value === 'number' && value >= min && value <= max;
const isWholeWithin = (value: unknown, range: { min: number; max: number }): boolean =>
  isWithin(value, range) && Number.isInteger(value);

/** Throws SettingError where a list of modes, as text, names one twice. */
function checkDistinct(text: string, setting: SettingName): void {
  const modes = text.split(',');
  const twice = modes.find((mode, i) => modes.indexOf(mode) < i);
  if (twice !== undefined) throw new SettingError(setting, `names mode ${twice} twice: give it once.`);
}

const INFINITY: Record<Notation, string> = { text: 'inf', json: '"inf"', script: 'Infinity' };

const describeRange = (
  noun: string,
  { min, max }: { min: number; max: number },
  notation: Notation,
): string =>
  max === Infinity ? `${noun} of at least ${min}, or ${INFINITY[notation]}` : `${noun} from ${min} to ${max}`;

/** Describes an allowed text; notations with values of other types add that it is a text. */
const describeText =
  (words: string) =>
  (_: unknown, notation: Notation): string =>
    notation === 'text' ? words : `${words}, as a string`;

const KINDS: { [Kind in OptionKind]: KindRules<Kind> } = {
  choice: {
    read: verbatim,
    isAllowed: (value, { choices }) => typeof value === 'string' && choices.includes(value),
    describe: ({ choices }) => `one of ${choices.join(', ')}`,
    placeholder: ({ choices }) => choices.join('|'),
  },
  integer: {
    read: readNumber,
    isAllowed: isWholeWithin,
    describe: (option, notation) => describeRange('a whole number', option, notation),
    placeholder: () => 'N',
  },
  number: {
    read: readNumber,
    isAllowed: isWithin,
    describe: (option, notation) => describeRange('a number', option, notation),
    placeholder: () => 'N',
  },
  modes: {
    read: (text) => (['auto', 'all'].includes(text) ? text : readList(text)),
    isAllowed: (value, option) =>
      Array.isArray(value)
        ? value.length > 0 && value.every((entry) => isWholeWithin(entry, option))
        : value === 'auto' || value === 'all',
    parse: checkDistinct,
    describe: ({ min, max }, notation) =>
      notation === 'text'
        ? `auto, all, or numbers from ${min} to ${max} separated by commas`
        : `"auto", "all", or a list of different whole numbers from ${min} to ${max}`,
    placeholder: () => 'auto|all|K[,K...]',
  },
  numbers: {
    read: readList,
    isAllowed: (value, option) => Array.isArray(value) && value.every((entry) => isWithin(entry, option)),
    describe: ({ min, max }, notation) =>
      notation === 'text'
        ? `numbers from ${min} to ${max} separated by commas`
        : `a list of numbers from ${min} to ${max}`,
    placeholder: () => 'N[,N...]',
  },
  pins: {
    read: verbatim,
    isAllowed: isText,
    parse: (text, setting) => parsePins(text, setting),
    describe: describeText('terms joined by +'),
    placeholder: () => 'SPEC',
  },
  paint: {
    read: verbatim,
    isAllowed: isText,
    parse: (text) => parsePaint(text),
    describe: describeText('text from the brush of the page'),
    placeholder: () => 'TEXT',
  },
  colliders: {
    read: verbatim,
    isAllowed: isText,
    parse: (text) => parseColliders(text),
    describe: describeText('terms joined by +'),
    placeholder: () => 'SPEC',
  },
  engine: {
    read: verbatim,
    isAllowed: isText,
    parse: (text) => parseEngine(text),
    describe: describeText('name=value pairs separated by commas'),
    placeholder: () => 'FILE|NAME=VALUE,...',
  },
  name: {
    read: verbatim,
    isAllowed: isText,
    describe: describeText('the name of an attribute'),
    placeholder: () => 'NAME',
  },
  pattern: {
    read: verbatim,
    isAllowed: isText,
    describe: describeText('names, in which * stands for any letters and ? for one'),
    placeholder: () => 'GLOB',
  },
  switch: {
    read: () => true,
    isAllowed: (value) => typeof value === 'boolean',
    describe: () => 'true or false',
    placeholder: () => '',
  },
};

/** The rules of an option's kind, to be called with that option. */
export const rulesOf = (option: OptionSpec): KindRules<OptionKind> =>
  KINDS[option.kind] as KindRules<OptionKind>;
