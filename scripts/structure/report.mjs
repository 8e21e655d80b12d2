// Prints the size and coupling of the product as a Markdown table.
// Usage: node scripts/structure/report.mjs

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from '../setup/environment.mjs';
import { wrongDependencies } from './dependencies.mjs';
import { cyclesOf } from './cycles.mjs';
import { struckNames } from './glossary.mjs';
import { modules } from './modules.mjs';
import { folderSizes, functionsOf, lineCount, longFiles, percentile } from './sizes.mjs';
import { readProduct } from './texts.mjs';
import { doubleTypeNames } from './type_names.mjs';

const files = readProduct();
const code = files.filter(({ text }) => text);
const functions = functionsOf(files);

const largest = (entries) => entries.reduce((most, entry) => (entry[1] > most[1] ? entry : most), ['', 0]);
const told = ([name, count]) => `${count} (${name})`;
const where = ({ name, path }) => `${name}, ${path}`;

/** One row per product: lengths and parameters of its functions. */
function functionRows([product, list]) {
  const lengths = list.map(({ length }) => length);
  const parameters = list.map((one) => one.parameters);
  const at = (values) => [0.5, 0.9, 0.99].map((part) => percentile(values, part)).join(' / ');
  return [
    [`${product}: functions`, list.length],
    [`${product}: lines, median / p90 / p99`, at(lengths)],
    [`${product}: longest`, told(largest(list.map((one) => [where(one), one.length])))],
    [`${product}: parameters, median / p90 / p99`, at(parameters)],
    [`${product}: most parameters`, told(largest(list.map((one) => [where(one), one.parameters])))],
    [`${product}: functions of more than 4 parameters`, parameters.filter((count) => count > 4).length],
  ];
}

const sizes = code.map(({ path, text }) => [path, lineCount(text)]);
const glossary = readFileSync(join(root, 'docs', 'glossary.md'), 'utf8');
const rows = [
  ['files of code', code.length],
  ['lines of code', sizes.reduce((sum, [, lines]) => sum + lines, 0)],
  ...Object.entries({ 'C++': functions.core, TypeScript: functions.web }).flatMap(functionRows),
  ['largest file', told(largest(sizes.filter(([path]) => !longFiles[path])))],
  ['files of more than 350 lines', sizes.filter(([path, lines]) => lines > 350 && !longFiles[path]).length],
  ['largest folder', told(largest(Object.entries(folderSizes(files))))],
  ['modules', Object.keys(modules).length],
  ['dependencies that are not allowed', wrongDependencies(files, modules).length],
  ['cycles of includes and imports', cyclesOf(files).length],
  ['files on cycles', cyclesOf(files).flat().length],
  ['names of types that are defined twice', doubleTypeNames(files).length],
  ['names with struck words', struckNames(files, glossary).length],
];
console.log(
  ['| measure | found |', '| --- | --- |', ...rows.map((row) => `| ${row.join(' | ')} |`)].join('\n'),
);
