// npm run lint: formatting, lint, types and layers. Each check is one line, and counts as one test in `npm test`.

import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { layerViolations } from './check-layers.mjs';
import { longFunctions } from './check-function-length.mjs';
import { findClangFormat, root } from './setup/environment.mjs';

const tool = (...path) => join(root, 'node_modules', ...path);

function command(name, program, args) {
  const result = spawnSync(program, args, { cwd: root, encoding: 'utf8' });
  return { name, problems: result.status === 0 ? '' : `${result.stdout}${result.stderr}`.trim() || 'failed' };
}

export const coreFiles = () =>
  ['wasm', 'tests/core'].flatMap((folder) =>
    readdirSync(join(root, folder), { recursive: true })
      .map((name) => join(folder, name))
      .filter((name) => /\.(h|cpp)$/.test(name)),
  );

/**
 * glTF-Transform's texture functions bring sharp with a prebuilt libvips (LGPL). Nothing here calls them, and neither the
 * page nor the command line's bundle holds it.
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

/** All checks: { name, problems }, `problems` empty where it passed. */
export function check() {
  return [
    command('prettier', process.execPath, [
      tool('prettier', 'bin', 'prettier.cjs'),
      '--check',
      '.',
      '--log-level',
      'warn',
    ]),
    command('eslint', process.execPath, [tool('eslint', 'bin', 'eslint.js'), '.', '--max-warnings', '0']),
    command('types', process.execPath, [tool('typescript', 'bin', 'tsc'), '-b']),
    command('clang-format', findClangFormat() ?? 'clang-format', ['--dry-run', '--Werror', ...coreFiles()]),
    { name: 'layers', problems: layerViolations().join('\n') },
    { name: 'function length', problems: longFunctions(coreFiles()).join('\n') },
    { name: 'licences of what ships', problems: licences() },
  ];
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const results = check();
  for (const { name, problems } of results)
    console.log(problems ? `FAILED ${name}\n${problems}` : `ok     ${name}`);
  process.exit(results.some((result) => result.problems) ? 1 : 0);
}
