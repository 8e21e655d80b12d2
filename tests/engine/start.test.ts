/** What `npm start` says in place of building and serving. */

import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { expect, test } from 'vitest';

const program = join(import.meta.dirname, '..', '..', 'scripts', 'start.mjs');
/** It answers at once: a build would outlast the limit. */
const start = (...words: string[]) =>
  spawnSync(process.execPath, [program, ...words], { encoding: 'utf8', timeout: 5000 });

test.each(['--help', '-h'])('%s prints the usage, and nothing is built or served', (flag) => {
  const { status, stdout, stderr } = start(flag);
  expect([status, stderr]).toEqual([0, '']);
  expect(stdout).toMatch(/^Usage: npm start\n[^]*PORT[^]*HOST/);
});

test('an unknown flag is refused in one sentence', () => {
  const { status, stdout, stderr } = start('--port', '80');
  expect([status, stdout]).toEqual([2, '']);
  expect(stderr).toBe(
    '"--port" is not known: npm start takes no flag but --help, and PORT and HOST from the environment.\n',
  );
});
