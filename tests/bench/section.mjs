// Shared by benchmarks: tables, and writing them into docs/benchmarks.md or another document.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { format, resolveConfig } from 'prettier';
import { wrapProse } from './prose.mjs';

const documents = join(resolve(import.meta.dirname, '..', '..'), 'docs');

const row = (cells) => `| ${cells.join(' | ')} |`;
export const table = (header, rows) =>
  [row(header), row(header.map(() => '---')), ...rows.map(row)].join('\n');

/** Prints what could not be measured. */
export function tellMissing(missing) {
  if (missing.length) console.log(`\nMISSING HERE:\n${missing.map((what) => `- ${what}`).join('\n')}`);
}

/**
 * Replaces the text between the markers of a benchmark, or appends it if there are no markers. `name` is that of the
 * markers and the script; `remark` is a sentence on how it was measured; `document` is a file of docs.
 */
export async function writeSection({ name, title, remark, missing, sections, document = 'benchmarks.md' }) {
  const path = join(documents, document);
  const [begin, end] = [`<!-- ${name}: begin -->`, `<!-- ${name}: end -->`];
  const introduction = [
    `Written by \`node tests/bench/${name}.mjs --write\` on ${cpus().length} x ${cpus()[0].model.trim()}, Node ${process.versions.node}.`,
    remark,
    ...(missing.length ? [`Missing: ${missing.join('; ')}.`] : []),
  ].join(' ');
  const content = wrapProse([begin, `## ${title}`, introduction, ...sections, end].join('\n\n'));
  const found = existsSync(path) ? readFileSync(path, 'utf8') : '# Benchmarks\n';
  const before = found.includes(begin) ? found : `${found.trimEnd()}\n\n${begin}\n${end}\n`;
  const after = `${before.split(begin)[0]}${content}${before.split(end)[1]}`;
  mkdirSync(dirname(path), { recursive: true });
  writeFileSync(path, await format(after, { ...(await resolveConfig(path)), filepath: path }));
  console.log(`wrote docs/${document}`);
}
