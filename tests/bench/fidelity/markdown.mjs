// Tables in Markdown.

export const row = (cells) => `| ${cells.join(' | ')} |`;
export const table = (header, rows) =>
  [row(header), row(header.map(() => '---')), ...rows.map(row)].join('\n');
export const unique = (values) => [...new Set(values)];
