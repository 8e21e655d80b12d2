/** Numbers and tables for people to read. */

import { counted, grouped } from '../engine/core/words';

/** A share as percent with its sign: "-50.0 %". */
export function percent(share: number): string {
  const value = 100 * share;
  return `${value > 0 ? '+' : ''}${(Math.abs(value) < 0.05 ? 0 : value).toFixed(1)} %`;
}

/** What became of a number of faces: "800 -> 1 face (-99.9 %)". */
export const facesChange = (before: number, after: number): string =>
  `${grouped(before)} -> ${counted(after, 'face')} (${percent(after / before - 1)})`;

/** Columns padded to their widest cell, the first to the left and the others to the right. */
export function table(rows: string[][]): string {
  const widths = rows[0].map((_, column) => Math.max(...rows.map((row) => row[column].length)));
  const line = (row: string[]) =>
    row
      .map((cell, column) => (column === 0 ? cell.padEnd(widths[column]) : cell.padStart(widths[column])))
      .join('  ')
      .trimEnd();
  return rows.map(line).join('\n');
}

/** Two columns: what, and its value. */
export function list(entries: [string, string][]): string {
  const width = Math.max(...entries.map(([name]) => name.length));
  return entries.map(([name, value]) => `${name.padEnd(width)}  ${value}`).join('\n');
}

/** As `plain`, in one line. */
export const inOneLine = (text: string): string => plain(text.replace(/\s*\n\s*/g, ' '));

/** Text that may come from a file, without control characters. */
export const plain = (text: string): string => text.replace(/[^\n\x20-\x7e\u00a0-\uffff]/g, '?');
