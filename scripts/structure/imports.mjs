// Finds which file of the product includes or imports which; type imports count.

import { dirname, join } from 'node:path/posix';
import ts from 'typescript';
import { isCore } from './texts.mjs';

const endings = ['', '.ts', '.tsx', '/index.ts'];

function includesOf({ text }) {
  return [...text.matchAll(/^\s*#include "([^"]+)"/gm)].map((match) => join('wasm', match[1]));
}

/** Matches `import … from`, `export … from` and `import('…')` as a value or type, for paths that begin with a dot. */
function importsOf({ path, text }, known) {
  return ts
    .preProcessFile(text, true, true)
    .importedFiles.map(({ fileName }) => fileName)
    .filter((name) => name.startsWith('.'))
    .map((name) => join(dirname(path), name))
    .map((name) => endings.map((ending) => name + ending).find((file) => known.has(file)) ?? name);
}

/** Edges { from, to } between paths. */
export function importEdges(files) {
  const known = new Set(files.map(({ path }) => path));
  return files.flatMap((file) => {
    const targets = isCore(file.path) ? includesOf(file) : importsOf(file, known);
    return [...new Set(targets)].map((to) => ({ from: file.path, to }));
  });
}
