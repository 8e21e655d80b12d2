/**
 * Translates the texts of the page. The English sentence is the key of the message table, so that the source of panels
 * is readable, and a sentence without an entry is shown in English. Placeholders are names in braces.
 */

import { shown } from './language';
import type { MessageTable } from './message_table';

/** The value that replaces `{name}`. */
export type Values = Readonly<Record<string, string | number>>;

const PLACEHOLDER = /\{(\w+)\}/g;

const fill = (template: string, values: Values): string =>
  template.replaceAll(PLACEHOLDER, (whole, name: string) => String(values[name] ?? whole));

/** The sentence in the language of the page. `english` is a literal, which a test looks up in every table. */
export const say = (english: string, values: Values = {}): string =>
  fill(shown.value.table[english] ?? english, values);

/** A number in the format of the page's language. */
export const count = (value: number): string => value.toLocaleString(shown.value.language);

/** A number of things: `one` for exactly one, otherwise `other`, the key of the table; `{count}` is the number in both. */
export function sayCounted(number: number, one: string, other: string, values: Values = {}): string {
  const { language, table } = shown.value;
  const isOne = language === 'en' && new Intl.PluralRules(language).select(number) === 'one';
  const template = isOne ? one : (table[other] ?? other);
  return fill(template, { count: count(number), ...values });
}

/** Several things as one phrase: "a, b and c". */
export const listed = (words: readonly string[]): string => {
  if (shown.value.language !== 'en') return words.join('、');
  return words.length < 2 ? words.join('') : `${words.slice(0, -1).join(', ')} and ${words.at(-1)}`;
};

/** Several things as a sentence: "a, b." */
export const enumerated = (words: readonly string[]): string =>
  shown.value.language === 'en' ? `${words.join(', ')}.` : `${words.join('、')}。`;

interface Pattern {
  form: RegExp;
  names: string[];
  translated: string;
}

/** The entries with placeholders of each table, as patterns of finished sentences; longer ones first. */
const patternsOf = new WeakMap<MessageTable, Pattern[]>();

function patterns(table: MessageTable): Pattern[] {
  const known = patternsOf.get(table);
  if (known) return known;
  const found = Object.entries(table)
    .filter(([english]) => english.includes('{'))
    .sort(([a], [b]) => b.length - a.length)
    .map(([english, translated]) => ({
      form: new RegExp(`^${english.split(PLACEHOLDER).map(partOfForm).join('')}$`),
      names: [...english.matchAll(PLACEHOLDER)].map(([, name]) => name),
      translated,
    }));
  patternsOf.set(table, found);
  return found;
}

/** Placeholders that only match numbers, so that "{first} to {last}" does not match other sentences. */
const NUMBERS = new Set(['all', 'count', 'first', 'last', 'line', 'number']);

/** `split` gives texts and names of placeholders in turn. */
function partOfForm(part: string, i: number): string {
  if (i % 2 === 1) return NUMBERS.has(part) ? '([\\d.,]+)' : '(.+?)';
  return part.replaceAll(/[.*+?^${}()|[\]\\]/g, '\\$&');
}

/**
 * A finished English sentence of the engine in the language of the page: by its entry, or by an entry with placeholders of the
 * same form, whose values are looked up in the table, too. A sentence of an unknown form is returned unchanged.
 */
export function sentence(english: string): string {
  const { table } = shown.value;
  const exact = table[english];
  if (exact !== undefined) return exact;
  for (const { form, names, translated } of patterns(table)) {
    const values = form.exec(english)?.slice(1);
    if (values)
      return fill(translated, Object.fromEntries(names.map((name, i) => [name, sentence(values[i])])));
  }
  return english;
}
