import { describe, expect, it } from 'vitest';
import { OPTIONS, defaultSettings } from '../../web/engine/settings/options';
import type { Settings } from '../../web/engine/settings/options';
import { changedSettings, readSetting } from '../../web/engine/settings/setting_text';

/** Another value than the default that is allowed. */
function another(key: keyof Settings): unknown {
  const { kind, choices, default: value, max } = OPTIONS[key];
  if (kind === 'choice') return choices!.find((choice) => choice !== value);
  if (kind === 'switch') return true;
  if (kind === 'modes') return [2, 3];
  if (kind === 'numbers') return [0.5, 0.25];
  if (kind === 'pins') return 'low:6+vertices:1,2';
  if (kind === 'colliders') return 'ground:-1+ball:0,1,0,0.5';
  if (kind === 'paint') return '0:IA';
  if (kind === 'name') return '_KEEP +&=';
  return max;
}

describe('settings as text', () => {
  it('are none where all are as they come', () => {
    for (const method of ['limber', 'qem'] as const)
      expect(changedSettings(defaultSettings(method)).map(({ flag }) => flag)).toEqual(
        method === 'limber' ? [] : ['method'],
      );
  });

  it.each(Object.keys(OPTIONS).filter((key) => key !== 'threads') as (keyof Settings)[])(
    '%s comes back as it was',
    (key) => {
      const settings = { ...defaultSettings(), [key]: another(key) };
      const changed = changedSettings(settings).filter((one) => one.key === key);
      expect(changed).toHaveLength(1);
      expect(readSetting(OPTIONS[key], changed[0].text ?? 'on')).toEqual(settings[key]);
    },
  );

  it('keep infinity', () => {
    const [{ text }] = changedSettings({ ...defaultSettings(), p: Infinity });
    expect(text).toBe('inf');
    expect(readSetting(OPTIONS.p, 'inf')).toBe(Infinity);
  });
});
