// Words that docs/glossary.md strikes (its last column, "instead of") must not occur in names of the product.

import ts from 'typescript';
import { blankComments, isCore, wordsOf } from './texts.mjs';
import { parse, walk } from './ts_functions.mjs';

/** Names that may contain a struck word, where, and why. */
const allowed = [
  {
    name: /^pull$/i,
    path: /^(wasm\/simulate|web)\//,
    why: 'the scenario of that name, a value of --scenario',
  },
];
const isAllowed = (path, name) => allowed.some((one) => one.name.test(name) && one.path.test(path));

/**
 * Struck terms: { words, names }. A word is struck as any word of an identifier, a term in `backticks` only as a whole
 * identifier. Terms of several words are advice for prose and are not checked.
 */
export function struckTerms(glossary) {
  const words = new Map();
  const names = new Map();
  let column = -1;
  for (const line of glossary.split('\n')) {
    const cells = line
      .split('|')
      .slice(1, -1)
      .map((cell) => cell.trim());
    if (!cells.length) column = -1;
    else if (cells.at(-1) === 'instead of') column = cells.length - 1;
    else if (column > 0 && !/^-+$/.test(cells[0]))
      for (const term of cells[column].split(',').map((part) => part.trim()))
        if (/^`.+`$/.test(term)) names.set(term.slice(1, -1), cells[0]);
        else if (/^\w+$/.test(term)) words.set(term.toLowerCase(), cells[0]);
  }
  return { words, names };
}

function identifiersOf(file) {
  if (isCore(file.path)) {
    const code = blankComments(file.text).replace(/^\s*#include[^\n]*/gm, '');
    return code.match(/\b[A-Za-z_]\w*/g) ?? [];
  }
  const found = [];
  walk(parse(file), (node) => {
    if (ts.isIdentifier(node) || ts.isPrivateIdentifier(node)) found.push(node.text);
  });
  return found;
}

/** { path, name, word, term } of every struck word in a name of the product, once per name and file. */
export function struckNames(files, glossary) {
  const { words, names } = struckTerms(glossary);
  return files.flatMap((file) => {
    const found = [...new Set([...(file.text ? identifiersOf(file) : []), file.path.split('/').at(-1)])];
    return found.flatMap((name) => {
      if (isAllowed(file.path, name)) return [];
      const word = names.has(name) ? name : wordsOf(name).find((part) => words.has(part));
      return word ? [{ path: file.path, name, word, term: names.get(word) ?? words.get(word) }] : [];
    });
  });
}

/** One sentence about struck words per file. */
export function struckWords(files, glossary) {
  const byFile = new Map();
  for (const one of struckNames(files, glossary))
    byFile.set(one.path, [...(byFile.get(one.path) ?? []), one]);
  return [...byFile].map(([path, found]) => {
    const list = found.map(({ name, word, term }) => `${name} ("${word}": say ${term})`);
    return `${path} has names that docs/glossary.md strikes: ${list.join(', ')}.`;
  });
}
