/** Sizes of memory as they are typed: 512M, 2G, or a number of megabytes. */

import { excerpt } from './words';

const MEGABYTES = { '': 1, M: 1, G: 1024 };
/** The bytes of memory that the core is linked to start with, and the most that WebAssembly can have. */
export const SMALLEST_HEAP = 64 * 2 ** 20;
export const LARGEST_HEAP = 2 ** 32;

/** Throws an Error that names `from`, where the text comes from. */
export function readMegabytes(text: string, from: string): number {
  const found = /^(\d+)(M?|G)$/i.exec(text);
  if (!found) throw new Error(`${from} is ${excerpt(text)}: give a size such as 512M or 2G.`);
  return Number(found[1]) * MEGABYTES[found[2].toUpperCase() as keyof typeof MEGABYTES];
}

/** Bytes that the core may take. Throws an Error as readMegabytes. */
export function coreMemory(text: string, from: string): number {
  const bytes = readMegabytes(text, from) * 2 ** 20;
  if (bytes < SMALLEST_HEAP || bytes > LARGEST_HEAP)
    throw new Error(
      `${from} is ${excerpt(text)}: the core takes from ${SMALLEST_HEAP / 2 ** 20}M to ${LARGEST_HEAP / 2 ** 30}G.`,
    );
  return bytes;
}
