/** What is kept of tabs: nothing in a browser that refuses its store, and nothing of tabs that cannot come back. */

import { expect, it, vi } from 'vitest';
import { forgetTexts } from '../../web/app/state/saved_text';
import { ownTab } from '../../web/app/state/tabs';

vi.hoisted(() => {
  const refuse = () => {
    throw new DOMException('The store is refused.', 'SecurityError');
  };
  vi.stubGlobal('sessionStorage', { getItem: refuse, setItem: refuse });
  vi.stubGlobal('navigator', {});
  // The state of the page asks for the colour scheme.
  vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} }));
});

it('a tab without a store has a name, and begins without earlier work', async () => {
  expect(await ownTab).toEqual({ id: expect.any(String), source: null });
});

it('texts of other tabs than the kept ones are removed, and nothing else', () => {
  const texts = new Map(['session-a', 'language', 'session-b', 'session-c'].map((key) => [key, '']));
  const storage = {
    length: texts.size,
    key: (i: number) => [...texts.keys()][i],
    removeItem: (key: string) => void texts.delete(key),
  };
  forgetTexts(storage, 'session-', new Set(['b']));
  expect([...texts.keys()]).toEqual(['language', 'session-b']);
});
