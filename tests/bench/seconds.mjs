// Measures how long the command line and tuning take, beside the targets. Needs `npm run build`.
//
//   node tests/bench/seconds.mjs [--only parts,small,drop,million,start,tune]
//
// Files are made here; `small` also takes those of meshes/gltf in the folder that LIMBER_SHARED names. CPU seconds are user time
// of one thread; others are seconds on the clock with two.

import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { bundleModule } from '../../scripts/setup/bundle.mjs';

const root = resolve(import.meta.dirname, '..', '..');
const scratch = join(root, 'build', 'bench', 'seconds');
const limber = join(root, 'dist', 'cli', 'limber.mjs');
const asked = process.argv[2] === '--only' ? process.argv[3].split(',') : null;
const isAsked = (name) => asked === null || asked.includes(name);

mkdirSync(scratch, { recursive: true });
await bundleModule('tests/bench/seconds_entry.ts', join(scratch, 'engine'));
const made = await import(pathToFileURL(join(scratch, 'engine', 'seconds_entry.js')).href);

function row(what, seconds, target, more = '') {
  console.log([what, seconds.toFixed(2), target, (seconds / target).toFixed(2), more].join('\t'));
}
console.log(['what', 'seconds', 'target', 'ratio', ''].join('\t'));

/** Runs the command line; seconds on the clock, and its report. */
function run(words) {
  const report = join(scratch, 'report.json');
  const start = performance.now();
  const more = words[0] === 'optimize' ? ['--report', report, '--force', '--quiet'] : [];
  const done = spawnSync(process.execPath, [limber, ...words, ...more], { stdio: 'pipe' });
  const seconds = (performance.now() - start) / 1000;
  const code = done.status ?? -1;
  if (code !== 0 && code !== 2) throw new Error(`${words.join(' ')}: ${done.stderr}`);
  return { seconds, report: more.length > 0 ? JSON.parse(readFileSync(report, 'utf8')) : null };
}

async function file(name, bytes) {
  const path = join(scratch, name);
  if (!existsSync(path)) writeFileSync(path, await bytes());
  return path;
}

const out = join(scratch, 'out.glb');
const megabytes = ({ peakHeapBytes }) => `core ${(peakHeapBytes / 2 ** 20).toFixed(0)} MB`;

if (isAsked('start')) {
  const tiny = await file('tiny.glb', () => made.ballFile(100));
  const least = (words) => Math.min(...[1, 2, 3, 4, 5].map(() => run(words).seconds));
  row('--version', least(['--version']), 0.12);
  row('tiny mesh', least(['optimize', tiny, out]), 0.35);
}

if (isAsked('parts'))
  for (const [count, target] of [
    [100, 2],
    [2000, 15],
  ]) {
    const path = await file(`parts${count}.glb`, () => made.partsFile(count));
    const { seconds, report } = run(['optimize', path, out, '--threads', '2']);
    row(`${count} parts of 132 faces`, seconds, target, megabytes(report));
  }

if (isAsked('small')) {
  const shared = process.env.LIMBER_SHARED && join(process.env.LIMBER_SHARED, 'meshes', 'gltf');
  if (!shared || !existsSync(shared))
    console.log('LIMBER_SHARED names no folder with meshes/gltf: only made files.');
  const files =
    shared && existsSync(shared) ? readdirSync(shared).filter((name) => name.endsWith('.glb')) : [];
  const paths = files.map((name) => join(shared, name));
  for (const faces of [500, 2000, 5000])
    paths.push(await file(`ball${faces}.glb`, () => made.ballFile(faces)));
  const all = [];
  for (const path of paths) {
    let found;
    try {
      found = run(['optimize', path, out, '--threads', '1']);
    } catch {
      continue; // what cannot be read is not timed
    }
    if (found.report.input.faces >= 6000) continue;
    all.push(found.seconds);
    row(`  ${path.split('/').pop()}, ${found.report.input.faces} faces`, found.seconds, 1);
  }
  const middle = all.sort((a, b) => a - b)[Math.floor(all.length / 2)];
  row(`median of ${all.length} below 6,000 faces, one thread`, middle, 1);
}

if (isAsked('drop'))
  for (const [faces, target] of [
    [7000, 1.5],
    [86000, 8],
  ]) {
    const path = await file(`ball${faces}.glb`, () => made.ballFile(faces));
    const { seconds, report } = run(['optimize', path, out, '--threads', '2']);
    row(`${faces} faces, file to result`, seconds, target, megabytes(report));
  }

if (isAsked('million')) {
  const path = await file('million.glb', () => made.ballFile(1100000));
  for (const method of ['limber', 'qem']) {
    const { seconds, report } = run(['optimize', path, out, '--method', method, '--threads', '2']);
    row(`1.1 million faces, half, ${method}`, seconds, 12, megabytes(report));
  }
}

if (isAsked('tune')) {
  const wasmFolder = pathToFileURL(join(root, 'public', 'wasm') + '/').href;
  const core = await made.loadCore({ threads: 2, wasmFolder });
  for (const solver of ['springs', 'mujoco'])
    for (const [faces, target] of [
      [10000, 2],
      [100000, 20],
    ]) {
      const { seconds, error } = await made.timeTuning(core, faces, solver);
      row(`solve and tune, ${solver}, ${faces} faces`, seconds, target, `error ${error.toFixed(2)} %`);
    }
  process.exit(0); // threads of the core would keep it waiting
}
