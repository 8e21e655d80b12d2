/** What commands that read two models say of them. */

import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { together } from './support/bodies';
import { grid, toObj } from './support/shapes';

const program = new URL('../../dist/cli/limber.mjs', import.meta.url).pathname;
let folder: string;

/** The lines that limber writes to stderr in the folder of the test files. */
const told = (...args: string[]): string[] =>
  spawnSync(process.execPath, [program, ...args], { cwd: folder, encoding: 'utf8' })
    .stderr.split('\n')
    .filter((line) => line !== '');

/** Two sheets side by side, whose common border is a seam. */
const seamed = (cells: number): string => {
  const sheet = grid(cells, cells);
  // `together` moves the second one by 10.
  const positions = sheet.positions.map((value, i) => (i % 3 === 0 ? value - 9 : value));
  return toObj(together(sheet, { ...sheet, positions }));
};

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'limber-two-'));
  mkdirSync(join(folder, 'old'));
  writeFileSync(join(folder, 'fine.obj'), seamed(8));
  writeFileSync(join(folder, 'coarse.obj'), seamed(4));
  writeFileSync(join(folder, 'old', 'coarse.obj'), seamed(8));
});

afterAll(() => rmSync(folder, { recursive: true, force: true }));

it('warnings of welded seams name the model that has them', () => {
  const words = ['compare', 'simulate', 'tune'].map((command) => {
    const tuning = command === 'tune' ? ['--solver', 'springs', '--settings', 'out.json', '--force'] : [];
    const moving = command === 'simulate' ? ['--seconds', '0.05'] : [];
    return told(command, 'fine.obj', 'coarse.obj', ...tuning, ...moving);
  });
  const seams = ['limber: fine.obj: 9 seam vertices welded.', 'limber: coarse.obj: 5 seam vertices welded.'];
  expect(words).toEqual([seams, seams, seams]);
});

it('models whose file names are equal are told by their paths', () => {
  expect(told('compare', 'old/coarse.obj', 'coarse.obj')).toEqual([
    'limber: old/coarse.obj: 9 seam vertices welded.',
    'limber: coarse.obj: 5 seam vertices welded.',
  ]);
});

it('a model beside itself has its warnings once', () => {
  expect(told('compare', 'fine.obj', 'fine.obj')).toEqual(['limber: 9 seam vertices welded.']);
});
