// npm test: sets up, builds, runs the suites and ends with one line of totals, "N passed, N failed".
// npm run test:full (--full) adds the slow tests: the whole core natively with the address, undefined-behaviour and
// thread sanitizers, and the tests of the page that are tagged @full.

import { mkdirSync, rmSync } from 'node:fs';
import { build } from './build.mjs';
import { runCoreTests } from './suites/core.mjs';
import { add, printTotals, results } from './suites/totals.mjs';
import { runPlaywright, runVitest } from './suites/typescript.mjs';

async function runChecks() {
  const { check } = await import('./check.mjs'); // needs the packages that `build` installs
  for (const { name, problems } of check()) {
    if (problems) console.log(problems);
    add(name, { passed: problems ? 0 : 1, failed: problems ? 1 : 0, skipped: 0 });
  }
}

/** The site, whose pages the tests of the page open. */
async function runSite() {
  const { makeSite } = await import('./site.mjs');
  const { problems } = await makeSite();
  if (problems.length > 0) console.log(problems.join('\n'));
  add('links of the site', {
    passed: problems.length === 0 ? 1 : 0,
    failed: problems.length === 0 ? 0 : 1,
    skipped: 0,
  });
}

async function runSanitizers(native) {
  await runCoreTests('native with address and undefined-behaviour sanitizers', native, {
    preset: 'native',
    program: 'core_tests',
  });
  await runCoreTests('native with the thread sanitizer', native, {
    preset: 'races',
    program: 'core_tests',
    filter: '*hread*',
  });
}

const full = process.argv.includes('--full');
const setup = build({ tests: true });
const native = { headers: setup.headers };
rmSync(results, { recursive: true, force: true });
mkdirSync(results, { recursive: true });
await runChecks();
await runCoreTests('wasm', setup, { preset: 'single', program: 'core_tests' });
for (const preset of ['native', 'races'])
  await runCoreTests(`threads, ${preset}`, native, { preset, program: 'thread_tests', shards: 1 });
if (full) await runSanitizers(native);
runVitest();
await runSite();
runPlaywright({ full });
process.exit(printTotals());
