import { beforeAll, expect, test } from 'vitest';
import type { TwinSetup } from '../../web/app/worker/simulation_protocol';
import { standingSetup } from '../../web/app/worker/standing_setup';
import { twinOptions } from '../../web/app/worker/twin_options';
import type { Core } from '../../web/engine/core/core';
import { rotated, rotationOf } from '../../web/engine/motion/scene_rotation';
import { Twin } from '../../web/engine/motion/twin';
import { defaultSettings } from '../../web/engine/settings/options';
import { STAGES } from '../../web/engine/stages/stages';
import { loadTestCore } from './support/core';
import { runOfMesh } from './support/runs';
import { grid } from './support/shapes';

let core: Core;
beforeAll(async () => {
  core = await loadTestCore(1);
});

/** As exporters write it where z is up. */
const Z_UP = rotationOf([1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1])!;
const settings = { ...defaultSettings(), scenario: 'drop' as const, material: 'shell' as const, seconds: 1 };

function setupOf(rotation: TwinSetup['rotation']): TwinSetup {
  const run = runOfMesh(core, grid(8, 8));
  const { mesh: original, diagonal } = run.get(STAGES.prepared, settings);
  const result = run.get(STAGES.level, { ...settings, targetFaces: 64 });
  const size = { body: { scale: 1 }, diagonal };
  const rest = { meshKey: '', pinned: null, tuned: null, noise: 'always' as const };
  return { ...rest, number: 1, original, result, size, rotation, settings };
}

/** How far the original has fallen after some steps, along the axes of its own mesh. */
function fall(rotation: TwinSetup['rotation']): number[] {
  const setup = standingSetup(setupOf(rotation));
  const { diagonal } = setup.size;
  const twin = new Twin(core, setup.original, setup.result, {
    ...twinOptions(setup),
    diagonal,
    measuresNoise: false,
  });
  const before = rotated(twin.positions('original'), rotation, true);
  for (let i = 0; i < 6; i++) twin.step();
  const after = rotated(twin.positions('original'), rotation, true);
  twin.end();
  const sums = [0, 0, 0];
  after.forEach((value, i) => (sums[i % 3] += value - before[i]));
  return sums.map((value) => (3 * value) / after.length / diagonal);
}

test('bodies fall along y, and where their node makes z up they fall along z', () => {
  const [x, y, z] = fall(null);
  expect(y).toBeLessThan(-1e-3);
  expect(Math.abs(x) + Math.abs(z)).toBeLessThan(-0.05 * y);
  const [a, b, c] = fall(Z_UP);
  expect(c).toBeLessThan(-1e-3);
  expect(Math.abs(a) + Math.abs(b)).toBeLessThan(-0.05 * c);
});

test('a setup without a rotation keeps its meshes unchanged', () => {
  const setup = setupOf(null);
  expect(standingSetup(setup).original.positions).toBe(setup.original.positions);
});
