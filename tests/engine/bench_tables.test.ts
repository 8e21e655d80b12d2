// npm run bench: its list is complete, and it reads and compares what benchmarks print.

import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { BENCHES } from '../../scripts/bench/registry.mjs';
import { compareRows, numberOf, rowsOf } from '../../scripts/bench/tables.mjs';

const root = join(import.meta.dirname, '..', '..');

test('every benchmark that writes into a document is registered, and every entry exists', () => {
  for (const { script, document } of BENCHES) {
    expect(existsSync(join(root, script))).toBe(true);
    if (document) expect(existsSync(join(root, document))).toBe(true);
  }
  const folder = join(root, 'tests', 'bench');
  const says = (name: string, form: RegExp): boolean => form.test(readFileSync(join(folder, name), 'utf8'));
  const writing = readdirSync(folder)
    .filter((name) => name.endsWith('.mjs'))
    .filter((name) => says(name, /^\/\/ .*node tests\/bench/m) && says(name, /--write/));
  const listed = BENCHES.map(({ script }) => script);
  expect(writing.filter((name) => !listed.includes(`tests/bench/${name}`))).toEqual([]);
});

test('tables are read with bars and with tabs', () => {
  const text = 'words\n| mesh | ms |\n| --- | ---: |\n| a | 1,234 ms |\n\nb\t2.5\t<3\n';
  expect(rowsOf(text)).toEqual([
    ['mesh', 'ms'],
    ['a', '1,234 ms'],
    ['b', '2.5', '<3'],
  ]);
  expect(['1,234 ms', 'x0.5', '-2e-3', '~7', 'none'].map(numberOf)).toEqual([1234, 0.5, -0.002, 7, NaN]);
});

test('numbers are compared row by row, also if rows have equal names', () => {
  const before = [
    ['a', '10', '5'],
    ['a', '1'],
    ['gone', '1'],
  ];
  const now = [
    ['a', '20', '5'],
    ['a', '3'],
    ['new', '1'],
  ];
  expect(compareRows(before, now)).toEqual([
    { row: 'a', column: 1, before: 10, now: 20, ratio: 2 },
    { row: 'a', column: 1, before: 1, now: 3, ratio: 3 },
  ]);
});
