/** Settings whose text is a list of terms, `KIND:VALUE` joined by `+`. */

import { SettingError } from './errors';
import type { SettingName } from './table';

export interface TermRules<Term extends object> {
  setting: SettingName;
  /** the forms of all kinds, for errors */
  forms: string;
  /** null if the value does not have the form of its kind; text: what to give in place of numbers out of their range */
  termOf: (kind: string, value: string) => Term | string | null;
}

/** The terms of a text; none for an empty one. Throws SettingError with the forms. */
export const parseTerms = <Term extends object>(text: string, rules: TermRules<Term>): Term[] =>
  text === '' ? [] : text.split('+').map((term) => parseTerm(term.trim(), rules));

function parseTerm<Term extends object>(text: string, { setting, forms, termOf }: TermRules<Term>): Term {
  if (text === '')
    throw new SettingError(setting, `has a + that does not join two terms: remove it, or give ${forms}.`);
  const colon = text.indexOf(':');
  const term = termOf(text.slice(0, Math.max(0, colon)), text.slice(colon + 1));
  if (term !== null && typeof term !== 'string') return term;
  throw new SettingError(setting, `has "${text}": give ${term ?? forms}.`);
}

/** Numbers separated by commas; null if one is missing or is none. */
export function numbersIn(value: string): number[] | null {
  const numbers = value.split(',').map((word) => (word.trim() === '' ? NaN : Number(word)));
  return numbers.every(Number.isFinite) ? numbers : null;
}
