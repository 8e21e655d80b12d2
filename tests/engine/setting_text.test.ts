import { describe, expect, it } from 'vitest';
import { OPTIONS, defaultSettings } from '../../web/engine/settings/options';
import type { OptionSpec, Settings } from '../../web/engine/settings/options';
import { changedSettings, describeRenamedChoices, readSetting } from '../../web/engine/settings/setting_text';

/** An allowed value other than the default. */
function another(key: keyof Settings): unknown {
  const option: OptionSpec = OPTIONS[key];
  switch (option.kind) {
    case 'choice':
      return option.choices.find((choice) => choice !== option.default);
    case 'integer':
    case 'number':
      return option.max;
    case 'switch':
      return true;
    case 'modes':
      return [2, 3];
    case 'numbers':
      return [0.5, 0.25];
    case 'pins':
      return 'low:6+vertices:1,2';
    case 'colliders':
      return 'ground:-1+ball:0,1,0,0.5';
    case 'paint':
      return '0:IA';
    case 'engine':
      return 'young=1e5,poisson=0.3';
    case 'pattern':
      return 'wheel_*|a?, \\*&=';
    case 'name':
      return '_KEEP +&=';
  }
}

describe('settings as text', () => {
  it('are empty if all have their defaults', () => {
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

  it('take a word of an earlier version for its present one, and say so', () => {
    expect(readSetting(OPTIONS.fit, 'on')).toBe('modal');
    expect(readSetting(OPTIONS.symmetry, 'on')).toBe('on');
    const texts: Record<string, string> = { fit: 'on', symmetry: 'on' };
    expect(describeRenamedChoices(['fit', 'symmetry'], (flag) => texts[flag])).toEqual([
      [{ setting: 'fit' }, ' on of earlier versions is now modal (default: surface)'],
    ]);
  });

  it('preserve infinity', () => {
    const [{ text }] = changedSettings({ ...defaultSettings(), p: Infinity });
    expect(text).toBe('inf');
    expect(readSetting(OPTIONS.p, 'inf')).toBe(Infinity);
  });
});
