import { readFileSync } from 'node:fs';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  checkSettings,
  defaultSettings,
  methodChange,
  OPTIONS,
  readsSetting,
  resolveModel,
  resolveModes,
  SettingError,
  settingsOf,
  wordSentence,
} from '../../web/engine/settings/options';
import type { OptionSpec, Settings } from '../../web/engine/settings/options';
import { VERSION } from '../../web/engine/core/version';

const keys = Object.keys(OPTIONS) as (keyof Settings)[];
const flagOf = (key: keyof Settings) => `--${OPTIONS[key].flag}`;
/** The sentence in the words of the command line; empty if nothing is refused. */
const failure = (change: Partial<Record<keyof Settings, unknown>>): string => {
  try {
    checkSettings({ ...defaultSettings(), ...change } as Settings);
    return '';
  } catch (error) {
    return error instanceof SettingError
      ? wordSentence(flagOf(error.setting), error.sentence, flagOf)
      : String(error);
  }
};

describe('settings', () => {
  it('are allowed by default', () => {
    expect(failure({})).toBe('');
    expect(Object.keys(defaultSettings())).toEqual(keys);
    expect(JSON.parse(JSON.stringify(defaultSettings()))).toEqual(defaultSettings());
  });

  it('are a fresh copy each time', () => {
    (defaultSettings().modeWeights as number[]).push(1);
    expect(defaultSettings().modeWeights).toEqual([]);
  });

  it('have the weights of the paper', () => {
    const { strainWeight, curvatureWeight, qualityWeight } = defaultSettings('paper');
    expect([strainWeight, curvatureWeight, qualityWeight]).toEqual([0.05, 1, 0.01]);
  });

  it('each have one flag, a label and a sentence', () => {
    expect(new Set(keys.map((key) => OPTIONS[key].flag)).size).toBe(keys.length);
    for (const key of keys) {
      expect(OPTIONS[key].flag).toMatch(/^[a-z]+(-[a-z]+)*$/);
      expect(OPTIONS[key].help).toMatch(/^[A-Z].*\.$/);
    }
  });

  it('are refused outside of their range and allowed at its ends', () => {
    for (const key of keys) {
      const option: OptionSpec = OPTIONS[key];
      if (option.kind !== 'number' && option.kind !== 'integer') continue;
      const { flag, min, max } = option;
      expect(failure({ [key]: min, modes: 'all' })).toBe('');
      expect(failure({ [key]: max })).toBe('');
      for (const value of [min - 1, max + 1, NaN, '1', null].filter((one) => one !== Infinity))
        expect(failure({ [key]: value })).toMatch(
          new RegExp(`^--${flag} is .*: give .* \\(default: .*\\)\\.$`),
        );
    }
  });

  it.each([
    [{ method: 'best' }, '--method is best: give one of limber, paper, qem (default: limber).'],
    [{ modeCount: 1.5 }, '--modes is 1.5: give a whole number from 1 to 100 (default: 12).'],
    [
      { modes: [0] },
      '--mode is 0: give auto, all, or numbers from 1 to 100 separated by commas (default: auto).',
    ],
    [{ modes: [2, 1, 2] }, '--mode names mode 2 twice: give it once.'],
    [
      { modes: [] },
      '--mode is an empty list: give auto, all, or numbers from 1 to 100 separated by commas (default: auto).',
    ],
    [
      { modes: [1, 20] },
      '--mode names mode 20, but --modes computes only 12: raise --modes to 20 or name lower modes.',
    ],
    [
      { modes: [1, 2], modeWeights: [1] },
      '--mode-weights has 1 number for 2 guiding modes: give one for each mode of --mode.',
    ],
    [{ p: 0.5 }, '--p is 0.5: give a number of at least 1, or inf (default: 2).'],
  ])('%j are refused', (change, message) => {
    expect(failure(change)).toBe(message);
  });

  it('resolve auto for the method', () => {
    const paper = defaultSettings('paper');
    expect([resolveModel(paper), resolveModes(paper)]).toEqual(['laplacian', [1]]);
    const other = defaultSettings('qem');
    expect([resolveModel(other), resolveModes(other)]).toEqual(['auto', [1, 2, 3, 4, 5, 6]]);
    expect(resolveModes({ ...other, modeCount: 3 })).toEqual([1, 2, 3]);
    expect(resolveModes({ ...paper, modes: 'all', modeCount: 3 })).toEqual([1, 2, 3]);
    expect(resolveModel({ ...paper, model: 'shell' })).toBe('shell');
  });

  it('with any values never make the check throw anything other than a sentence', () => {
    fc.assert(
      fc.property(fc.constantFrom(...keys), fc.anything(), (key, value) => {
        const message = failure({ [key]: value });
        expect(message === '' || /^--[a-z-]+ .*\.$/s.test(message)).toBe(true);
      }),
      { seed: 5 },
    );
  });
});

describe('an error', () => {
  const refuse = (change: Partial<Settings>): SettingError => {
    try {
      checkSettings({ ...defaultSettings(), ...change });
    } catch (error) {
      return error as SettingError;
    }
    throw new Error('nothing is refused');
  };

  it('has the setting and a sentence that each host can word', () => {
    const error = refuse({ modes: [20] });
    expect(error.setting).toBe('modes');
    expect(wordSentence('It', error.sentence, (key) => key)).toBe(
      'It names mode 20, but modeCount computes only 12: raise modeCount to 20 or name lower modes.',
    );
    expect(error.message).toMatch(
      /^“Modes that guide” names mode 20, but “Modes to compute” computes only 12/,
    );
  });

  it('never names a flag', () => {
    const changes: Partial<Settings>[] = [
      { p: 0 },
      { pins: 'x' },
      { lock: 'x' },
      { paint: 'x' },
      { colliders: 'x' },
      { modes: [20] },
      { modeWeights: [1] },
    ];
    for (const change of changes) {
      const error = refuse(change);
      expect(error).toBeInstanceOf(SettingError);
      expect([error.setting, error.message.includes('--')]).toEqual([Object.keys(change)[0], false]);
    }
  });
});

describe('a method', () => {
  it('reads its own settings and those that all methods read', () => {
    expect(readsSetting(defaultSettings('qem'), 'strainWeight')).toBe(false);
    expect(readsSetting(defaultSettings('paper'), 'curvatureWeight')).toBe(true);
    expect(readsSetting(defaultSettings('paper'), 'maxDeviation')).toBe(true);
  });

  it('replaces the weights of another method', () => {
    for (const from of ['limber', 'paper', 'qem'] as const)
      for (const to of ['limber', 'paper', 'qem'] as const)
        expect({ ...defaultSettings(from), ...methodChange(to) }).toEqual(defaultSettings(to));
  });
});

describe('a command', () => {
  it('accepts the settings of its groups and those whose row names it', () => {
    expect(settingsOf('inspect')).toEqual(['mesh', 'materialName', 'exclude', 'weld', 'threads']);
    expect(settingsOf('compare')).toContain('modeCount');
    expect(settingsOf('simulate')).toContain('pins');
    expect(settingsOf('optimize')).toContain('calibrate');
    expect(settingsOf('optimize')).not.toContain('scenario');
  });
});

describe('the version', () => {
  it('equals that of package.json', () => {
    const { version } = JSON.parse(readFileSync(new URL('../../package.json', import.meta.url), 'utf8')) as {
      version: string;
    };
    expect(VERSION).toBe(version);
  });
});
