// What samples bring along, and what is left of it when another model is opened.

import { expect, test, vi } from 'vitest';
import { MATERIALS } from '../../web/engine/settings/materials';
import { checkSettings, defaultSettings } from '../../web/engine/settings/options';
import { afterSample, wantedOfSample } from '../../web/app/state/samples/sample_settings';

// The state of the page asks for the colour scheme.
vi.hoisted(() => vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} })));

const own = { ...defaultSettings(), qualityWeight: 0.3, pins: 'low:6', solver: 'jolt' } as const;

test('the cloth opens as cotton that hangs by its corners, with what else was set', () => {
  const { settings } = wantedOfSample('cloth.glb', own)!;
  checkSettings(settings);
  expect(settings).toMatchObject({
    ...MATERIALS.cotton,
    scenario: 'hang',
    solver: 'none',
    qualityWeight: 0.3,
  });
  expect(wantedOfSample('bar.glb', own)).toBeUndefined();
});

test('the tower sways as a whole, with what else was set', () => {
  const { settings } = wantedOfSample('tower.glb', { ...own, pins: '' })!;
  checkSettings(settings);
  expect(settings).toMatchObject({ scenario: 'sway', young: own.young, pins: '', qualityWeight: 0.3 });
  expect(afterSample('tower.glb', settings)).toEqual({ scenario: defaultSettings().scenario });
});

test('the next model starts without what the sample has brought, unless it was changed', () => {
  const { settings } = wantedOfSample('cloth.glb', own)!;
  const { young, thickness, scenario } = defaultSettings();
  expect(afterSample('cloth.glb', settings)).toMatchObject({ young, thickness, scenario });
  expect(afterSample('cloth.glb', { ...settings, scenario: 'wind' })).not.toHaveProperty('scenario');
  expect(afterSample('shirt.glb', settings)).toEqual({});
  expect(afterSample(undefined, settings)).toEqual({});
});
