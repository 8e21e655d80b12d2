/** A report as CSV and as Markdown; the keys are those of the JSON, see docs/report.md. */

import type { Report } from './report';
import { cell } from './tables/csv_cell';

type Value = string | number | boolean | null;

/** Every value under its path: `output.faces`, `modes.0.frequency`. */
function flatten(value: unknown, path: string): [string, Value][] {
  if (value === undefined) return [];
  if (value === null || typeof value !== 'object') return [[path, value as Value]];
  return Object.entries(value).flatMap(([key, inner]) =>
    flatten(inner, path === '' ? key : `${path}.${key}`),
  );
}

/** Two columns, key and value, with a header line; RFC 4180. */
export function reportAsCsv(report: Report): string {
  const rows = flatten(report, '').map(([key, value]) => `${cell(key)},${cell(plain(value))}`);
  return `${['key,value', ...rows].join('\r\n')}\r\n`;
}

/** Words of the table. */
const plain = (value: Value): string | number | null => (typeof value === 'boolean' ? String(value) : value);

/** A heading, and a table for each part of the report. */
export function reportAsMarkdown(report: Report): string {
  const parts = Object.entries(report).filter(([, value]) => value !== null && typeof value === 'object');
  const plain = Object.entries(report).filter(([, value]) => value === null || typeof value !== 'object');
  const tables = [['', Object.fromEntries(plain)] as [string, unknown], ...parts].map(([name, value]) =>
    [...(name === '' ? [] : [`## ${name}`, '']), ...tableOf(value)].join('\n'),
  );
  return `${['# Limber report', ...tables].join('\n\n')}\n`;
}

function tableOf(value: unknown): string[] {
  const isList = Array.isArray(value) && value.every((entry) => entry !== null && typeof entry === 'object');
  return isList && value.length > 0 ? listTable(value as object[]) : pairTable(value);
}

function pairTable(value: unknown): string[] {
  const rows = flatten(value, '').map(([key, inner]) => row([key, shown(inner)]));
  return [row(['key', 'value']), row(['---', '---']), ...rows];
}

/** A row for each entry; a column for each key that any of them has. */
function listTable(entries: object[]): string[] {
  const flat = entries.map((entry) => new Map(flatten(entry, '')));
  const keys = [...new Set(flat.flatMap((entry) => [...entry.keys()]))];
  const rows = flat.map((entry) => row(keys.map((key) => shown(entry.get(key) ?? ''))));
  return [row(keys), row(keys.map(() => '---')), ...rows];
}

const row = (cells: string[]): string =>
  `| ${cells.map((text) => text.replaceAll('|', '\\|')).join(' | ')} |`;

const shown = (value: Value): string =>
  typeof value === 'number' && !Number.isInteger(value)
    ? String(Number(value.toPrecision(6)))
    : String(value ?? '');
