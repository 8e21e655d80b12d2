/** The store of what was done to files: found by content, bounded, and empty where it is damaged. */

import { expect, it, vi } from 'vitest';
import { contentKey, forgetWork, keepWork, readWork } from '../../web/app/state/work/kept_work';

// The state of the page asks for the colour scheme.
vi.hoisted(() => vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} })));

/** `room`: characters after which it is full. */
function storage(room = Infinity) {
  const texts = new Map<string, string>();
  return {
    texts,
    get length() {
      return texts.size;
    },
    key: (i: number) => [...texts.keys()][i],
    getItem: (key: string) => texts.get(key) ?? null,
    removeItem: (key: string) => void texts.delete(key),
    setItem: (key: string, text: string) => {
      const size = [...texts.values()].reduce((sum, one) => sum + one.length, text.length);
      if (size > room) throw new DOMException('full', 'QuotaExceededError');
      texts.set(key, text);
    },
  };
}

const file = (name: string, ...bytes: number[]) => ({ name, bytes: Uint8Array.from(bytes) });

it('a file is recognised by its bytes, whatever its name and its position among others', async () => {
  const key = await contentKey([file('a.gltf', 1), file('a.bin', 2, 3)]);
  expect(await contentKey([file('b.bin', 2, 3), file('b.gltf', 1)])).toBe(key);
  expect(await contentKey([file('a.gltf', 1), file('a.bin', 2, 4)])).not.toBe(key);
  expect(await contentKey([])).toBeNull();
  const huge = { name: 'a', bytes: { length: 5e8 } as Uint8Array };
  expect(await contentKey([huge])).toBeNull();
});

it('nothing is kept in a browser without digests', async () => {
  vi.stubGlobal('crypto', {});
  expect(await contentKey([file('a', 1)])).toBeNull();
  vi.unstubAllGlobals();
});

it('kept work is read and forgotten by its key', () => {
  const store = storage();
  keepWork(store, 'a', { link: 'pins=low%3A6&faces=9', at: 1 });
  expect(readWork(store, 'a')).toMatchObject({ settings: { pins: 'low:6' }, faces: 9 });
  expect(readWork(store, 'b')).toBeNull();
  forgetWork(store, 'a');
  expect([readWork(store, 'a'), store.texts.size]).toEqual([null, 0]);
});

it.each(['', '{}', '[]', 'null', '{"at":1,"link":5}', '{"at":1,"link":"pins=left"}', '{"at":1,"link":""}'])(
  'the damaged text %j is nothing, and gives way first',
  (text) => {
    const store = storage();
    store.texts.set('limber-work-a', text);
    expect(readWork(store, 'a')).toBeNull();
    for (let i = 0; i < 50; ++i) keepWork(store, String(i), { link: 'faces=9', at: 10 + i });
    expect([store.texts.has('limber-work-a'), readWork(store, '0')?.faces]).toEqual([false, 9]);
  },
);

it('the last 50 files and at most a million characters are kept', () => {
  const store = storage();
  store.texts.set('other', 'x');
  for (let i = 0; i < 60; ++i) keepWork(store, String(i), { link: 'faces=9', at: i });
  expect([store.texts.size, store.texts.has('limber-work-9'), store.texts.has('limber-work-10')]).toEqual([
    51,
    false,
    true,
  ]);
  keepWork(store, 'large', { link: `faces=9&x=${'1'.repeat(999_900)}`, at: 99 });
  expect([...store.texts.keys()].length).toBeLessThan(20);
  keepWork(store, 'large', { link: 'x'.repeat(1_000_001), at: 100 });
  expect([store.texts.has('limber-work-large'), store.texts.has('other')]).toEqual([false, true]);
});

it('if the store is full, the oldest entries are removed; without any an error is reported', () => {
  const store = storage(100);
  keepWork(store, 'a', { link: `x=${'1'.repeat(40)}`, at: 1 });
  keepWork(store, 'b', { link: `x=${'1'.repeat(40)}`, at: 2 });
  expect([...store.texts.keys()]).toEqual(['limber-work-b']);
  expect(() => keepWork(store, 'c', { link: 'x'.repeat(100), at: 3 })).toThrow('full');
});
