// Files that the documents mention must exist.

import { dirname, join } from 'node:path/posix';

const product = /^(?:wasm|web|tests|scripts|docs)\//;

/** Paths in `code` that begin with a folder of the repository, and link targets; without patterns and outputs. */
function pathsOf({ path, text }) {
  const prose = text.replace(/^```[^]*?^```/gm, '');
  const named = [...prose.matchAll(/`([\w./-]+)(?::[^`]*)?`/g)].map((match) => match[1]);
  const linked = [...prose.matchAll(/\]\(([^)#\s:]+)(?:#[^)]*)?\)/g)].map((match) =>
    join(dirname(path), match[1]),
  );
  const isPattern = (name) => /NAME|MESH/.test(name);
  return [...new Set([...named.filter((name) => product.test(name)), ...linked])]
    .map((name) => name.replace(/\/$/, ''))
    .filter((name) => !isPattern(name));
}

/** One sentence for every file or folder that a document names and that is not in `known`. */
export function missingPaths(documents, known) {
  const folders = new Set([...known].flatMap((path) => parentsOf(path)));
  return documents.flatMap((document) =>
    pathsOf(document)
      .filter((path) => !known.has(path) && !folders.has(path))
      .map((path) => `${document.path} names ${path}, which is not there.`),
  );
}

function parentsOf(path) {
  const parent = dirname(path);
  return parent === '.' ? [] : [parent, ...parentsOf(parent)];
}
