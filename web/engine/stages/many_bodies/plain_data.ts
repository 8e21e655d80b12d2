/** Hashes and equality of plain data with typed arrays. */

type Numbers = Float32Array | Float64Array | Uint32Array | Int32Array | Uint8Array;

const isNumbers = (value: unknown): value is Numbers => ArrayBuffer.isView(value);

/** Hashes the bits of typed arrays and the text of everything else; `start`: the hash of the preceding values. */
export function hashOf(value: unknown, start: number): number {
  if (isNumbers(value)) return hashOfBytes(value, start);
  if (typeof value !== 'object' || value === null) return hashOfText(String(value), start);
  return Object.entries(value).reduce((hash, [name, own]) => hashOf(own, hashOfText(name, hash)), start);
}

const mixed = (hash: number, word: number): number => {
  const product = Math.imul(hash ^ word, 0x85ebca6b);
  return product ^ (product >>> 15);
};

function hashOfBytes({ buffer, byteOffset, byteLength }: Numbers, start: number): number {
  let hash = mixed(start, byteLength);
  if (byteOffset % 4 === 0 && byteLength % 4 === 0)
    for (const word of new Uint32Array(buffer, byteOffset, byteLength / 4)) hash = mixed(hash, word);
  else for (const byte of new Uint8Array(buffer, byteOffset, byteLength)) hash = mixed(hash, byte);
  return hash;
}

function hashOfText(text: string, start: number): number {
  let hash = mixed(start, text.length);
  for (let i = 0; i < text.length; ++i) hash = mixed(hash, text.charCodeAt(i));
  return hash;
}

/** Bit by bit; 0 and -0 differ. */
export function areEqual(a: unknown, b: unknown): boolean {
  if (Object.is(a, b)) return true;
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null) return false;
  if (isNumbers(a) || isNumbers(b)) return isNumbers(a) && isNumbers(b) && areEqualNumbers(a, b);
  const [left, right] = [Object.entries(a), Object.entries(b)];
  return (
    left.length === right.length &&
    left.every(([name, value], i) => right[i][0] === name && areEqual(value, right[i][1]))
  );
}

const areEqualNumbers = (a: Numbers, b: Numbers): boolean =>
  a.constructor === b.constructor && a.length === b.length && a.every((value, i) => Object.is(value, b[i]));
