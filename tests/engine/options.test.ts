import { readFileSync } from 'node:fs';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  checkSettings,
  defaultSettings,
  OPTIONS,
  resolveModel,
  resolveModes,
} from '../../web/engine/settings/options';
import type { Settings } from '../../web/engine/settings/options';
import { VERSION } from '../../web/engine/core/version';

const keys = Object.keys(OPTIONS) as (keyof Settings)[];
const failure = (change: Partial<Record<keyof Settings, unknown>>): string => {
  try {
    checkSettings({ ...defaultSettings(), ...change } as Settings);
    return '';
  } catch (error) {
    return (error as Error).message;
  }
};

describe('settings', () => {
  it('are allowed as they come', () => {
    expect(failure({})).toBe('');
    expect(Object.keys(defaultSettings())).toEqual(keys);
    expect(JSON.parse(JSON.stringify(defaultSettings()))).toEqual(defaultSettings());
  });

  it('are a fresh copy each time', () => {
    defaultSettings().modeWeights.push(1);
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

  it('are refused outside their range, and allowed at its ends', () => {
    for (const key of keys.filter((one) => ['number', 'integer'].includes(OPTIONS[one].kind))) {
      const { flag, min, max } = OPTIONS[key];
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
    [{ modes: [0] }, '--mode is 0: give auto, all, or numbers from 1 to 100 with commas (default: auto).'],
    [
      { modes: [2, 2] },
      '--mode is 2,2: give auto, all, or numbers from 1 to 100 with commas (default: auto).',
    ],
    [
      { modes: [] },
      '--mode is an empty list: give auto, all, or numbers from 1 to 100 with commas (default: auto).',
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

  it('of any kind never make the check throw anything but a sentence', () => {
    fc.assert(
      fc.property(fc.constantFrom(...keys), fc.anything(), (key, value) => {
        const message = failure({ [key]: value });
        expect(message === '' || /^--[a-z-]+ .*\.$/s.test(message)).toBe(true);
      }),
      { seed: 5 },
    );
  });
});

describe('the version', () => {
  it('is that of package.json', () => {
    const { version } = JSON.parse(readFileSync(new URL('../../package.json', import.meta.url), 'utf8')) as {
      version: string;
    };
    expect(VERSION).toBe(version);
  });
});
