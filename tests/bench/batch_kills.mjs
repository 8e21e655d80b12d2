// Kills a batch with SIGKILL at random moments, runs it again, and compares every result with those of an undisturbed run. Needs
// `npm run build`.
//
//   node tests/bench/batch_kills.mjs [--kills 50] [--seed 1] [--assets 12] [--faces 300]
//
// Victims take turns: the batch itself, so that its jobs are left alone; one of its jobs; all of them. Exit code 0 where all are equal.

import { spawn } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { randomNumbers, writeAssets } from './batch_assets.mjs';

const option = (value) => ({ type: 'string', default: value });
const { values } = parseArgs({
  options: { kills: option('50'), seed: option('1'), assets: option('12'), faces: option('300') },
});
const [kills, seed, assets, faces] = ['kills', 'seed', 'assets', 'faces'].map((name) => Number(values[name]));
const limber = resolve(import.meta.dirname, '..', '..', 'dist', 'cli', 'limber.mjs');
const folder = mkdtempSync(join(tmpdir(), 'limber-kills-'));
const source = join(folder, 'source');
const random = randomNumbers(seed);

/** A batch in a process group of its own; `ended` is its exit code, or null where it was killed. */
function start(out) {
  const words = [
    limber,
    'batch',
    source,
    out,
    '--jobs',
    '2',
    '--lods',
    '0.25',
    '--bindings',
    '--soft',
    '--quiet',
  ];
  const child = spawn(process.execPath, words, { detached: true, stdio: 'ignore' });
  return { child, ended: new Promise((done) => child.on('exit', (code) => done(code))) };
}

/** Hashes of all results by name; the summary has times, and the batch's own folder too. */
function resultsOf(out) {
  const names = readdirSync(out, { recursive: true }).map(String);
  return new Map(
    names
      .filter((name) => !name.startsWith('.limber-batch') && !name.startsWith('summary.'))
      .filter((name) => statSync(join(out, name)).isFile())
      .sort()
      .map((name) => [
        name,
        createHash('sha256')
          .update(readFileSync(join(out, name)))
          .digest('hex'),
      ]),
  );
}

const jobsOf = (id) =>
  readFileSync(`/proc/${id}/task/${id}/children`, 'utf8').trim().split(/\s+/).filter(Boolean).map(Number);

const VICTIMS = {
  batch: (child) => child.kill('SIGKILL'),
  job: (child) => {
    const jobs = jobsOf(child.pid);
    if (jobs.length > 0) process.kill(jobs[Math.floor(random() * jobs.length)], 'SIGKILL');
  },
  all: (child) => process.kill(-child.pid, 'SIGKILL'),
};

function differences(expected, out) {
  const found = resultsOf(out);
  const names = [...new Set([...expected.keys(), ...found.keys()])];
  const left = ['work', 'lock.json'].filter((name) => existsSync(join(out, '.limber-batch', name)));
  return [...names.filter((name) => expected.get(name) !== found.get(name)), ...left];
}

writeAssets(source, { count: assets, faces, seed });
const whole = join(folder, 'whole');
const begun = performance.now();
const code = await start(whole).ended;
const duration = performance.now() - begun;
const expected = resultsOf(whole);
if (code !== 0 || expected.size !== 3 * assets) throw new Error(`The undisturbed run ended with ${code}.`);

let [wrong, finished] = [0, 0];
for (let i = 0; i < kills; ++i) {
  const out = join(folder, `killed-${i}`);
  const victim = process.platform === 'linux' ? Object.keys(VICTIMS)[i % 3] : 'batch';
  const moment = random() * duration;
  const { child, ended } = start(out);
  await new Promise((done) => setTimeout(done, moment));
  if (child.exitCode === null && child.signalCode === null) VICTIMS[victim](child);
  const first = await ended;
  const before = existsSync(out) ? resultsOf(out).size : 0;
  const again = await start(out).ended;
  const different = differences(expected, out);
  if (again !== 0 || different.length > 0) ++wrong;
  if (before === expected.size) ++finished;
  const verdict = again === 0 && different.length === 0 ? 'equal' : `exit ${again}, DIFFERENT ${different}`;
  console.log(
    `${i + 1}: ${victim} killed after ${moment.toFixed(0)} of ${duration.toFixed(0)} ms (exit ${first}, ${before} of ${expected.size} results): ${verdict}`,
  );
  rmSync(out, { recursive: true, force: true });
}
rmSync(folder, { recursive: true, force: true });
console.log(`${kills - wrong} of ${kills} equal; ${finished} had all results before`);
process.exit(wrong === 0 ? 0 : 1);
