// Finds tables in the output of a benchmark, and compares their numbers.

const cellsOf = (line) => {
  if (/^\s*\|.*\|\s*$/.test(line)) return line.trim().slice(1, -1).split('|');
  return line.includes('\t') ? line.split('\t') : null;
};

/** Rows of cells, from Markdown table lines or tab-separated lines; lines of dashes are skipped. */
export function rowsOf(text) {
  return text
    .split('\n')
    .map(cellsOf)
    .filter((cells) => cells !== null)
    .map((cells) => cells.map((cell) => cell.trim()))
    .filter((cells) => !cells.every((cell) => /^:?-*:?$/.test(cell)));
}

/** The number at the beginning of a cell, also "1,234 ms" and "x1.5"; NaN if there is none. */
export const numberOf = (cell) => {
  const found = /^[x~<]?\s*(-?[\d,]+(?:\.\d+)?(?:e[-+]?\d+)?)/i.exec(cell);
  return found ? Number(found[1].replaceAll(',', '')) : NaN;
};

/**
 * Ratios of the numbers now to those before, by row and column. Rows are known by their first cell, and by which of several with
 * that cell they are.
 */
export function compareRows(before, now) {
  const key = (rows) => {
    const counts = new Map();
    return rows.map(([name]) => {
      const count = counts.get(name) ?? 0;
      counts.set(name, count + 1);
      return `${name}#${count}`;
    });
  };
  const known = new Map(key(before).map((name, i) => [name, before[i]]));
  return key(now).flatMap((name, i) => {
    const old = known.get(name);
    if (!old) return [];
    return now[i].slice(1).flatMap((cell, c) => {
      const [a, b] = [numberOf(old[c + 1] ?? ''), numberOf(cell)];
      if (!Number.isFinite(a) || !Number.isFinite(b) || a === 0 || a === b) return [];
      return [{ row: now[i][0], column: c + 1, before: a, now: b, ratio: b / a }];
    });
  });
}
