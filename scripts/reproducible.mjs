// npm run test:reproducible: builds the page and the command line twice, in two copies of the sources at two places, and compares
// every byte. With --core the WebAssembly core too, which takes minutes.
// Usage: node scripts/reproducible.mjs [--core]

import { createHash } from 'node:crypto';
import { cpSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync } from 'node:fs';
import { basename, join, relative } from 'node:path';
import { root, run } from './setup/environment.mjs';

const withCore = process.argv.includes('--core');
/** What builds leave behind, and packages, which are linked. */
const LEFT_OUT = new Set(['.git', 'node_modules', 'dist', 'build']);

/** A copy of the sources in a folder of its own, whose name differs in length, too. */
function copySources(scratch, name) {
  const folder = join(scratch, name);
  mkdirSync(folder);
  for (const entry of readdirSync(root))
    if (!LEFT_OUT.has(entry))
      cpSync(join(root, entry), join(folder, entry), {
        recursive: true,
        filter: (path) =>
          !(withCore && basename(path) === 'wasm' && relative(root, path).startsWith('public')),
      });
  // Hard links: packages are at two places, too, and take no room.
  run('cp', ['-al', join(root, 'node_modules'), join(folder, 'node_modules')]);
  return folder;
}

/** Builds in `folder`; the two builds differ in their time zone, language and clock as well. */
function buildIn(folder, environment) {
  const env = { ...process.env, ...environment };
  const node = (...args) => run(process.execPath, args, { cwd: folder, env });
  if (withCore) node('scripts/build.mjs', '--core');
  const vite = join(folder, 'node_modules', 'vite', 'bin', 'vite.js');
  node(vite, 'build', '--logLevel', 'warn', '--config', 'vite.cli.config.ts');
  node(vite, 'build', '--logLevel', 'warn');
}

/** The SHA-256 of every file of dist, by its path. */
function hashesOf(folder) {
  const dist = join(folder, 'dist');
  const paths = readdirSync(dist, { recursive: true })
    .map((name) => join(dist, name))
    .filter((path) => statSync(path).isFile())
    .sort();
  const hashOf = (path) => createHash('sha256').update(readFileSync(path)).digest('hex');
  return new Map(paths.map((path) => [relative(dist, path), hashOf(path)]));
}

/** The names of the files that are not the same in both. */
function differences(first, second) {
  const names = [...new Set([...first.keys(), ...second.keys()])].sort();
  return names.filter((name) => first.get(name) !== second.get(name));
}

const scratch = join(root, 'build', 'reproducible');
rmSync(scratch, { recursive: true, force: true });
mkdirSync(scratch, { recursive: true });
try {
  const [one, two] = ['one', 'another-folder'].map((name) => copySources(scratch, name));
  buildIn(one, { TZ: 'UTC', LANG: 'C' });
  buildIn(two, { TZ: 'Asia/Tokyo', LANG: 'de_DE.UTF-8' });
  const first = hashesOf(one);
  const wrong = differences(first, hashesOf(two));
  for (const name of wrong) console.log(`dist/${name} differs between two builds of the same sources.`);
  if (wrong.length === 0) console.log(`${first.size} files are the same, byte for byte, in two builds.`);
  process.exitCode = wrong.length === 0 ? 0 : 1;
} finally {
  // What differs stays to be looked at.
  if (process.exitCode === 0) rmSync(scratch, { recursive: true, force: true });
}
