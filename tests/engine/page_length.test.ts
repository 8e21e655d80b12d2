/** What the page says of the size of a model. */

import { expect, it, vi } from 'vitest';
import { lengthWords, likelierUnit } from '../../web/app/panels/model/length';

vi.hoisted(() => vi.stubGlobal('navigator', { languages: ['en'] }));

it('a length has the unit that it is read in', () => {
  expect([0.0042, 0.5, 1.756, 175.6, 1234].map(lengthWords)).toEqual([
    '4.20\u00a0mm',
    '50.0\u00a0cm',
    '1.76\u00a0m',
    '176\u00a0m',
    '1,230\u00a0m',
  ]);
});

it('another unit is asked about where it alone gives a usual size', () => {
  const nameOf = (size: number, unit: number) => likelierUnit(size, unit)?.name ?? null;
  expect(nameOf(1.8, 1)).toBeNull();
  expect(nameOf(175.6, 1)).toBe('centimetres');
  expect(nameOf(175.6, 0.01)).toBeNull();
  expect(nameOf(9000, 1)).toBe('millimetres');
  expect(nameOf(0.9, 0.001)).toBe('metres');
  expect([nameOf(1e6, 1), nameOf(0.001, 1)]).toEqual([null, null]);
});
