// Input of all structure checks: the product's files as { path, text }, text without comments and strings, words of names.

import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { root } from '../setup/environment.mjs';

const isCode = (path) => /\.(h|cpp|ts|tsx)$/.test(path);
export const isCore = (path) => /\.(h|cpp)$/.test(path);

/** Every file below the folders as { path, text }, ordered by path; text is '' if the file is not code. */
export function readProduct(folders = ['wasm', 'web']) {
  return folders
    .flatMap((folder) =>
      readdirSync(join(root, folder), { recursive: true, withFileTypes: true })
        .filter((entry) => entry.isFile())
        .map((entry) => join(entry.parentPath ?? entry.path, entry.name)),
    )
    .sort()
    .map((file) => ({
      path: file.slice(root.length + 1).replaceAll('\\', '/'),
      text: isCode(file) ? readFileSync(file, 'utf8') : '',
    }));
}

/** Replaces C++ comments, strings and characters by spaces; line breaks stay, so offsets and line numbers are valid. */
export function blankComments(text) {
  // An apostrophe between digits separates them: 20'000.
  const quiet =
    /\/\/[^\n]*|\/\*[^]*?\*\/|R"(\w*)\([^]*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![\da-fA-F])'(?:\\.|[^'\\\n])+'/g;
  return text.replace(quiet, (found) => found.replace(/[^\n]/g, ' '));
}

/** The words of an identifier or a file name, in lower case: `firstHold_2` has `first`, `hold` and `2`. */
export function wordsOf(name) {
  return name
    .replace(/([a-z\d])([A-Z])/g, '$1 $2')
    .replace(/([A-Z])([A-Z][a-z])/g, '$1 $2')
    .split(/[^A-Za-z\d]+/)
    .filter(Boolean)
    .map((word) => word.toLowerCase());
}

/** The line number of an offset, from 1. */
export const lineAt = (text, offset) => text.slice(0, offset).split('\n').length;
