// Finds the functions of a C++ file by their braces: { name, line, length, parameters, isExported }.

import { blankComments, lineAt } from './texts.mjs';

const isNamespace = /^(?:inline )?namespace\b|^extern\b\s*$/;
const isType = /^(?:template\s*<[^]*>\s*)?(?:typedef )?(?:struct|class|union|enum)\b[^()=]*$/;

/** Removes `template <…>`, so that the first parenthesis is that of the parameters. */
function withoutTemplate(header) {
  let rest = header.trim();
  while (rest.startsWith('template')) {
    let depth = 0;
    let end = rest.indexOf('<');
    do {
      if (rest[end] === '<') ++depth;
      if (rest[end] === '>') --depth;
      ++end;
    } while (depth > 0 && end < rest.length);
    rest = rest.slice(end).trim();
  }
  return rest;
}

/** The offset at which the parenthesis opened at `start` closes. */
function closingOf(text, start) {
  let depth = 0;
  for (let at = start; at < text.length; ++at) {
    if (text[at] === '(') ++depth;
    if (text[at] === ')' && --depth === 0) return at;
  }
  return text.length;
}

/** The number of parameters between two parentheses: commas outside of brackets, plus one. */
function countParameters(list) {
  if (/^\s*(void)?\s*$/.test(list)) return 0;
  let depth = 0;
  let count = 1;
  for (const sign of list.replaceAll('->', '').replaceAll('<=', '').replaceAll('>=', '')) {
    if ('(<[{'.includes(sign)) ++depth;
    if (')>]}'.includes(sign)) --depth;
    if (sign === ',' && depth === 0) ++count;
  }
  return count;
}

/** { name, parameters } of the text before a body, or undefined if it is not a function. */
export function readSignature(header) {
  const text = withoutTemplate(header);
  const match = /(operator\s*(?:\(\)|[^\s\w(]+|[\w:<> ]+)|~?[\w:]+(?:<[^()]*>)?)\s*\(/.exec(
    text.replace(/\b(alignas|decltype|noexcept|__attribute__)\s*\((?:[^()]|\([^()]*\))*\)/g, (found) =>
      ' '.repeat(found.length),
    ),
  );
  if (!match) return undefined;
  const open = match.index + match[0].length - 1;
  return {
    name: match[1].split('::').at(-1),
    parameters: countParameters(text.slice(open + 1, closingOf(text, open))),
  };
}

function kindOf(header, before) {
  const text = header.trim();
  if (isNamespace.test(text)) return 'namespace';
  if (isType.test(text)) return 'type';
  if (/^concept\b/.test(withoutTemplate(text))) return 'value';
  // `members_{…}` and `= {…}` are values: a body follows a space and never an equals sign.
  if (/\w/.test(before) || /[=,(]$/.test(text) || !text.includes('(')) return 'value';
  return 'function';
}

const isBlank = (line) => !line.trim();

/** Lines of code from the first line of the signature to the closing brace; empty lines and comments do not count. */
const codeLines = (blanked, start, end) =>
  blanked
    .slice(start, end)
    .split('\n')
    .filter((line) => !isBlank(line)).length;

/** Replaces preprocessor lines by spaces. */
const withoutDirectives = (text) =>
  text.replace(/^[ \t]*#(?:[^\n]*\\\n)*[^\n]*/gm, (found) => found.replace(/[^\n]/g, ' '));

/** Calls `visit({ kind, header, start, open, end, scope })` for every brace outside of functions, when it closes. */
export function visitBlocks(text, visit) {
  const blanked = withoutDirectives(blankComments(text));
  const stack = [];
  let start = 0;
  for (let at = 0; at < blanked.length; ++at) {
    const sign = blanked[at];
    const inside = stack.at(-1)?.kind;
    if (sign === '{') {
      const header = blanked.slice(start, at);
      const isHidden = inside === 'function' || inside === 'value';
      const kind = isHidden ? 'value' : kindOf(header, blanked[at - 1] ?? '');
      const first = start + (header.length - header.trimStart().length);
      stack.push({ kind, header: header.trim(), start: first, open: at, isHidden, outer: start });
      if (kind !== 'value') start = at + 1;
    } else if (sign === '}') {
      const block = stack.pop();
      if (!block) return;
      if (!block.isHidden)
        visit({ ...block, end: at + 1, scope: stack.map(({ header }) => header), blanked });
      if (block.kind !== 'value') start = at + 1;
    } else if (sign === ';' && inside !== 'function' && inside !== 'value') start = at + 1;
    // An access label ends the text before it.
    else if (sign === ':' && /(public|private|protected)\s*$/.test(blanked.slice(start, at))) start = at + 1;
  }
}

/** All functions with a body, including members; lines of a lambda count as those of the function around it. */
export function cppFunctions({ path, text }, header = '') {
  const found = [];
  const declared = blankComments(header);
  visitBlocks(text, ({ kind, header: signature, start, end, scope, blanked }) => {
    if (kind !== 'function') return;
    const read = readSignature(signature);
    if (!read) return;
    const isMember = scope.some((outer) => isType.test(outer)) || /\w::~?\w+\s*\(/.test(signature);
    const isHidden = scope.some((outer) => /^namespace\s*$/.test(outer)) || /^static\b/.test(signature);
    const isDeclared =
      path.endsWith('.h') || new RegExp(`\\b${read.name.replace(/\W/g, '\\$&')}\\s*\\(`).test(declared);
    found.push({
      path,
      ...read,
      line: lineAt(text, start),
      length: codeLines(blanked, start, end),
      isExported: !isMember && !isHidden && isDeclared,
      isExcused: /Long because/.test(
        text
          .slice(Math.max(0, start - 600), start)
          .split(/^}/m)
          .at(-1),
      ),
    });
  });
  return found;
}
