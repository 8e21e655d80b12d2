import { beforeAll, expect, test } from 'vitest';
import type { Core } from '../../web/engine/core/core';
import { SCENARIOS } from '../../web/engine/core/scenarios';
import { SimulatedBodies } from '../../web/engine/motion/simulated_bodies';
import { simulationOptions } from '../../web/engine/motion/simulation';
import { findPinProblem } from '../../web/engine/motion/pin_problems';
import { defaultSettings } from '../../web/engine/settings/options';
import { loadTestCore } from './support/core';
import { grid } from './support/shapes';

let core: Core;
beforeAll(async () => {
  core = await loadTestCore(1);
});

const sheet = grid(6, 2);
const mesh = { ...sheet, positions: sheet.positions.map((value, i) => (i % 3 === 0 ? 6 : 2) * value) };
const [left, right] = [0, 6].map((x) =>
  Uint32Array.from(
    Array.from({ length: mesh.positions.length / 3 }, (_, v) => v).filter((v) => mesh.positions[3 * v] === x),
  ),
);

/** Whether the core moves any vertex within a few steps. */
function moves(scenario: (typeof SCENARIOS)[number]['name'], pinned: Uint32Array): boolean {
  const settings = { ...defaultSettings(), scenario, seconds: 0.2 };
  const options = simulationOptions({ body: { scale: 1 }, diagonal: Math.hypot(6, 2) }, settings, pinned);
  const bodies = new SimulatedBodies(core, mesh, null, options);
  for (let i = 0; i < 6; i++) bodies.step();
  const positions = bodies.positions(0);
  bodies.end();
  return positions.some((value, i) => Math.abs(value - mesh.positions[i]) > 1e-3);
}

test.each(SCENARIOS.map(({ name }) => name))(
  '%s stands still where its words say so, in the core too',
  (name) => {
    for (const pinned of [left, right, Uint32Array.from([...left, ...right]).sort()])
      expect(findPinProblem(name, mesh, pinned)).toBe(moves(name, pinned) ? null : 'still');
  },
);

test('default pins of a scenario move', () => {
  expect(findPinProblem('twist', mesh, null)).toBeNull();
});

test('pins along the longest side are torn by scenarios that move one half of them', () => {
  const edge = Uint32Array.from(
    Array.from({ length: mesh.positions.length / 3 }, (_, v) => v).filter(
      (v) => mesh.positions[3 * v + 1] === 0,
    ),
  );
  const troubles = SCENARIOS.map(({ name }) => [name, findPinProblem(name, mesh, edge)]);
  expect(troubles).toEqual(SCENARIOS.map(({ name, movesPins }) => [name, movesPins ? 'torn' : null]));
});
