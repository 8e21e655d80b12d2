/** A cache of function results, since scenes have many bodies of one shape. */

import { areEqual, hashOf } from './plain_data';

interface Entry {
  inputs: unknown[];
  value: unknown;
}

/** Remembers results of pure functions. Values are shared and must not be modified. */
export class ValueCache {
  private readonly entries = new Map<string, Map<number, Entry[]>>();

  /** `capacity`: inputs that are remembered for each function, or more where `fill` has more at once; the oldest are forgotten first. */
  constructor(private readonly capacity: number) {}

  /**
   * The remembered result for inputs equal to these, bit by bit, or that of `compute`. Inputs are plain data and typed arrays, and all that
   * the result depends on. `name` identifies the function.
   */
  once<Value>(name: string, inputs: unknown[], compute: () => Value): Value {
    const hash = hashOf(inputs, 0);
    const found = this.find(name, inputs, hash);
    if (found) return found.value as Value;
    const value = compute();
    this.remember(name, { inputs, value }, hash);
    return value;
  }

  /** The remembered result for inputs equal to these; undefined without one. */
  known(name: string, inputs: unknown[]): unknown {
    return this.find(name, inputs, hashOf(inputs, 0))?.value;
  }

  /**
   * Calls `compute` once with those of many inputs that are not known yet, without duplicates, and remembers its results; an Error
   * is not remembered.
   */
  fill(name: string, all: unknown[][], compute: (missing: unknown[][]) => unknown[]): void {
    const missing: { inputs: unknown[]; hash: number }[] = [];
    for (const inputs of all) {
      const hash = hashOf(inputs, 0);
      const isNew = !missing.some((other) => other.hash === hash && areEqual(other.inputs, inputs));
      if (isNew && !this.find(name, inputs, hash)) missing.push({ inputs, hash });
    }
    if (missing.length === 0) return;
    const capacity = Math.max(this.capacity, missing.length);
    compute(missing.map(({ inputs }) => inputs)).forEach((value, i) => {
      const { inputs, hash } = missing[i];
      if (!(value instanceof Error)) this.remember(name, { inputs, value }, hash, capacity);
    });
  }

  private find(name: string, inputs: unknown[], hash: number): Entry | undefined {
    return this.entries
      .get(name)
      ?.get(hash)
      ?.find((entry) => areEqual(entry.inputs, inputs));
  }

  private remember(name: string, entry: Entry, hash: number, capacity = this.capacity): void {
    const entries = this.entries.get(name) ?? new Map<number, Entry[]>();
    this.entries.set(name, entries.set(hash, [...(entries.get(hash) ?? []), entry]));
    if (entries.size > capacity) entries.delete(entries.keys().next().value!);
  }
}

/** `compute` by way of `cache`, where there is any. */
export const onceIn = <Value>(
  cache: ValueCache | undefined,
  name: string,
  inputs: unknown[],
  compute: () => Value,
): Value => (cache ? cache.once(name, inputs, compute) : compute());
