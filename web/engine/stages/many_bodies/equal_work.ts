/** Work on equal inputs is done once: scenes have many bodies of one shape. */

type Numbers = Float32Array | Float64Array | Uint32Array | Int32Array | Uint8Array;

const isNumbers = (value: unknown): value is Numbers => ArrayBuffer.isView(value);

interface Entry {
  inputs: unknown[];
  value: unknown;
}

/** Remembers what pure functions have made of their inputs. Values are shared, so that nobody may change them. */
export class EqualWork {
  private readonly entries = new Map<string, Map<number, Entry[]>>();

  /** `capacity`: inputs that are remembered for each function; the oldest are forgotten first. */
  constructor(private readonly capacity: number) {}

  /**
   * What `compute` made of inputs equal to these, bit by bit, or what it makes now. Inputs are plain data and typed arrays, and all that
   * the value depends on. `name` tells functions apart.
   */
  once<Value>(name: string, inputs: unknown[], compute: () => Value): Value {
    const hash = hashOf(inputs, 0);
    const found = this.find(name, inputs, hash);
    if (found) return found.value as Value;
    const value = compute();
    this.remember(name, { inputs, value }, hash);
    return value;
  }

  /** What is remembered of inputs equal to these; undefined: nothing. */
  known(name: string, inputs: unknown[]): unknown {
    return this.find(name, inputs, hashOf(inputs, 0))?.value;
  }

  /**
   * Remembers what `compute` makes of those of many inputs that are not known yet, without repetition; where it makes an Error,
   * nothing.
   */
  fill(name: string, all: unknown[][], compute: (missing: unknown[][]) => unknown[]): void {
    const missing: { inputs: unknown[]; hash: number }[] = [];
    for (const inputs of all) {
      const hash = hashOf(inputs, 0);
      const isNew = !missing.some((other) => other.hash === hash && areEqual(other.inputs, inputs));
      if (isNew && !this.find(name, inputs, hash)) missing.push({ inputs, hash });
    }
    if (missing.length === 0) return;
    compute(missing.map(({ inputs }) => inputs)).forEach((value, i) => {
      const { inputs, hash } = missing[i];
      if (!(value instanceof Error)) this.remember(name, { inputs, value }, hash);
    });
  }

  private find(name: string, inputs: unknown[], hash: number): Entry | undefined {
    return this.entries
      .get(name)
      ?.get(hash)
      ?.find((entry) => areEqual(entry.inputs, inputs));
  }

  private remember(name: string, entry: Entry, hash: number): void {
    const entries = this.entries.get(name) ?? new Map<number, Entry[]>();
    this.entries.set(name, entries.set(hash, [...(entries.get(hash) ?? []), entry]));
    if (entries.size > this.capacity) entries.delete(entries.keys().next().value!);
  }
}

/** `compute` by way of `work`, where there is any. */
export const onceIn = <Value>(
  work: EqualWork | undefined,
  name: string,
  inputs: unknown[],
  compute: () => Value,
): Value => (work ? work.once(name, inputs, compute) : compute());

/** Of the bits of typed arrays and the text of all else. */
function hashOf(value: unknown, start: number): number {
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

function areEqual(a: unknown, b: unknown): boolean {
  if (Object.is(a, b)) return true;
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null) return false;
  if (isNumbers(a) || isNumbers(b)) return isNumbers(a) && isNumbers(b) && areEqualNumbers(a, b);
  const [left, right] = [Object.entries(a), Object.entries(b)];
  return (
    left.length === right.length &&
    left.every(([name, value], i) => right[i][0] === name && areEqual(value, right[i][1]))
  );
}

/** Numbers of one kind; 0 and -0 differ. */
const areEqualNumbers = (a: Numbers, b: Numbers): boolean =>
  a.constructor === b.constructor && a.length === b.length && a.every((value, i) => Object.is(value, b[i]));
