// The tests of the core: as WebAssembly in Node, natively with sanitizers, and through the fuzzers.

import { spawn } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { buildPreset } from '../setup/core.mjs';
import { folders, root } from '../setup/environment.mjs';
import { add, results } from './totals.mjs';

// One shard per core of a small machine.
const SHARDS = 2;

const SANITIZERS = {
  ASAN_OPTIONS: 'detect_leaks=1',
  UBSAN_OPTIONS: 'print_stacktrace=1',
  TSAN_OPTIONS: 'halt_on_error=1',
};

/** Counts of a GoogleTest report. A program that crashes writes none, which counts as a failure. */
function readGoogleTest(file) {
  if (!existsSync(file)) return { passed: 0, failed: 1, skipped: 0 };
  const suites = JSON.parse(readFileSync(file, 'utf8')).testsuites;
  const tests = suites
    .flatMap((suite) => suite.testsuite)
    .filter(({ status, result }) => status === 'RUN' || result === 'SKIPPED');
  const failed = tests.filter((test) => test.failures?.length).length;
  const skipped = tests.filter((test) => test.result === 'SKIPPED').length;
  return { passed: tests.length - failed - skipped, failed, skipped };
}

/** Runs one test program to its end. Resolves to its exit code and its output. */
function runProgram(command, args, env) {
  return new Promise((done) => {
    const child = spawn(command, args, { cwd: root, env: { ...process.env, ...env } });
    let output = '';
    child.stdout.on('data', (text) => (output += text));
    child.stderr.on('data', (text) => (output += text));
    child.on('close', (code) => done({ code, output }));
    child.on('error', (error) => done({ code: -1, output: error.message }));
  });
}

/** Runs a shard of a test program. Its output is shown only if tests fail or are skipped. */
async function runShard({ preset, program, filter, shards }, shard) {
  const report = join(results, `${preset}-${program}-${shard}.json`);
  const isWasm = preset === 'single';
  const path = join(folders.build, preset, 'tests', 'core', isWasm ? `${program}.cjs` : program);
  const options = [`--gtest_output=json:${report}`, `--gtest_filter=${filter}`];
  const env = { ...SANITIZERS, GTEST_TOTAL_SHARDS: shards, GTEST_SHARD_INDEX: shard };
  const { code, output } = await (isWasm
    ? runProgram(process.execPath, [path, ...options], env)
    : runProgram(path, options, env));
  const counts = readGoogleTest(report);
  if (code !== 0 && counts.failed === 0) counts.failed = 1;
  if (counts.failed || counts.skipped) console.log(output);
  return counts;
}

/**
 * Builds a test program of the core with a preset and runs it, two shards in parallel. `suite` is its name in the line
 * of totals; `filter` is GoogleTest's pattern.
 */
export async function runCoreTests(suite, setup, { preset, program, filter = '*', shards = SHARDS }) {
  buildPreset(preset, [program], setup);
  const runs = Array.from({ length: shards }, (_, shard) =>
    runShard({ preset, program, filter, shards }, shard),
  );
  const sum = { passed: 0, failed: 0, skipped: 0 };
  for (const counts of await Promise.all(runs)) for (const key of Object.keys(sum)) sum[key] += counts[key];
  add(`core, ${suite}`, sum);
}
