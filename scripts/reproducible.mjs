// npm run test:reproducible: builds the page and the command line twice, in two copies of the sources at two places, and compares
// every byte. With --core the WebAssembly core too, which takes minutes: twice at one place, as its bytes depend on where it is built
// (see FIXED_ADDRESSES in setup/core.mjs).
// Usage: node scripts/reproducible.mjs [--core]

import { createHash } from 'node:crypto';
import { cpSync, mkdirSync, readdirSync, readFileSync, renameSync, rmSync, statSync } from 'node:fs';
import { basename, join, relative } from 'node:path';
import { root, run } from './setup/environment.mjs';

/** The outputs of builds, and packages, which are linked. */
const LEFT_OUT = new Set(['.git', 'node_modules', 'dist', 'build']);
/** The two builds have different time zones and languages, and run at different times. */
const ENVIRONMENTS = [
  { TZ: 'UTC', LANG: 'C' },
  { TZ: 'Asia/Tokyo', LANG: 'de_DE.UTF-8' },
];

const scratch = join(root, 'build', 'reproducible');

/** A copy of the sources in a folder of its own; without the built core unless `withBuiltCore`. */
function copySources(name, withBuiltCore) {
  const folder = join(scratch, name);
  mkdirSync(folder);
  const isBuiltCore = (path) => basename(path) === 'wasm' && relative(root, path).startsWith('public');
  for (const entry of readdirSync(root))
    if (!LEFT_OUT.has(entry))
      cpSync(join(root, entry), join(folder, entry), {
        recursive: true,
        filter: (path) => withBuiltCore || !isBuiltCore(path),
      });
  // Hard links: packages are also in two folders, and take no space.
  run('cp', ['-al', join(root, 'node_modules'), join(folder, 'node_modules')]);
  return folder;
}

/** Builds the page and the command line at two places, whose names differ in length, too; returns the folders of what is built. */
function buildPageTwice() {
  return ['one', 'another-folder'].map((name, i) => {
    const cwd = copySources(name, true);
    const bundle = (...args) =>
      run(process.execPath, [join(cwd, 'node_modules', 'vite', 'bin', 'vite.js'), 'build', ...args], {
        cwd,
        env: { ...process.env, ...ENVIRONMENTS[i] },
      });
    bundle('--logLevel', 'warn', '--config', 'vite.cli.config.ts');
    bundle('--logLevel', 'warn');
    return join(cwd, 'dist');
  });
}

/** Builds the core twice at one place, the second time from nothing; returns the folders of what is built. */
function buildCoreTwice() {
  return ENVIRONMENTS.map((environment, i) => {
    const cwd = copySources('core', false);
    run(process.execPath, ['scripts/build.mjs', '--core'], { cwd, env: { ...process.env, ...environment } });
    const kept = join(scratch, `core-${i + 1}`);
    renameSync(join(cwd, 'public', 'wasm'), kept);
    rmSync(cwd, { recursive: true });
    return kept;
  });
}

/** The SHA-256 of every file of `folder`, by its path. */
function hashesOf(folder) {
  const paths = readdirSync(folder, { recursive: true })
    .map((name) => join(folder, name))
    .filter((path) => statSync(path).isFile())
    .sort();
  const hashOf = (path) => createHash('sha256').update(readFileSync(path)).digest('hex');
  return new Map(paths.map((path) => [relative(folder, path), hashOf(path)]));
}

/** Prints the differences of both folders; returns whether there are none. */
function areEqual([first, second]) {
  const [a, b] = [hashesOf(first), hashesOf(second)];
  const names = [...new Set([...a.keys(), ...b.keys()])].sort();
  const different = names.filter((name) => a.get(name) !== b.get(name));
  for (const name of different) console.log(`${name} differs between two builds of the same sources.`);
  if (different.length === 0) console.log(`${a.size} files are the same, byte for byte, in two builds.`);
  return different.length === 0;
}

rmSync(scratch, { recursive: true, force: true });
mkdirSync(scratch, { recursive: true });
const page = areEqual(buildPageTwice());
const core = !process.argv.includes('--core') || areEqual(buildCoreTwice());
// Different outputs are kept for inspection.
if (page && core) rmSync(scratch, { recursive: true });
else process.exitCode = 1;
