// The tests that Vitest runs (engine, command line, package, pure logic of the page) and those of the page in Chromium.

import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { findChromium, root } from '../setup/environment.mjs';
import { add, results } from './totals.mjs';

const readReport = (file) => (existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')) : {});

export function runVitest() {
  const file = join(results, 'vitest.json');
  const vitest = join(root, 'node_modules', 'vitest', 'vitest.mjs');
  const args = [vitest, 'run', '--reporter=default', '--reporter=json', `--outputFile.json=${file}`];
  const { status } = spawnSync(process.execPath, args, { cwd: root, stdio: 'inherit' });
  const report = readReport(file);
  const failed = report.numFailedTests ?? 0;
  add('engine and command line', {
    passed: report.numPassedTests ?? 0,
    failed: failed === 0 && status !== 0 ? 1 : failed,
    skipped: (report.numPendingTests ?? 0) + (report.numTodoTests ?? 0),
  });
}

/** Runs the tests of the page; with `full` also those tagged `@full`, which take longer. */
export function runPlaywright({ full }) {
  const file = join(results, 'playwright.json');
  const playwright = join(root, 'node_modules', '@playwright', 'test', 'cli.js');
  const env = { ...process.env, CHROMIUM: findChromium(), PLAYWRIGHT_JSON_OUTPUT_NAME: file };
  const args = [playwright, 'test', '--reporter=list,json', ...(full ? [] : ['--grep-invert', '@full'])];
  const { status } = spawnSync(process.execPath, args, { cwd: root, stdio: 'inherit', env });
  const stats = readReport(file).stats ?? {};
  const failed = (stats.unexpected ?? 0) + (stats.flaky ?? 0);
  add('page in Chromium', {
    passed: stats.expected ?? 0,
    failed: failed === 0 && status !== 0 ? 1 : failed,
    skipped: stats.skipped ?? 0,
  });
  if (!full) console.log('       (tests of the page that are tagged @full run with npm run test:full)');
}
