// npm run pack: makes the npm package in dist/package, and its tarball in dist. The core has to be built.

import { chmodSync, copyFileSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { root, run } from '../setup/environment.mjs';
import { writeBundles } from './bundles.mjs';
import { copyDeclarations } from './declarations.mjs';
import { manifestOf } from './manifest.mjs';
import { notices } from './notices.mjs';

const CORE = ['single', 'threads'].flatMap((build) => [`limber-${build}.js`, `limber-${build}.wasm`]);

/** Writes the package into `folder`, which is emptied first. */
export async function writePackage(folder) {
  const core = join(root, 'public', 'wasm');
  const missing = CORE.find((name) => !existsSync(join(core, name)));
  if (missing) throw new Error(`${join(core, missing)} is missing: run npm run build first.`);
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(join(folder, 'assets'), { recursive: true });
  for (const name of CORE) {
    copyFileSync(join(core, name), join(folder, 'assets', name));
    chmodSync(join(folder, 'assets', name), 0o644);
  }
  run(process.execPath, [
    join(root, 'node_modules', 'typescript', 'bin', 'tsc'),
    '-b',
    'tsconfig.library.json',
  ]);
  copyDeclarations(join(root, 'build', 'types'), join('library', 'index.d.ts'), join(folder, 'types'));
  const modules = await writeBundles(folder);
  const repository = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
  writeFileSync(join(folder, 'package.json'), manifestOf(repository, folder));
  writeFileSync(join(folder, 'THIRD-PARTY-NOTICES.md'), notices(modules));
  writeFileSync(join(folder, 'README.md'), readme());
  copyFileSync(join(root, 'LICENSE'), join(folder, 'LICENSE'));
  copyFileSync(join(root, 'docs', 'limber.1'), join(folder, 'limber.1'));
  mkdirSync(join(folder, 'schemas'));
  for (const name of ['report.schema.json', 'settings.schema.json', 'batch.schema.json'])
    copyFileSync(join(root, 'docs', name), join(folder, 'schemas', name));
  chmodSync(join(folder, 'cli', 'limber.mjs'), 0o755);
}

/** The page for users of the library; its links lead to pages that are not in the package. */
const readme = () =>
  readFileSync(join(root, 'docs', 'library.md'), 'utf8').replace(/\[([^\]]+)\]\((?!https?:)[^)]*\)/g, '$1');

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const folder = join(root, 'dist', 'package');
  await writePackage(folder);
  run('npm', ['pack', '--silent', folder, '--pack-destination', join(root, 'dist')]);
  console.log(`Packed ${folder}.`);
}
