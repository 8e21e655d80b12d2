// npm run fuzz: calls the product with generated inputs until the time is used up: C++ by libFuzzer, TypeScript by fast-check.
// Usage: npm run fuzz -- [--minutes N] [--target NAME] [--seed N]      one minute per target by default

import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { build } from './build.mjs';
import { bundleModule } from './setup/bundle.mjs';
import { buildPreset } from './setup/core.mjs';
import { fail, findFuzzingCompiler, folders, root } from './setup/environment.mjs';

const { values } = parseArgs({
  options: { minutes: { type: 'string' }, target: { type: 'string' }, seed: { type: 'string' } },
});
const seed = Number(values.seed ?? 1);
const CORE_TARGETS = readdirSync(join(root, 'tests', 'fuzz', 'core', 'targets')).map((name) =>
  name.slice(0, -4),
);
const results = [];

function report(result) {
  results.push(result);
  const rate = Math.round(result.inputs / result.seconds);
  console.log(
    `${result.finding ? 'FOUND' : 'ok   '} ${result.target}: ${result.inputs} inputs, ${rate} a second`,
  );
  if (result.finding) console.log(`      ${result.finding}`);
}

/** Runs a target of the core. The corpus is stored in build/fuzz/corpus, failing inputs in build/fuzz/findings. */
function fuzzCore(target, seconds) {
  const corpus = join(folders.build, 'fuzz', 'corpus', target);
  const findings = join(folders.build, 'fuzz', 'findings', target);
  for (const folder of [corpus, findings]) mkdirSync(folder, { recursive: true });
  const known = join(root, 'tests', 'fuzz', 'findings', target);
  const limits = [
    '-max_len=600',
    '-timeout=300',
    '-rss_limit_mb=3000',
    '-print_final_stats=1',
    '-len_control=0',
  ];
  const options = [`-max_total_time=${seconds}`, `-seed=${seed}`, `-artifact_prefix=${findings}/`, ...limits];
  const inputs = [corpus, ...(existsSync(known) ? [known] : [])];
  const start = Date.now();
  const program = join(folders.build, 'fuzz', 'tests', 'fuzz', `fuzz_${target}`);
  const { status, stderr } = spawnSync(program, [...options, ...inputs], {
    encoding: 'utf8',
    maxBuffer: 1 << 28,
    env: { ...process.env, UBSAN_OPTIONS: 'halt_on_error=1:abort_on_error=1:print_stacktrace=1' },
  });
  const words = stderr.split('\n');
  const about = words.find((line) =>
    /Broken promise|runtime error|ERROR: AddressSanitizer|ERROR: libFuzzer/.test(line),
  );
  const file =
    words
      .findLast((line) => line.includes('Test unit written to'))
      ?.split(' ')
      .pop() ?? '';
  report({
    target: `core, ${target}`,
    inputs: Number(/number_of_executed_units: (\d+)/.exec(stderr)?.[1] ?? 0),
    seconds: (Date.now() - start) / 1000,
    finding: status === 0 ? '' : `${about ?? `ended with ${status}`} (${file})`,
  });
}

async function engineTargets() {
  const outDir = join(folders.build, 'fuzz', 'engine');
  await bundleModule('tests/fuzz/engine/main.ts', outDir);
  return import(pathToFileURL(join(outDir, 'main.js')).href);
}

const setup = build({ tests: true });
const { allTargets, fuzz } = await engineTargets();
const wasmFolder = pathToFileURL(join(root, 'public', 'wasm', '/')).href;
const isAsked = (name) => values.target === undefined || values.target === name;
const ofEngine = (await allTargets(wasmFolder)).filter(({ name }) => isAsked(name));
const compiler = findFuzzingCompiler();
const ofCore = compiler ? CORE_TARGETS.filter((name) => isAsked(name)) : [];
if (!compiler)
  console.log(
    'SKIPPED the targets of the core: libFuzzer needs Clang with its runtime (clang-19, libclang-rt-19-dev).',
  );
const count = ofEngine.length + ofCore.length;
if (count === 0)
  fail(
    `There is no fuzz target "${values.target}": choose one of ${CORE_TARGETS.join(', ')} or of tests/fuzz/engine.`,
  );
const seconds = Math.max(1, Math.round((60 * Number(values.minutes ?? count)) / count));
if (ofCore.length > 0)
  buildPreset(
    'fuzz',
    ofCore.map((target) => `fuzz_${target}`),
    { headers: setup.headers, compiler },
  );
for (const target of ofCore) fuzzCore(target, seconds);
await fuzz(ofEngine, { seed, seconds }, report);
const inputs = results.reduce((sum, result) => sum + result.inputs, 0);
const found = results.filter(({ finding }) => finding).length;
console.log(`${inputs} inputs through ${results.length} targets, ${found} with a finding`);
process.exit(found ? 1 : 0);
