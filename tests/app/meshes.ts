/** Small meshes as OBJ text for the tests. */

/** A flat sheet of 8 x 8 with parallel prongs of 8 x 0.25, whose relative vibrations have far lower frequencies than those of the sheet. */
export function combObj(): string {
  const statements: string[] = [];
  const numberOf = new Map<string, number>();
  const vertex = (x: number, y: number): number => {
    const position = `v ${x} ${y} 0`;
    if (!numberOf.has(position)) {
      statements.push(position);
      numberOf.set(position, numberOf.size + 1);
    }
    return numberOf.get(position)!;
  };
  const square = (x: number, y: number, height: number): void => {
    const [a, b] = [vertex(x, y), vertex(x + 1, y)];
    const [c, d] = [vertex(x + 1, y + height), vertex(x, y + height)];
    statements.push(`f ${a} ${b} ${c}`, `f ${a} ${c} ${d}`);
  };
  const rows = Array.from({ length: 8 }, (_, y) => [y, y + 0.25])
    .flat()
    .concat(8);
  for (let x = 0; x < 8; x++)
    rows.slice(1).forEach((top, row) => {
      square(x, rows[row], top - rows[row]);
    });
  for (let x = 8; x < 16; x++) for (let y = 1; y < 7; y++) square(x, y, 0.25);
  return `${statements.join('\n')}\n`;
}

/** A wavy sheet of cells x cells squares. */
export function sheetObj(cells: number): string {
  const statements: string[] = [];
  for (let j = 0; j <= cells; j++)
    for (let i = 0; i <= cells; i++) {
      const [x, y] = [i / cells, j / cells];
      statements.push(`v ${x} ${y} ${(0.1 * Math.sin(5 * x) * Math.cos(4 * y)).toFixed(6)}`);
    }
  const at = (i: number, j: number) => j * (cells + 1) + i + 1;
  for (let j = 0; j < cells; j++)
    for (let i = 0; i < cells; i++)
      statements.push(
        `f ${at(i, j)} ${at(i + 1, j)} ${at(i + 1, j + 1)}`,
        `f ${at(i, j)} ${at(i + 1, j + 1)} ${at(i, j + 1)}`,
      );
  return `${statements.join('\n')}\n`;
}
