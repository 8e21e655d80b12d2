/** Refuses text files in UTF-16 or UTF-32: text is read as UTF-8. */

/** The number of bytes at the start that are examined. */
const LOOKED_AT = 64;

/** Throws an Error with one sentence where the bytes are text with two or four bytes a character. */
export function checkEncoding(name: string, bytes: Uint8Array): void {
  if (hasWideMark(bytes) || hasWideLetters(bytes))
    throw new Error(`${name} is text in UTF-16 or UTF-32: save it as UTF-8.`);
}

/** The byte order mark FF FE or FE FF. */
const hasWideMark = ([first, second]: Uint8Array): boolean =>
  (first === 0xff && second === 0xfe) || (first === 0xfe && second === 0xff);

/** Whether every other byte is 0 and the ones in between are letters, digits or blanks. */
function hasWideLetters(bytes: Uint8Array): boolean {
  const start = bytes.subarray(0, Math.min(LOOKED_AT, bytes.length - (bytes.length % 2)));
  if (start.length < 8) return false;
  const isText = (byte: number) => (byte >= 0x20 && byte < 0x7f) || [0x09, 0x0a, 0x0d].includes(byte);
  return [0, 1].some((offset) => start.every((byte, at) => (at % 2 === offset ? isText(byte) : byte === 0)));
}
