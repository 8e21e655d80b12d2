// Finds the functions of a TypeScript file in the compiler's syntax tree: { name, line, length, parameters, isExported }.

import ts from 'typescript';

export const parse = ({ path, text }) =>
  ts.createSourceFile(
    path,
    text,
    ts.ScriptTarget.Latest,
    true,
    path.endsWith('x') ? ts.ScriptKind.TSX : ts.ScriptKind.TS,
  );

/** Calls `visit` for every node. */
export function walk(node, visit) {
  visit(node);
  ts.forEachChild(node, (child) => walk(child, visit));
}

const isExportedStatement = (node) =>
  ts.canHaveModifiers(node) &&
  (ts.getModifiers(node) ?? []).some(({ kind }) => kind === ts.SyntaxKind.ExportKeyword);

/** The name of a function, or of the variable or property that it is assigned to. */
function nameOf(node) {
  if (node.name) return node.name.getText();
  const { parent } = node;
  const isNamed =
    ts.isVariableDeclaration(parent) || ts.isPropertyAssignment(parent) || ts.isPropertyDeclaration(parent);
  return isNamed ? parent.name.getText() : ts.isConstructorDeclaration(node) ? 'constructor' : '(anonymous)';
}

function isExported(node) {
  if (ts.isFunctionDeclaration(node)) return isExportedStatement(node);
  const statement = node.parent?.parent?.parent;
  return Boolean(
    statement &&
    ts.isVariableDeclaration(node.parent) &&
    ts.isVariableStatement(statement) &&
    isExportedStatement(statement),
  );
}

/** The lines of `source` that contain more than comments. */
function codeLines(source, node) {
  const lines = new Set();
  walk(node, (inner) => {
    if (inner.getChildCount(source) > 0) return;
    lines.add(source.getLineAndCharacterOfPosition(inner.getStart(source)).line);
    lines.add(source.getLineAndCharacterOfPosition(inner.getEnd()).line);
  });
  lines.add(source.getLineAndCharacterOfPosition(node.getEnd()).line);
  return lines.size;
}

/** All functions with a body: declarations, methods, accessors, function expressions and arrow functions. */
export function tsFunctions(file) {
  const source = parse(file);
  const found = [];
  walk(source, (node) => {
    if (!ts.isFunctionLike(node) || !node.body) return;
    found.push({
      path: file.path,
      name: nameOf(node),
      line: source.getLineAndCharacterOfPosition(node.getStart(source)).line + 1,
      length: codeLines(source, node),
      parameters: node.parameters.length,
      isExported: isExported(node),
      isExcused: false,
    });
  });
  return found;
}
