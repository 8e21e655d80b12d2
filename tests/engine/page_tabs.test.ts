/** A tab in a browser that refuses its store. */

import { expect, it, vi } from 'vitest';
import { ownTab } from '../../web/app/state/tabs';

vi.hoisted(() => {
  const refuse = () => {
    throw new DOMException('The store is refused.', 'SecurityError');
  };
  vi.stubGlobal('sessionStorage', { getItem: refuse, setItem: refuse });
  vi.stubGlobal('navigator', {});
});

it('has a name, and begins without earlier work', async () => {
  expect(await ownTab).toEqual({ id: expect.any(String), source: null });
});
