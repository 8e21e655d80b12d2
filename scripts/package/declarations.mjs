// The declarations of the library: those of tsc that the library's own entry reaches, with endings in their imports.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import ts from 'typescript';

/** Copies `entry` (below `from`) and every declaration that it leads to into `to`. Imports get the ending that Node requires. */
export function copyDeclarations(from, entry, to) {
  const open = [join(from, entry)];
  const done = new Set(open);
  for (let path = open.pop(); path; path = open.pop()) {
    const text = readFileSync(path, 'utf8');
    const { importedFiles } = ts.preProcessFile(text, true, true);
    let written = text;
    // From the end, so that earlier positions stay true.
    for (const { fileName, pos, end } of importedFiles.toSorted((a, b) => b.pos - a.pos)) {
      if (!fileName.startsWith('.')) continue;
      const target = join(dirname(path), `${fileName}.d.ts`);
      if (!existsSync(target)) throw new Error(`${path} imports ${fileName}, which has no declaration.`);
      if (!done.has(target)) open.push(target);
      done.add(target);
      // The positions are those of the quotes in some versions of TypeScript, of the text between them in others.
      const at = text.indexOf(fileName, pos);
      if (at < 0 || at > end)
        throw new Error(`${path}: the import of ${fileName} is not where it should be.`);
      written = `${written.slice(0, at)}${fileName}.js${written.slice(at + fileName.length)}`;
    }
    const copy = join(to, relative(from, path));
    mkdirSync(dirname(copy), { recursive: true });
    writeFileSync(copy, written);
  }
}
