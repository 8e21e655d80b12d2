import { expect, it } from 'vitest';
import { strainOverview } from '../../web/app/worker/strain_overview';
import { loadTestCore } from './support/core';
import { grid, torus } from './support/shapes';

it('the overview ranks each mode of a body of two parts as the core does with all modes', async () => {
  const core = await loadTestCore(1);
  const [first, second] = [torus(), grid(6, 4)];
  const count = first.positions.length / 3;
  const mesh = {
    positions: Float32Array.from([...first.positions, ...second.positions]),
    triangles: Uint32Array.from([...first.triangles, ...second.triangles.map((v) => v + count)]),
  };
  const modes = core.findModes(mesh, {
    ...{ model: 'shell', modeCount: 4, thickness: 0.02, young: 1e6, poisson: 0.3, density: 1000 },
    ...{ unit: 1, direction: -1, pinned: new Uint32Array(), exact: false },
  });
  const { ranks } = strainOverview(core, mesh, modes);
  for (let ordinal = 0; ordinal < modes.modesPerComponent; ordinal++) {
    const options = { ordinals: [ordinal], weights: [1], p: 2, threshold: 0 };
    const { rank } = core.strainGuidance(mesh, modes, options);
    const own = ranks.subarray(ordinal * rank.length, (ordinal + 1) * rank.length);
    expect([...own]).toEqual(Array.from(rank, (value) => Math.round(255 * value)));
  }
});
