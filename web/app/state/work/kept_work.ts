/** The stored work on files, each as the text of a link, keyed by the content of the file. It is checked when read, because it may be damaged. */

import type { SourceFile } from '../../../engine/document/open';
import { readLink } from '../link';
import type { Wanted } from '../link';

type Store = Pick<Storage, 'length' | 'key' | 'getItem' | 'setItem' | 'removeItem'>;

const PREFIX = 'limber-work-';
const MAX_FILES = 50;
/** Of all files together; the browser has room for some five million, which the open tabs need too. */
const MAX_CHARACTERS = 1e6;
/** In bytes; the work on larger files is not kept. */
const LARGEST = 400e6;

/** A key for files from their bytes, independent of their names; null if they are too large or the browser cannot compute a digest. Never throws. */
export async function contentKey(files: readonly SourceFile[]): Promise<string | null> {
  if (files.length === 0 || files.reduce((sum, { bytes }) => sum + bytes.length, 0) > LARGEST) return null;
  try {
    const digests: string[] = [];
    for (const { bytes } of files) digests.push(await digestOf(bytes));
    return await digestOf(new TextEncoder().encode(digests.sort().join()));
  } catch {
    return null;
  }
}

async function digestOf(bytes: Uint8Array): Promise<string> {
  const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes as BufferSource));
  return [...digest].map((byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** The work on the file of this key; null if nothing is stored. */
export function readWork(store: Store, key: string): Wanted | null {
  try {
    return readLink(entryOf(store, PREFIX + key).link);
  } catch {
    return null;
  }
}

export const forgetWork = (store: Store, key: string): void => store.removeItem(PREFIX + key);

/** Stores the text of a link; the least recently used work is evicted. `at`: ms since 1970. */
export function keepWork(store: Store, key: string, { link, at }: { link: string; at: number }): void {
  forgetWork(store, key);
  if (link.length > MAX_CHARACTERS) return;
  const others = othersByAge(store);
  let characters = others.reduce((sum, { size }) => sum + size, link.length);
  const drop = (): void => {
    const { name, size } = others.pop()!;
    store.removeItem(name);
    characters -= size;
  };
  while (others.length >= MAX_FILES || characters > MAX_CHARACTERS) drop();
  for (;;) {
    try {
      return store.setItem(PREFIX + key, JSON.stringify({ at, link }));
    } catch (error) {
      if (others.length === 0) throw error;
      drop();
    }
  }
}

/** The newest first. */
function othersByAge(store: Store): { name: string; at: number; size: number }[] {
  const names = Array.from({ length: store.length }, (_, i) => store.key(i) ?? '');
  const entries = names
    .filter((name) => name.startsWith(PREFIX))
    .map((name) => {
      const { at, link } = entryOf(store, name);
      return { name, at, size: link.length };
    });
  return entries.sort((a, b) => b.at - a.at);
}

/** An entry that cannot be read counts as empty and old. */
function entryOf(store: Store, name: string): { at: number; link: string } {
  try {
    const entry = JSON.parse(store.getItem(name) ?? '') as { at?: unknown; link?: unknown };
    if (typeof entry.at === 'number' && typeof entry.link === 'string')
      return { at: entry.at, link: entry.link };
  } catch {
    // see above
  }
  return { at: 0, link: '' };
}
