// Wraps paragraphs of generated documents into lines of bounded length.

const WIDTH = 130;

/** Whether a word at the start of a line would begin a list, a heading or a quotation. */
const isMark = (word) => /^([-+*>]|#+|\d+[.)])$/.test(word);

/** Breaks `line` at spaces into lines of at most `width` characters; further lines of a list item are indented. */
function wrapLine(line, width) {
  const indent = line.startsWith('- ') ? '  ' : '';
  const lines = [''];
  for (const word of line.split(' ')) {
    const longer = lines.at(-1) === '' ? word : `${lines.at(-1)} ${word}`;
    if (longer.length <= width || lines.at(-1) === '' || isMark(word)) lines[lines.length - 1] = longer;
    else lines.push(indent + word);
  }
  return lines.join('\n');
}

/** Wraps every line of a Markdown text except tables, headings and pictures. */
export const wrapProse = (text, width = WIDTH) =>
  text
    .split('\n')
    .map((line) => (line.length <= width || /^(\||#|!\[|<)/.test(line) ? line : wrapLine(line, width)))
    .join('\n');
