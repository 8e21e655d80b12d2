import { expect, test } from 'vitest';
import { checkSettings, defaultSettings, settingsOf } from '../../web/engine/settings/options';
import type { SettingName } from '../../web/engine/settings/options';
import { PRESET_NAMES, presetChanges, settingsOfPreset } from '../../web/engine/settings/presets';
import { parseArguments } from '../../web/cli/arguments';

test.each(PRESET_NAMES)('preset %s changes something, and all of it is allowed', (name) => {
  const settings = { ...defaultSettings(), ...settingsOfPreset(name) };
  expect(() => checkSettings(settings)).not.toThrow();
  expect(presetChanges(name, defaultSettings()).length).toBeGreaterThan(0);
  expect(presetChanges(name, settings)).toEqual([]);
});

test('a change is the setting with its value before and after', () => {
  expect(presetChanges('mobile', { ...defaultSettings(), compress: 'quantized' })).toEqual([
    { name: 'lods', from: [], to: [0.25, 0.1] },
  ]);
});

test('--preset sets what the page sets, and other flags override it', () => {
  const parsed = parseArguments(['optimize', 'a.obj', 'b.glb', '--preset', 'mobile', '--lods', '0.3']);
  if ('show' in parsed) throw new Error('not a command');
  expect(parsed.settings).toEqual({ ...defaultSettings(), compress: 'quantized', lods: [0.3] });
  expect(() => parseArguments(['optimize', 'a.obj', 'b.glb', '--preset', 'film'])).toThrow(
    '--preset is film: give one of web, mobile, cloth, soft-body, print.',
  );
});

test('the command line takes every setting that a preset has, alone or of what the page simulates', () => {
  const simulated: SettingName[] = ['material'];
  const names = PRESET_NAMES.flatMap((name) => Object.keys(settingsOfPreset(name)) as SettingName[]);
  for (const name of names) expect([...settingsOf('optimize'), ...simulated]).toContain(name);
});
