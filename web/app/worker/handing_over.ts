/** Results on the way to the page: arrays are moved, as the page would have to copy millions of numbers between two frames. */

import { transfer } from 'comlink';

type Numbers = ArrayBufferView & { slice(): ArrayBufferView };

const isNumbers = (value: unknown): value is Numbers =>
  ArrayBuffer.isView(value) && !(value instanceof DataView);

const isPlain = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && Object.getPrototypeOf(value) === Object.prototype;

/** A copy of plain data, with the buffers of its typed arrays, which `value` keeps for itself. */
export function copyOf<T>(value: T): { copy: T; buffers: ArrayBuffer[] } {
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
  const copy = copied(value) as T;
  return { copy, buffers: [...copies.values()].map(({ buffer }) => buffer as ArrayBuffer) };
}

/** What a call of the worker returns in place of `value`, which stays as it is. */
export function handOver<T extends object>(value: T): T {
  const { copy, buffers } = copyOf(value);
  return transfer(copy, buffers);
}
