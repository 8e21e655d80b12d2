// npm run coverage: the percentage of lines that tests run, for each folder: of web/engine by Vitest, of wasm by the
// native tests.
// Usage: node scripts/coverage.mjs [--engine | --core]      only the first, or only the second; each takes minutes

import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { join, relative } from 'node:path';
import { gunzipSync } from 'node:zlib';
import { root, run } from './setup/environment.mjs';

const results = join(root, 'build', 'coverage');
const only = process.argv.find((word) => word === '--engine' || word === '--core');

/** Prints a line for each folder directly below `base`, and one for all; `files`: [path, { lines, hit }]. */
function printTable(base, files) {
  const sums = new Map();
  const add = (name, { lines, hit }) => {
    const sum = sums.get(name) ?? { lines: 0, hit: 0 };
    sums.set(name, { lines: sum.lines + lines, hit: sum.hit + hit });
  };
  for (const [path, counts] of files) {
    const [folder, ...rest] = relative(join(root, base), path).split('/');
    add(rest.length > 0 ? `${base}/${folder}` : base, counts);
    add(`${base} in all`, counts);
  }
  for (const [name, { lines, hit }] of [...sums].sort())
    console.log(
      `${name.padEnd(26)} ${((100 * hit) / lines).toFixed(1).padStart(5)} % of ${String(lines).padStart(6)} lines`,
    );
}

/** Coverage of the engine by the tests that run in Node; commands that run in processes of their own are not counted. */
function coverEngine() {
  const folder = join(results, 'engine');
  const vitest = join(root, 'node_modules', 'vitest', 'vitest.mjs');
  const options = [
    '--coverage.enabled',
    '--coverage.provider=v8',
    '--coverage.include=web/engine/**/*.ts',
    '--coverage.reporter=json-summary',
    '--coverage.reportOnFailure',
    `--coverage.reportsDirectory=${folder}`,
  ];
  const words = [
    vitest,
    'run',
    '--reporter=dot',
    ...options,
    ...process.argv.slice(2).filter((word) => word !== only),
  ];
  const { status } = spawnSync(process.execPath, words, { cwd: root, stdio: 'inherit' });
  const files = JSON.parse(readFileSync(join(folder, 'coverage-summary.json'), 'utf8'));
  delete files.total;
  const counts = Object.entries(files).map(([path, { lines }]) => [
    path,
    { lines: lines.total, hit: lines.covered },
  ]);
  printTable('web/engine', counts);
  if (status !== 0) process.exitCode = 1;
}

/** Coverage of the core by the native tests, whose programs write their counts when they end. */
function coverCore() {
  const folder = join(root, 'build', 'coverage-core');
  run('cmake', ['--preset', 'coverage']);
  removeCounts(folder);
  run('ninja', ['-C', folder, 'core_tests']);
  run(join(folder, 'tests', 'core', 'core_tests'), ['--gtest_brief=1']);
  const lines = new Map();
  for (const path of countsBelow(folder)) for (const file of reportOf(path)) addLines(lines, file);
  const counts = [...lines].map(([path, hits]) => [
    path,
    { lines: hits.size, hit: [...hits.values()].filter(Boolean).length },
  ]);
  printTable('wasm', counts);
}

const filesBelow = (folder, ending) =>
  readdirSync(folder, { recursive: true })
    .filter((name) => name.endsWith(ending))
    .map((name) => join(folder, name));
const countsBelow = (folder) => filesBelow(folder, '.gcda');

/** Counts of an earlier run would be added to. */
function removeCounts(folder) {
  if (existsSync(folder)) for (const path of countsBelow(folder)) rmSync(path);
}

/** The counts of gcov for one object file: its source and all headers. */
function reportOf(path) {
  const scratch = join(results, 'gcov');
  rmSync(scratch, { recursive: true, force: true });
  mkdirSync(scratch, { recursive: true });
  run('gcov', ['--json-format', path], { cwd: scratch, quiet: true });
  return filesBelow(scratch, '.gcov.json.gz').flatMap(
    (name) => JSON.parse(gunzipSync(readFileSync(name))).files,
  );
}

/** A line counts as run if any program has run it. */
function addLines(all, { file, lines }) {
  const path = join(file.startsWith('/') ? '' : root, file);
  if (!path.startsWith(join(root, 'wasm'))) return;
  const hits = all.get(path) ?? new Map();
  for (const { line_number, count } of lines) hits.set(line_number, hits.get(line_number) || count > 0);
  all.set(path, hits);
}

if (only !== '--core') coverEngine();
if (only !== '--engine') coverCore();
