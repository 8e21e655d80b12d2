/** What the Test step says in words of its numbers: of a speed-up that is none, and of a tuning that keeps the stiffness. */

import { beforeEach, expect, it, vi } from 'vitest';
import { shortTime } from '../../web/app/controls/numbers';
import { describeSpeedUp, speedUp } from '../../web/app/panels/simulate/speed_up';
import { changeSettings, results, view, wantedKey } from '../../web/app/state/store';
import { haveLattice, twin, usedTuning } from '../../web/app/state/twin';
import { defaultSettings } from '../../web/engine/settings/options';
import { STAGES } from '../../web/engine/stages/stages';
import { cube } from './support/shapes';

// The state of the page asks for the colour scheme.
vi.hoisted(() => vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} })));

beforeEach(() => {
  changeSettings(defaultSettings());
  results.body.value = null;
});

it('a step that is not faster says what limits it', () => {
  const times = (original: number, optimized: number, isSolid = false) => {
    return { original, optimized, haveLattice: isSolid };
  };
  expect(speedUp(times(0.0095, 0.01))).toBe('x0.950');
  expect(speedUp(times(0.0095, 0.01, true))).toBe('none');
  expect(speedUp(times(0.02, 0.01, true))).toBe('x2.00');
  expect(speedUp(times(0, 0, true))).toBe('...');
  expect(describeSpeedUp(times(0.0095, 0.01, true))).toBe('same lattice');
  expect(describeSpeedUp(times(0.00009, 0.0001))).toBe('too few faces');
  for (const plain of [times(0.02, 0.01, true), times(0.0095, 0.01), times(0, 0, true)])
    expect(describeSpeedUp(plain)).toBe('');
  expect(speedUp(times(0, 0))).toBe('...');
});

it('times and speed-ups are shown without exponents', () => {
  expect(speedUp({ original: 2, optimized: 0.001, haveLattice: false })).toBe('x2,000');
  const times = [4e-9, 25.46e-6, 0.9996e-3, 1.914e-3, 0.9996, 1234];
  expect(times.map((time) => shortTime(time).replace('\u00a0', ' '))).toEqual([
    '0.00400 µs',
    '25.5 µs',
    '1.00 ms',
    '1.91 ms',
    '1.00 s',
    '1,230 s',
  ]);
});

it('bodies have an inside as solids of the program alone', () => {
  const inspection = { components: 1, solidComponents: 1 };
  results.body.value = { mesh: cube(), inspection } as never;
  expect(haveLattice.value).toBe(true);
  for (const change of [{ material: 'shell' }, { solver: 'jolt' }, { calibrate: true }] as const) {
    changeSettings({ ...defaultSettings(), ...change });
    expect(haveLattice.value).toBe(false);
  }
  changeSettings(defaultSettings());
  results.body.value = { mesh: cube(), inspection: { ...inspection, solidComponents: 0 } } as never;
  expect(haveLattice.value).toBe(false);
});

it('the trial of a tuned motion is that of the tuning that is used', () => {
  const found = (motion: object | null) => {
    results.tuned.value = { key: wantedKey(STAGES.tuned), tuned: { tuned: { motion } } } as never;
    return usedTuning.value?.tuned.motion;
  };
  view.step.value = 'test';
  changeSettings({ solver: 'jolt' });
  twin.wantsTuned.value = true;
  expect([{ kept: 'untouched' }, null].map(found)).toEqual([{ kept: 'untouched' }, null]);
  found({ kept: 'untouched' });
  twin.wantsTuned.value = false;
  expect(usedTuning.value).toBe(null);
});
