// Measures how much faster a batch is with two jobs than with one, each on one thread. Needs `npm run build`.
//
//   node tests/bench/batch.mjs [--assets 200] [--faces 1000] [--jobs 2] [--keep FOLDER]
//
// Beside it as many programs that run at the same time, each with its share of the assets: what the machine allows at most. Also
// measures limber optimize once for each of the first ten assets, which pays the start of the program for each.

import { spawn, spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { writeAssets } from './batch_assets.mjs';

const option = (value) => ({ type: 'string', default: value });
const { values } = parseArgs({
  options: { assets: option('200'), faces: option('1000'), jobs: option('2') },
});
const limber = resolve(import.meta.dirname, '..', '..', 'dist', 'cli', 'limber.mjs');
const folder = mkdtempSync(join(tmpdir(), 'limber-batch-bench-'));
const source = join(folder, 'source');
const count = Number(values.assets);
writeAssets(source, { count, faces: Number(values.faces), seed: 7 });

/** Seconds of a run; throws where it fails. */
function seconds(...words) {
  const begun = performance.now();
  const { status, stderr } = spawnSync(process.execPath, [limber, ...words], { encoding: 'utf8' });
  if (status !== 0) throw new Error(`limber ${words.join(' ')} ended with ${status}: ${stderr}`);
  return (performance.now() - begun) / 1000;
}

const words = (from, to, jobs) => [
  ...['batch', from, join(folder, to), '--jobs', jobs, '--threads', '1', '--soft', '--quiet'],
];
const batch = (jobs) => seconds(...words(source, `out-${jobs}`, jobs));

const names = readdirSync(source, { recursive: true })
  .map(String)
  .filter((name) => name.endsWith('.obj'))
  .sort();

/** Seconds of as many programs as jobs at the same time, each with its own share of the assets and one job. */
async function apart(count) {
  names.forEach((name, i) => {
    const to = join(folder, `share-${i % count}`, name);
    mkdirSync(dirname(to), { recursive: true });
    cpSync(join(source, name), to);
  });
  const begun = performance.now();
  const ends = Array.from({ length: count }, (_, k) => {
    const program = spawn(process.execPath, [
      limber,
      ...words(join(folder, `share-${k}`), `apart-${k}`, '1'),
    ]);
    return new Promise((done, fail) =>
      program.on('exit', (status) =>
        status === 0 ? done() : fail(new Error(`a batch ended with ${status}`)),
      ),
    );
  });
  await Promise.all(ends);
  return (performance.now() - begun) / 1000;
}

const one = batch('1');
const several = batch(values.jobs);
const most = await apart(Number(values.jobs));
const nothing = batch(values.jobs);
mkdirSync(join(folder, 'single'));
const single = names
  .slice(0, 10)
  .map((name, i) =>
    seconds(
      'optimize',
      join(source, name),
      join(folder, 'single', `${i}.glb`),
      '--threads',
      '1',
      '--quiet',
      '--soft',
    ),
  );
rmSync(folder, { recursive: true, force: true });
const mean = single.reduce((sum, value) => sum + value, 0) / single.length;
console.log(`assets ${count} of ${values.faces} to ${2 * Number(values.faces)} faces, --threads 1`);
console.log(`--jobs 1  ${one.toFixed(1)} s (${(one / count).toFixed(3)} s each)`);
console.log(`--jobs ${values.jobs}  ${several.toFixed(1)} s, ${(one / several).toFixed(2)} times as fast`);
console.log(
  `${values.jobs} programs at the same time  ${most.toFixed(1)} s, ${(one / most).toFixed(2)} times as fast`,
);
console.log(`again, all up to date  ${nothing.toFixed(1)} s`);
console.log(`limber optimize for each  ${mean.toFixed(3)} s each (the first ${single.length})`);
