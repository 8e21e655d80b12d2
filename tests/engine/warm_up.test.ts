import { expect, it, vi } from 'vitest';
import { warmUp } from '../../web/app/worker/warm_up';
import { loadTestCore } from './support/core';

it('warming up measures a result, and releases its handles in the core', async () => {
  const core = await loadTestCore(1);
  const measured = vi.spyOn(core, 'measureQuality');
  const kept = [vi.spyOn(core, 'keepMesh'), vi.spyOn(core, 'keepHistory')];
  const released = [vi.spyOn(core, 'releaseMesh'), vi.spyOn(core, 'releaseHistory')];
  await warmUp(core, () => true);
  expect(measured).toHaveBeenCalled();
  const counts = (spies: typeof kept | typeof released): number[] =>
    spies.map(({ mock }) => mock.calls.length);
  expect(counts(released)).toEqual(counts(kept));
});

it('warming up ends before its next step once there is a request', async () => {
  const core = await loadTestCore(1);
  const modes = vi.spyOn(core, 'findModes');
  const collapsed = vi.spyOn(core, 'simplify');
  await warmUp(core, () => modes.mock.calls.length === 0);
  expect(modes).toHaveBeenCalledOnce();
  expect(collapsed).not.toHaveBeenCalled();
});

it('a failure of the core while it warms up is not reported', async () => {
  const core = await loadTestCore(1);
  vi.spyOn(core, 'findModes').mockImplementation(() => {
    throw new Error('Not enough memory.');
  });
  await expect(warmUp(core, () => true)).resolves.toBeUndefined();
});
