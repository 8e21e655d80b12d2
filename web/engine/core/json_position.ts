/** Where a text stops being JSON: ", from line 3, column 7", or '' where the JSON parser does not say it. */
export function describeJsonPosition(text: string, error: unknown): string {
  const found = /position (\d+)/.exec((error as Error).message);
  if (!found) return '';
  const lines = text.slice(0, Number(found[1])).split('\n');
  return `, from line ${lines.length}, column ${lines[lines.length - 1].length + 1}`;
}
