/**
 * A whole number as English writes it: "12,345". The tables of languages that `toLocaleString` loads for the first one take as long
 * as the work on a small mesh.
 */
export const grouped = (value: number): string => String(value).replace(/\B(?=(\d{3})+$)/g, ',');

/** A count with its noun: "1 texture", "2 textures". */
export function counted(count: number, one: string, many = `${one}s`): string {
  return `${grouped(count)} ${count === 1 ? one : many}`;
}

/** A number beside a limit of it: two digits after the point, or one more than the limit has, which tells the two apart. */
export function besideLimit(value: number, limit: number): string {
  let digits = 1;
  while (digits < MOST_DIGITS && Number(limit.toFixed(digits)) !== limit) ++digits;
  return value.toFixed(digits + 1);
}

const MOST_DIGITS = 20;

/** Letters of a text from a file that a sentence quotes at most. */
const QUOTED = 100;

/** A text from a file, as a sentence quotes it: the beginning of one that is long. */
export function excerpt(text: string): string {
  if (text.length <= QUOTED) return text;
  // The cut may go through a letter of two code units.
  return `${text.slice(0, QUOTED).replace(/[\ud800-\udbff]$/, '')}...`;
}

/** A value of a program, as a sentence quotes it. */
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

/** A value from a file of JSON, as a sentence quotes it. */
export const quotedJson = (value: unknown): string =>
  typeof value === 'string' ? JSON.stringify(excerpt(value)) : excerpt(JSON.stringify(value));
