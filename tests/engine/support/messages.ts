/** Collects what the page says from its source, and literals that it shows without the message table. */

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import ts from 'typescript';

const root = join(import.meta.dirname, '..', '..', '..');

export interface Messages {
  /** English sentence -> where it is said, as path:line */
  keys: Map<string, string>;
  /** the singular and the other form of numbers of things */
  numbers: [one: string, other: string][];
  /** "path:line: literal" of each literal that is shown without the message table */
  bare: string[];
}

/** What controls and tables call their words. */
const WORD_NAMES = new Set(['text', 'title', 'label', 'hint', 'name', 'what', 'low', 'high']);
const SHOWN_ATTRIBUTES = new Set(['title', 'aria-label', 'aria-valuetext', 'placeholder', 'alt']);
/** Members of tables that are no words. */
const NO_WORDS = new Set(['value', 'picture', 'id', 'kind', 'ending', 'type']);

const hasWords = (literal: string): boolean =>
  /[A-Za-z].*[A-Za-z]/.test(literal) && !/^#[\da-f]{6}$/.test(literal);

export function collectMessages(): Messages {
  const found: Messages = { keys: new Map(), numbers: [], bare: [] };
  const app = join(root, 'web', 'app');
  const names = readdirSync(app, { recursive: true, encoding: 'utf8' }).filter((name) =>
    /\.tsx?$/.test(name),
  );
  for (const name of names.sort()) {
    if (name.startsWith('language')) continue;
    const path = join('web', 'app', name);
    const source = readFileSync(join(root, path), 'utf8');
    const kind = path.endsWith('x') ? ts.ScriptKind.TSX : ts.ScriptKind.TS;
    new Collector(ts.createSourceFile(path, source, ts.ScriptTarget.Latest, true, kind), found).visit();
  }
  return found;
}

class Collector {
  constructor(
    private readonly file: ts.SourceFile,
    private readonly found: Messages,
  ) {}

  visit(node: ts.Node = this.file): void {
    this.collectCall(node);
    this.collectMember(node);
    this.collectTable(node);
    this.collectBare(node);
    ts.forEachChild(node, (child) => this.visit(child));
  }

  private add(node: ts.Node | undefined): void {
    if (!node || !ts.isStringLiteralLike(node) || !hasWords(node.text)) return;
    if (!this.found.keys.has(node.text)) this.found.keys.set(node.text, this.placeOf(node));
  }

  private placeOf(node: ts.Node): string {
    const { line } = this.file.getLineAndCharacterOfPosition(node.getStart());
    return `${this.file.fileName}:${line + 1}`;
  }

  private collectCall(node: ts.Node): void {
    if (!ts.isCallExpression(node)) return;
    const name = node.expression.getText();
    if (name === 'say') this.add(node.arguments[0]);
    if (name !== 'sayCounted' && name !== 'several') return;
    const [, one, other] = node.arguments;
    this.add(other);
    if (ts.isStringLiteralLike(one) && ts.isStringLiteralLike(other))
      this.found.numbers.push([one.text, other.text]);
  }

  /** The words that a control is given, and those of tables, which are said by what shows them. */
  private collectMember(node: ts.Node): void {
    if (ts.isJsxAttribute(node) && WORD_NAMES.has(node.name.getText())) {
      const isControl = /^[A-Z]/.test(node.parent.parent.tagName.getText());
      if (isControl && !this.isSetting(node)) this.add(node.initializer);
    }
    if (ts.isPropertyAssignment(node) && ['text', 'title', 'label', 'what'].includes(node.name.getText()))
      this.add(node.initializer);
  }

  /** `name` of these components is that of a setting. */
  private isSetting(node: ts.JsxAttribute): boolean {
    return node.parent.parent.tagName.getText() === 'SettingRange';
  }

  /** Constants in capitals are tables of words. */
  private collectTable(node: ts.Node): void {
    if (!ts.isVariableDeclaration(node) || !/panels|setting_words/.test(this.file.fileName)) return;
    if (node.name.getText() === 'rows') return this.collectRows(node);
    if (!/^[A-Z_]+$/.test(node.name.getText()) || !node.initializer) return;
    const walk = (part: ts.Node): void => {
      if (ts.isPropertyAssignment(part) && NO_WORDS.has(part.name.getText())) return;
      if (ts.isCallExpression(part) || ts.isArrowFunction(part) || ts.isTypeNode(part)) return;
      this.add(part);
      ts.forEachChild(part, walk);
    };
    walk(node.initializer);
  }

  /** Rows of facts have a name each. */
  private collectRows({ initializer }: ts.VariableDeclaration): void {
    if (!initializer || !ts.isArrayLiteralExpression(initializer)) return;
    for (const row of initializer.elements) if (ts.isArrayLiteralExpression(row)) this.add(row.elements[0]);
  }

  private collectBare(node: ts.Node): void {
    if (ts.isJsxText(node)) this.reject(node, node.text);
    if (ts.isJsxAttribute(node) && SHOWN_ATTRIBUTES.has(node.name.getText())) {
      const isElement = /^[a-z]/.test(node.parent.parent.tagName.getText());
      if (isElement && node.initializer) this.rejectLiterals(node.initializer);
    }
    if (ts.isJsxExpression(node) && node.expression && !ts.isJsxAttribute(node.parent))
      this.rejectLiterals(node.expression);
  }

  /** Literals that an expression yields, apart from arguments of calls and conditions. */
  private rejectLiterals(node: ts.Node): void {
    if (ts.isCallExpression(node) || ts.isBinaryExpression(node) || ts.isJsxElement(node)) return;
    if (ts.isStringLiteralLike(node)) return this.reject(node, node.text);
    if (ts.isTemplateExpression(node))
      this.reject(
        node,
        [node.head, ...node.templateSpans.map(({ literal }) => literal)].map(({ text }) => text).join(' '),
      );
    if (ts.isConditionalExpression(node)) {
      this.rejectLiterals(node.whenTrue);
      return this.rejectLiterals(node.whenFalse);
    }
    ts.forEachChild(node, (child) => this.rejectLiterals(child));
  }

  private reject(node: ts.Node, literal: string): void {
    const words = literal.replaceAll(/\s+/g, ' ').trim();
    if (hasWords(words)) this.found.bare.push(`${this.placeOf(node)}: ${words}`);
  }
}
