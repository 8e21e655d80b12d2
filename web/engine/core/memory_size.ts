/** Sizes of memory as they are typed: 512M, 2G, or a number of megabytes. */

import { excerpt } from './words';

const MEGABYTES = { '': 1, M: 1, G: 1024 };
/** megabytes without which the core cannot start, and the most that WebAssembly has */
const CORE = { least: 64, most: 4096 };

/** Throws an Error that names `from`, where the text comes from. */
export function readMegabytes(text: string, from: string): number {
  const found = /^(\d+)(M?|G)$/i.exec(text);
  if (!found) throw new Error(`${from} is ${excerpt(text)}: give a size such as 512M or 2G.`);
  return Number(found[1]) * MEGABYTES[found[2].toUpperCase() as keyof typeof MEGABYTES];
}

/** Bytes that the core may take. Throws an Error as readMegabytes. */
export function coreMemory(text: string, from: string): number {
  const megabytes = readMegabytes(text, from);
  if (megabytes < CORE.least || megabytes > CORE.most)
    throw new Error(
      `${from} is ${excerpt(text)}: the core takes from ${CORE.least}M to ${CORE.most / 1024}G.`,
    );
  return megabytes * 2 ** 20;
}
