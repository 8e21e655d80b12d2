// npm run bench: runs the benchmarks one after the other and stores their output, with the machine and the versions.
// Usage: npm run bench -- [--only a,b] [--quick] [--write] [--list] [--compare REV]        after npm run build
//   --quick        shorter runs, within ten minutes for all of them
//   --write        also puts the tables into the documents
//   --compare REV  ratios of the numbers now to those that were kept at a commit
//
// Results are kept in tests/bench/kept/NAME.json, of quick runs in build/bench/kept.

import { spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { cpus, totalmem } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { BENCHES } from './bench/registry.mjs';
import { compareRows, rowsOf } from './bench/tables.mjs';
import { fail, root } from './setup/environment.mjs';

const { values } = parseArgs({
  options: {
    only: { type: 'string' },
    quick: { type: 'boolean', default: false },
    write: { type: 'boolean', default: false },
    list: { type: 'boolean', default: false },
    compare: { type: 'string' },
  },
});

function chosen() {
  if (values.only === undefined) return BENCHES.filter(({ quick }) => !values.quick || quick !== null);
  return values.only.split(',').map((name) => {
    const bench = BENCHES.find((one) => one.name === name);
    if (!bench) fail(`There is no benchmark "${name}": use ${BENCHES.map((one) => one.name).join(', ')}.`);
    return bench;
  });
}

const kept = values.quick ? join(root, 'build', 'bench', 'kept') : join(root, 'tests', 'bench', 'kept');

function machine() {
  const { version } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
  const { stdout } = spawnSync('git', ['rev-parse', 'HEAD'], { cwd: root, encoding: 'utf8' });
  return {
    limber: version,
    commit: stdout.trim(),
    node: process.version,
    processor: `${cpus().length} x ${cpus()[0].model}`,
    memory: `${Math.round(totalmem() / 2 ** 30)} GB`,
    system: `${process.platform} ${process.arch}`,
  };
}

/** Runs a script to its end and shows what it prints as it comes. */
function run(script, words) {
  return new Promise((done) => {
    const child = spawn(process.execPath, [join(root, script), ...words], { cwd: root });
    let output = '';
    child.stdout.on('data', (text) => {
      output += text;
      process.stdout.write(text);
    });
    child.stderr.pipe(process.stderr);
    child.on('close', (code) => done({ code, output }));
  });
}

async function runBench({ name, script, peers, ...bench }) {
  const words = [
    ...(values.quick ? (bench.quick ?? bench.words) : bench.words),
    ...(values.write ? bench.write : []),
  ];
  console.log(`\n== ${name}: ${bench.measures}; beside ${peers}`);
  const start = performance.now();
  const { code, output } = await run(script, words);
  const seconds = Math.round((performance.now() - start) / 1000);
  if (code !== 0) return { name, seconds, state: `failed with exit code ${code}` };
  const rows = rowsOf(output);
  const result = { name, command: ['node', script, ...words].join(' '), peers, machine: machine(), rows };
  mkdirSync(kept, { recursive: true });
  writeFileSync(join(kept, `${name}.json`), `${JSON.stringify(result, null, 1)}\n`);
  return { name, seconds, state: `${rows.length} rows` };
}

function keptAt(revision, name) {
  const path = `tests/bench/kept/${name}.json`;
  const { status, stdout } = spawnSync('git', ['show', `${revision}:${path}`], {
    cwd: root,
    encoding: 'utf8',
  });
  return status === 0 ? JSON.parse(stdout) : null;
}

function compare(revision) {
  for (const { name } of chosen()) {
    const path = join(kept, `${name}.json`);
    const before = keptAt(revision, name);
    if (!before || !existsSync(path)) {
      console.log(`${name}: nothing is kept ${before ? 'here: run it first' : `at ${revision}`}`);
      continue;
    }
    const changes = compareRows(before.rows, JSON.parse(readFileSync(path, 'utf8')).rows);
    console.log(`${name}: ${changes.length} numbers differ`);
    for (const { row, column, before: a, now, ratio } of changes)
      console.log(`  ${row}, column ${column + 1}: ${a} -> ${now} (x${ratio.toFixed(2)})`);
  }
}

if (values.list)
  for (const { name, measures, peers, document } of BENCHES)
    console.log(`${name.padEnd(10)} ${measures}; beside ${peers}${document ? ` (${document})` : ''}`);
else if (values.compare) compare(values.compare);
else {
  if (!existsSync(join(root, 'dist', 'cli', 'limber.mjs')))
    fail('Benchmarks need a build: run npm run build.');
  const done = [];
  for (const bench of chosen()) done.push(await runBench(bench));
  console.log('');
  for (const { name, seconds, state } of done) console.log(`${name.padEnd(10)} ${seconds} s, ${state}`);
  if (done.some(({ state }) => state.startsWith('failed'))) process.exit(1);
}
