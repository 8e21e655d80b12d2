import { expect, it } from 'vitest';
import { parseArguments } from '../../web/cli/arguments';
import type { Arguments } from '../../web/cli/arguments';

const parsed = (words: string): Arguments =>
  parseArguments(`optimize a.glb b.glb ${words}`.split(' ')) as Arguments;

it('takes a repeated pattern for the names of any of them, and the last of other repeated flags', () => {
  const { settings, ratio } = parsed('--mesh a --exclude arm* --mesh b --exclude leg* --ratio .5 --ratio .3');
  expect(settings).toMatchObject({ mesh: 'a|b', exclude: 'arm*|leg*' });
  expect(ratio).toBe(0.3);
});
