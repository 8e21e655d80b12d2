// npm run lint: checks formatting, lint, types and structure. Each check prints one line and is one test of `npm test`.
// Usage: node scripts/check.mjs [--only NAME]     NAME: the checks whose names contain it

import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { findClangFormat, root } from './setup/environment.mjs';
import { wrongDependencies } from './structure/dependencies.mjs';
import { importCycles } from './structure/cycles.mjs';
import { missingPaths } from './structure/document_paths.mjs';
import { struckWords } from './structure/glossary.mjs';
import { modules } from './structure/modules.mjs';
import { largeThings } from './structure/sizes.mjs';
import { readProduct } from './structure/texts.mjs';
import { doubleTypeNames } from './structure/type_names.mjs';

const tool = (...path) => join(root, 'node_modules', ...path);

function command(program, args) {
  const result = spawnSync(program, args, { cwd: root, encoding: 'utf8' });
  return result.status === 0 ? '' : `${result.stdout}${result.stderr}`.trim() || 'failed';
}

const node = (path, ...args) => command(process.execPath, [tool(...path), ...args]);

export const coreFiles = () =>
  ['wasm', 'tests/core'].flatMap((folder) =>
    readdirSync(join(root, folder), { recursive: true })
      .map((name) => join(folder, name))
      .filter((name) => /\.(h|cpp)$/.test(name)),
  );

/**
 * glTF-Transform's texture functions depend on sharp, which has a prebuilt libvips (LGPL). Nothing here calls them, and
 * neither bundle, of the page or the command line, contains it.
 */
const notShipped = /^node_modules\/@img\/sharp-libvips-/;

function licences() {
  const lock = JSON.parse(readFileSync(join(root, 'package-lock.json'), 'utf8'));
  const allowed = /^\(?(MIT|ISC|BSD|Apache|MPL|0BSD|OFL|CC0|Unlicense|BlueOak|Python-2)/;
  return Object.entries(lock.packages)
    .filter(
      ([path, entry]) =>
        path && !entry.dev && !notShipped.test(path) && !allowed.test(entry.license ?? 'unknown'),
    )
    .map(([path, entry]) => `${path}: ${entry.license ?? 'no licence'}`)
    .join('\n');
}

const readGlossary = () => readFileSync(join(root, 'docs', 'glossary.md'), 'utf8');
const ofProduct = (findProblems) => () => findProblems(readProduct()).join('\n');

/** Compares the paths in the documents with all files in git. */
function documentProblems() {
  const git = spawnSync('git', ['ls-files', '--cached', '--others', '--exclude-standard'], {
    cwd: root,
    encoding: 'utf8',
  });
  const known = new Set(git.stdout.split('\n'));
  const documents = [...known]
    .filter((path) => path.endsWith('.md') && existsSync(join(root, path)))
    .map((path) => ({ path, text: readFileSync(join(root, path), 'utf8') }));
  return missingPaths(documents, known).join('\n');
}

/** Name of a check -> function that returns its problems as text, empty if there are none. */
const checks = {
  prettier: () => node(['prettier', 'bin', 'prettier.cjs'], '--check', '.', '--log-level', 'warn'),
  eslint: () => node(['eslint', 'bin', 'eslint.js'], '.', '--max-warnings', '0'),
  types: () => node(['typescript', 'bin', 'tsc'], '-b'),
  'clang-format': () =>
    command(findClangFormat() ?? 'clang-format', ['--dry-run', '--Werror', ...coreFiles()]),
  'licences of what ships': licences,
  dependencies: ofProduct((files) => wrongDependencies(files, modules)),
  cycles: ofProduct(importCycles),
  sizes: ofProduct(largeThings),
  'type names': ofProduct(doubleTypeNames),
  glossary: ofProduct((files) => struckWords(files, readGlossary())),
  'paths in documents': documentProblems,
};

/** Runs the checks whose names contain `only`, or all. Returns { name, problems }; `problems` is empty if it passed. */
export function check(only = '') {
  return Object.entries(checks)
    .filter(([name]) => name.includes(only))
    .map(([name, findProblems]) => ({ name, problems: findProblems() }));
}

function main() {
  const { only } = parseArgs({ options: { only: { type: 'string', default: '' } } }).values;
  const results = check(only);
  for (const { name, problems } of results)
    console.log(problems ? `FAILED ${name}\n${problems}` : `ok     ${name}`);
  if (!results.length) console.log(`No check has a name with "${only}": ${Object.keys(checks).join(', ')}.`);
  return results.length && results.every((result) => !result.problems) ? 0 : 1;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) process.exit(main());
