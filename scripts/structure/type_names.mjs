// A type name has one meaning per namespace of the core, and among the exports of the engine, page and command line each.

import ts from 'typescript';
import { visitBlocks } from './cpp_functions.mjs';
import { blankComments, isCore } from './texts.mjs';
import { parse } from './ts_functions.mjs';

const typeHeader =
  /^(?:template\s*<[^]*>\s*)?(?:struct|class|union|enum(?: class| struct)?)\s+(?:alignas\s*\([^)]*\)\s*)?(\w+(?:::\w+)*)(?!\s*<)(?![\w:])/;

/** Names of namespaces and types around a definition; an anonymous namespace counts as the one around it. */
const scopeName = (scope) =>
  scope
    .map((header) => /^namespace\s+([\w:]+)/.exec(header)?.[1] ?? typeHeader.exec(header)?.[1] ?? '')
    .filter(Boolean)
    .join('::');

function cppTypes({ path, text }) {
  const found = [];
  visitBlocks(text, ({ kind, header, scope }) => {
    const name = kind === 'type' && typeHeader.exec(header)?.[1];
    if (name) found.push({ space: scopeName(scope), name, path });
  });
  // Aliases at namespace level start at the beginning of a line.
  const aliases = [...blankComments(text).matchAll(/^using (\w+) =/gm)];
  return [...found, ...aliases.map((match) => ({ space: 'limber', name: match[1], path }))];
}

function tsTypes(file) {
  const product = file.path.split('/').slice(0, 2).join('/');
  return parse(file)
    .statements.filter(
      (node) =>
        (ts.isInterfaceDeclaration(node) ||
          ts.isTypeAliasDeclaration(node) ||
          ts.isClassDeclaration(node) ||
          ts.isEnumDeclaration(node)) &&
        node.modifiers?.some(({ kind }) => kind === ts.SyntaxKind.ExportKeyword),
    )
    .map((node) => ({ space: product, name: node.name?.text ?? 'default', path: file.path }));
}

/** One sentence for every name that is defined in more than one file. */
export function doubleTypeNames(files) {
  const places = new Map();
  for (const file of files.filter(({ text }) => text))
    for (const { space, name, path } of isCore(file.path) ? cppTypes(file) : tsTypes(file)) {
      const key = `${space}: ${name}`;
      places.set(key, new Set(places.get(key)).add(path));
    }
  return [...places]
    .filter(([, paths]) => paths.size > 1)
    .map(([key, paths]) => `The type ${key.replace(': ', '::')} is defined in ${[...paths].join(' and ')}.`);
}
