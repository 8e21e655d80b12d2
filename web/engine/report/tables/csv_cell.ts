/** One cell of a CSV file, RFC 4180. */

/** Spreadsheets take texts that start like formulas for formulas, and run them: an apostrophe in front keeps them texts. */
export function cell(value: string | number | null): string {
  if (value === null) return '';
  if (typeof value === 'number') return String(value);
  const harmless = /^[=+\-@\t\r]/.test(value) ? `'${value}` : value;
  return /[",\r\n]/.test(harmless) ? `"${harmless.replaceAll('"', '""')}"` : harmless;
}
