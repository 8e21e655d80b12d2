/** A table of methods at an equal number of faces, as CSV, Markdown and LaTeX. */

import { cell } from './csv_cell';

export type Value = string | number | null;

export interface Column {
  title: string;
  /** digits behind the point; null: as they are */
  digits: number | null;
}

export interface Table {
  /** what is compared, as one line */
  caption: string;
  /** the first column holds names */
  columns: readonly Column[];
  /** rows[r][c] */
  rows: readonly (readonly Value[])[];
}

const NONE = '–';

/** A value for display: rounded, or a dash where there is none. */
export function shownValue(value: Value, { digits }: Column): string {
  if (value === null || (typeof value === 'number' && !Number.isFinite(value))) return NONE;
  if (typeof value === 'string') return value;
  if (digits === null) return String(value);
  const rounded = value.toFixed(digits);
  // A change that rounds to nothing has no sign.
  return Number(rounded) === 0 ? (0).toFixed(digits) : rounded;
}

/** Numbers in full precision; a header line; RFC 4180. */
export function tableAsCsv({ columns, rows }: Table): string {
  const lines = [columns.map(({ title }) => cell(title)), ...rows.map((row) => row.map(finiteCell))];
  return lines.map((line) => `${line.join(',')}\r\n`).join('');
}

const finiteCell = (value: Value): string =>
  cell(typeof value === 'number' && !Number.isFinite(value) ? null : value);

export function tableAsMarkdown({ caption, columns, rows }: Table): string {
  const line = (cells: string[]): string => `| ${cells.map(markdownText).join(' | ')} |`;
  const rule = `| ${columns.map((_, c) => (c === 0 ? '---' : '---:')).join(' | ')} |`;
  const body = rows.map((row) => line(row.map((value, c) => shownValue(value, columns[c]))));
  const head = line(columns.map(({ title }) => title));
  return `${[markdownText(caption), '', head, rule, ...body].join('\n')}\n`;
}

/** On one line, with the special characters of Markdown and HTML escaped. */
const markdownText = (text: string): string =>
  text.replaceAll(/\s+/g, ' ').replaceAll(/[\\`*_[\]<>|~#$]/g, (mark) => `\\${mark}`);

/** A floating table of the package booktabs. */
export function tableAsLatex({ caption, columns, rows }: Table): string {
  const line = (cells: string[]): string => `    ${cells.join(' & ')} \\\\`;
  const body = rows.map((row) => line(row.map((value, c) => latexText(shownValue(value, columns[c])))));
  return [
    '% \\usepackage{booktabs}',
    '\\begin{table}',
    '  \\centering',
    `  \\caption{${latexText(caption)}}`,
    `  \\begin{tabular}{l${'r'.repeat(columns.length - 1)}}`,
    '    \\toprule',
    line(columns.map(({ title }) => latexText(title))),
    '    \\midrule',
    ...body,
    '    \\bottomrule',
    '  \\end{tabular}',
    '\\end{table}',
    '',
  ].join('\n');
}

const LATEX: Record<string, string> = {
  '\\': '\\textbackslash{}',
  '~': '\\textasciitilde{}',
  '^': '\\textasciicircum{}',
  '<': '\\textless{}',
  '>': '\\textgreater{}',
  '|': '\\textbar{}',
  '"': "''",
  '°': '$^\\circ$',
  [NONE]: '--',
};

/** On one line; a number below 0 has a minus sign and not a hyphen. */
const latexText = (text: string): string =>
  text
    .replaceAll(/\s+/g, ' ')
    .replaceAll(/[\\~^<>|"°–#$%&_{}]/g, (mark) => LATEX[mark] ?? `\\${mark}`)
    .replace(/^-(?=\d)/, '$-$');
