/** Small meshes as OBJ text, made for the tests. */

/** A wavy sheet of cells x cells squares. */
export function sheetObj(cells: number): string {
  const lines: string[] = [];
  for (let j = 0; j <= cells; j++)
    for (let i = 0; i <= cells; i++) {
      const [x, y] = [i / cells, j / cells];
      lines.push(`v ${x} ${y} ${(0.1 * Math.sin(5 * x) * Math.cos(4 * y)).toFixed(6)}`);
    }
  const at = (i: number, j: number) => j * (cells + 1) + i + 1;
  for (let j = 0; j < cells; j++)
    for (let i = 0; i < cells; i++)
      lines.push(
        `f ${at(i, j)} ${at(i + 1, j)} ${at(i + 1, j + 1)}`,
        `f ${at(i, j)} ${at(i + 1, j + 1)} ${at(i, j + 1)}`,
      );
  return `${lines.join('\n')}\n`;
}
