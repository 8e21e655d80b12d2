import { describe, expect, it } from 'vitest';
import type { ComponentModes, Mode, ModeName } from '../../web/engine/core/core';
import {
  describeModels,
  leadingMode,
  localModes,
  spellModes,
  suggestedModes,
} from '../../web/engine/core/mode_set';

const part = (change: Partial<ComponentModes> = {}): ComponentModes => ({
  faces: 10,
  model: 'shell',
  host: 0,
  coarseVertices: 0,
  zeroModesExpected: 6,
  zeroModesFound: 6,
  modeCount: 4,
  ...change,
});
const mode = (ordinal: number, name: ModeName, component = 0): Mode => ({
  omega: ordinal + component + 1,
  residual: 0,
  component,
  ordinal,
  axis: -1,
  name,
});
const small = part({ faces: 4, modeCount: 2 });
const large = part({ faces: 20, host: 1 });
const set = {
  components: [small, large],
  modes: [
    mode(0, 'local'),
    mode(1, 'bend'),
    mode(0, 'bend', 1),
    mode(1, 'local', 1),
    mode(2, 'twist', 1),
    mode(3, 'stretch', 1),
  ],
};

describe('an ordinal of several parts', () => {
  it('is named after the part with most faces, or the first of equal parts', () => {
    expect(leadingMode(set, 0)?.name).toBe('bend');
    const equal = { components: [part(), part({ host: 1 })], modes: [mode(0, 'bend', 1), mode(0, 'twist')] };
    expect(leadingMode(equal, 0)?.name).toBe('twist');
    expect(leadingMode(set, 9)).toBeNull();
  });

  it('is local if the mode of that part is, and then not suggested', () => {
    expect(localModes(set, [1, 2, 3])).toEqual([2]);
    expect(suggestedModes(set, 2)).toEqual([1, 3]);
    expect(suggestedModes(set, 6)).toEqual([1, 3, 4]);
  });
});

describe('numbers of modes', () => {
  it('are spelt with runs of three or more as ranges', () => {
    expect(spellModes([2])).toBe('2');
    expect(spellModes([2, 1])).toBe('1, 2');
    expect(spellModes([6, 1, 2, 5, 4])).toBe('1, 2, 4 to 6');
  });
});

describe('the models of the parts', () => {
  it('are counted in words, with cavities separate from solids', () => {
    const solid = (host: number) => part({ model: 'solid', host });
    expect(describeModels([solid(0), solid(1), solid(2), part({ host: 3 })])).toBe('3 solid parts, 1 shell');
    expect(describeModels([solid(0), solid(0)])).toBe('1 solid part, 1 cavity');
    expect(describeModels([part({ model: 'laplacian' })])).toBe('1 Laplacian part');
  });
});
