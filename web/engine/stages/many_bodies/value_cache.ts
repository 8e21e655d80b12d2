/** A cache of what functions have made of their inputs: scenes have many bodies of one shape. */

import { areEqual, hashOf } from './plain_data';

interface Entry {
  inputs: unknown[];
  value: unknown;
}

/** Remembers what pure functions have made of their inputs. Values are shared, so that nobody may change them. */
export class ValueCache {
  private readonly entries = new Map<string, Map<number, Entry[]>>();

  /** `capacity`: inputs that are remembered for each function, or more where `fill` has more at once; the oldest are forgotten first. */
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
