// docs/motions.md and docs/engines.md have the numbers that were measured: those of tests/bench/engines/record.json.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';

const root = join(import.meta.dirname, '..', '..');
const read = (...path: string[]): string => readFileSync(join(root, ...path), 'utf8');
const record = JSON.parse(read('tests', 'bench', 'engines', 'record.json')) as {
  motions: Record<string, (number | 'diverged' | null)[]>;
};

const cellsOf = (line: string): string[] =>
  line
    .split('|')
    .slice(1, -1)
    .map((cell) => cell.trim());

/** The tables of motions: their title, their columns and their rows, the means left out. */
const tables = read('docs', 'motions.md')
  .split('<!-- end of tables -->')[0]
  .split('### ')
  .slice(1)
  .filter((section) => /^(Blender|Jolt|MuJoCo|Newton),/.test(section))
  .map((section) => {
    const lines = section.split('\n').filter((line) => line.startsWith('|'));
    const [header, , ...rows] = lines.map(cellsOf);
    const [starts] = /Median of [^.]*/.exec(section) ?? [''];
    return {
      engine: section.split(',')[0].toLowerCase(),
      header,
      rows: rows.filter(([name]) => name.includes(',')),
      starts,
    };
  });

function median(key: string): number {
  const values = (record.motions[key] ?? []).filter((value) => value !== null).map(Number);
  values.sort((a, b) => a - b);
  const middle = values.length / 2;
  return values.length % 2 ? values[Math.floor(middle)] : (values[middle - 1] + values[middle]) / 2;
}

test('every motion of the tables is the median of the recorded starts', () => {
  const wrong: string[] = [];
  let compared = 0;
  for (const { engine, header, rows } of tables) {
    for (const [name, ...cells] of rows) {
      const [mesh, scene] = name.split(', ');
      header.slice(1, -1).forEach((method, column) => {
        const shown = cells[column].split(' -> ').map(Number);
        ['untouched', 'tuned'].forEach((state, i) => {
          const exact = median(`${engine}|${mesh}|${scene}|${method}|${state}`);
          compared++;
          // Three digits are shown.
          if (!(Math.abs(shown[i] - exact) <= 0.0051 * exact))
            wrong.push(`${engine}, ${name}, ${method}: ${shown[i]}, ${exact}`);
        });
      });
    }
  }
  expect(wrong).toEqual([]);
  expect(compared).toBe(76 * 4 * 2);
});

test('each table says of how many starts its medians are', () => {
  for (const { engine, header, rows, starts } of tables) {
    const counts = rows.flatMap(([name]) =>
      header.slice(1, -1).map((method) => {
        const key = `${engine}|${name.split(', ').join('|')}|${method}|tuned`;
        return record.motions[key].filter((value) => value !== null).length;
      }),
    );
    const [fewest, most] = [Math.min(...counts), Math.max(...counts)];
    const number = fewest === most ? `${fewest}` : `${fewest} to ${most}`;
    expect(starts).toBe(`Median of ${number} start${most > 1 ? 's' : ''}`);
  }
});

test('the summary has a row for every table and counts its motions', () => {
  const summary = read('docs', 'engines.md').split('<!-- summary -->')[1].split('<!-- end of summary -->')[0];
  const rows = summary
    .split('\n')
    .filter((line) => line.startsWith('|'))
    .map(cellsOf)
    .slice(2);
  expect(rows.slice(0, tables.length).map(([, count]) => Number(count))).toEqual(
    tables.map(({ rows: of }) => of.length),
  );
  expect(rows.at(-1)!.slice(0, 2)).toEqual(['everything', '76']);
});
