/** Transfers results to the page: arrays are moved, because copying millions of numbers would take the page longer than a frame. */

import { transfer } from 'comlink';

type Numbers = ArrayBufferView & { slice(): ArrayBufferView };

const isNumbers = (value: unknown): value is Numbers =>
  ArrayBuffer.isView(value) && !(value instanceof DataView);

const isPlain = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && Object.getPrototypeOf(value) === Object.prototype;

/** The buffers of the typed arrays in plain data, without duplicates. */
export function buffersOf(value: unknown): ArrayBuffer[] {
  const found = new Set<ArrayBuffer>();
  const look = (part: unknown): void => {
    if (isNumbers(part)) found.add(part.buffer as ArrayBuffer);
    else if (Array.isArray(part)) part.forEach(look);
    else if (isPlain(part)) Object.values(part).forEach(look);
  };
  look(value);
  return [...found];
}

/** A copy of plain data with typed arrays of its own. */
export function copyOf<T>(value: T): T {
  const copies = new Map<unknown, Numbers>();
  const copied = (part: unknown): unknown => {
    if (isNumbers(part)) {
      const copy = copies.get(part) ?? (part.slice() as Numbers);
      copies.set(part, copy);
      return copy;
    }
    if (Array.isArray(part)) return part.map(copied);
    if (!isPlain(part)) return part;
    return Object.fromEntries(Object.entries(part).map(([name, inner]) => [name, copied(inner)]));
  };
  return copied(value) as T;
}

/** The return value of a worker's call for `value`, whose arrays are moved away from the worker. */
export const giveAway = <T extends object>(value: T): T => transfer(value, buffersOf(value));

/** The return value of a worker's call for a copy of `value`, which is not changed. */
export const handOver = <T extends object>(value: T): T => giveAway(copyOf(value));
