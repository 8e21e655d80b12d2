/**
 * A whole number with thousands separators: "12,345". The locale data that `toLocaleString` loads on its first call takes as long
 * as the work on a small mesh.
 */
export const grouped = (value: number): string => String(value).replace(/\B(?=(\d{3})+$)/g, ',');

/** A count with its noun: "1 texture", "2 textures". */
export function counted(count: number, one: string, many = `${one}s`): string {
  return `${grouped(count)} ${count === 1 ? one : many}`;
}

/** A number to be shown beside its limit: with two decimals, or one more than the limit has, so that the two can be told apart. */
export function besideLimit(value: number, limit: number): string {
  let digits = 1;
  while (digits < MAX_DIGITS && Number(limit.toFixed(digits)) !== limit) ++digits;
  return value.toFixed(digits + 1);
}

const MAX_DIGITS = 20;

/** The most characters of a text from a file that a sentence quotes. */
const QUOTED = 100;

/** A text from a file as a sentence quotes it, cut if it is long. */
export function excerpt(text: string): string {
  if (text.length <= QUOTED) return text;
  // The cut may split a surrogate pair.
  return `${text.slice(0, QUOTED).replace(/[\ud800-\udbff]$/, '')}...`;
}

/** A value from a program as a sentence quotes it. */
export function quotedValue(value: unknown): string {
  if (Array.isArray(value)) return excerpt(`[${value.map(quotedEntry).join(', ')}]`);
  return quotedEntry(value);
}

function quotedEntry(value: unknown): string {
  if (typeof value === 'string') return JSON.stringify(excerpt(value));
  if (typeof value === 'function') return 'a function';
  if (typeof value === 'object' && value !== null) return Array.isArray(value) ? 'a list' : 'an object';
  return String(value);
}

/** A value from a JSON file as a sentence quotes it. */
export const quotedJson = (value: unknown): string =>
  typeof value === 'string' ? JSON.stringify(excerpt(value)) : excerpt(JSON.stringify(value));
