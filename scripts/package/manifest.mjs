// The manifest of the npm package. Name, version and description fields are those of the repository.

import { readdirSync, readFileSync } from 'node:fs';
import { builtinModules } from 'node:module';
import { join } from 'node:path';
import ts from 'typescript';

/** Packages whose objects callers pass in: with a range of all supported versions, so that there is one copy of each. */
const SHARED = /^@gltf-transform\//;

/** The packages that the files in `folder` import. */
function importedPackages(folder) {
  const names = new Set();
  for (const name of readdirSync(folder, { recursive: true })) {
    // The scripts and the worker in assets have no imports.
    if (!/\.(mjs|d\.ts)$/.test(name) || name.startsWith('assets')) continue;
    const { importedFiles } = ts.preProcessFile(readFileSync(join(folder, name), 'utf8'), true, true);
    for (const { fileName } of importedFiles)
      if (!/^(\.|node:)/.test(fileName) && !builtinModules.includes(fileName.split('/')[0]))
        names.add(/^(?:@[^/]+\/)?[^/]+/.exec(fileName)[0]);
  }
  return [...names].sort();
}

/** The text of package.json of the package in `folder`; `repository` is the manifest of the repository. */
export function manifestOf(repository, folder) {
  const { name, version, description, license, engines } = repository;
  const dependencies = importedPackages(folder).map((imported) => {
    const exact = repository.dependencies[imported];
    if (!exact) throw new Error(`The package imports ${imported}, which is no dependency of the repository.`);
    return [imported, SHARED.test(imported) ? `^${exact}` : exact];
  });
  const manifest = {
    name,
    version,
    description,
    license,
    keywords: ['mesh', 'simplification', 'decimation', 'gltf', 'glb', 'lod', 'cloth', 'soft-body', 'modal'],
    type: 'module',
    engines,
    bin: { limber: 'cli/limber.mjs' },
    man: ['./limber.1'],
    main: './node/index.mjs',
    browser: './browser/index.mjs',
    types: './types/library/index.d.ts',
    exports: {
      '.': {
        types: './types/library/index.d.ts',
        node: './node/index.mjs',
        default: './browser/index.mjs',
      },
      './assets/*': './assets/*',
      './schemas/*': './schemas/*',
      './package.json': './package.json',
    },
    sideEffects: false,
    dependencies: Object.fromEntries(dependencies),
  };
  return `${JSON.stringify(manifest, null, 2)}\n`;
}
