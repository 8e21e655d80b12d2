// npm test: sets up, builds, runs every suite and ends with one line of totals, "N passed, N failed".

import { spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { build } from './build.mjs';
import { buildPreset } from './setup/core.mjs';
import { findChromium, folders, root } from './setup/environment.mjs';

const results = join(folders.build, 'results');
const total = { passed: 0, failed: 0, skipped: 0 };

function add(suite, { passed, failed, skipped }) {
  total.passed += passed;
  total.failed += failed;
  total.skipped += skipped;
  const skips = skipped ? `, ${skipped} skipped` : '';
  console.log(`${failed ? 'FAILED' : 'ok    '} ${suite}: ${passed} passed, ${failed} failed${skips}`);
}

async function runChecks() {
  const { check } = await import('./check.mjs'); // needs the packages that `build` installs
  for (const { name, problems } of check()) {
    if (problems) console.log(problems);
    add(name, { passed: problems ? 0 : 1, failed: problems ? 1 : 0, skipped: 0 });
  }
}

/** Counts of a GoogleTest report, and messages of failed or skipped tests; a crash leaves no report. */
function readGoogleTest(file) {
  if (!existsSync(file)) return { passed: 0, failed: 1, skipped: 0 };
  const suites = JSON.parse(readFileSync(file, 'utf8')).testsuites;
  const tests = suites.flatMap((suite) => suite.testsuite);
  const failed = tests.filter((test) => test.failures?.length).length;
  const skipped = tests.filter((test) => test.result === 'SKIPPED').length;
  return { passed: tests.length - failed - skipped, failed, skipped };
}

/** Runs one test program to its end; its output is shown only if tests fail or are skipped. */
function runProgram(command, args, env) {
  return new Promise((done) => {
    const child = spawn(command, args, { cwd: root, env: { ...process.env, ...env } });
    let words = '';
    child.stdout.on('data', (text) => (words += text));
    child.stderr.on('data', (text) => (words += text));
    child.on('close', (code) => done({ code, words }));
    child.on('error', (error) => done({ code: -1, words: error.message }));
  });
}

async function runCoreTests(preset, setup) {
  const names = readdirSync(join(root, 'tests', 'core'))
    .filter((name) => name.endsWith('_test.cpp'))
    .map((name) => name.slice(0, -4));
  buildPreset(preset, names, setup);
  const isWasm = preset !== 'native';
  const sanitizers = { ASAN_OPTIONS: 'detect_leaks=1', UBSAN_OPTIONS: 'print_stacktrace=1' };
  const runOne = async (name) => {
    const report = join(results, `${preset}-${name}.json`);
    const program = join(folders.build, preset, 'tests', 'core', isWasm ? `${name}.cjs` : name);
    const args = [...(isWasm ? [program] : []), `--gtest_output=json:${report}`];
    const { code, words } = await runProgram(isWasm ? process.execPath : program, args, sanitizers);
    const counts = readGoogleTest(report);
    if (code !== 0 && counts.failed === 0) counts.failed = 1;
    if (counts.failed || counts.skipped) console.log(words);
    add(`core, ${isWasm ? 'wasm' : 'native with sanitizers'}, ${name}`, counts);
  };
  // Two at a time, one per core of a small machine.
  const queue = [...names];
  const worker = async () => {
    while (queue.length) await runOne(queue.shift());
  };
  await Promise.all([worker(), worker()]);
}

function runVitest() {
  const file = join(results, 'vitest.json');
  const vitest = join(root, 'node_modules', 'vitest', 'vitest.mjs');
  const args = [vitest, 'run', '--reporter=default', '--reporter=json', `--outputFile.json=${file}`];
  const { status } = spawnSync(process.execPath, args, { cwd: root, stdio: 'inherit' });
  const report = existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')) : {};
  const failed = report.numFailedTests ?? 0;
  add('engine and command line', {
    passed: report.numPassedTests ?? 0,
    failed: failed === 0 && status !== 0 ? 1 : failed,
    skipped: (report.numPendingTests ?? 0) + (report.numTodoTests ?? 0),
  });
}

function runPlaywright() {
  const file = join(results, 'playwright.json');
  const playwright = join(root, 'node_modules', '@playwright', 'test', 'cli.js');
  const env = { ...process.env, CHROMIUM: findChromium(), PLAYWRIGHT_JSON_OUTPUT_NAME: file };
  const args = [playwright, 'test', '--reporter=list,json'];
  const { status } = spawnSync(process.execPath, args, { cwd: root, stdio: 'inherit', env });
  const stats = existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')).stats : {};
  const failed = (stats.unexpected ?? 0) + (stats.flaky ?? 0);
  add('page in Chromium', {
    passed: stats.expected ?? 0,
    failed: failed === 0 && status !== 0 ? 1 : failed,
    skipped: stats.skipped ?? 0,
  });
}

const setup = build({ tests: true });
rmSync(results, { recursive: true, force: true });
mkdirSync(results, { recursive: true });
await runChecks();
await runCoreTests('native', { headers: setup.headers });
await runCoreTests('single', setup);
runVitest();
runPlaywright();
const skips = total.skipped ? `, ${total.skipped} skipped` : '';
console.log(`${total.passed} passed, ${total.failed} failed${skips}`);
process.exit(total.failed ? 1 : 0);
