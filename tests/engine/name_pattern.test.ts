import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { matchesPattern } from '../../web/engine/settings/name_pattern';
import { processorTime } from './support/processor_time';

describe('a pattern of names', () => {
  it.each([
    ['Glass', 'Glass', true],
    ['Glass', 'glass', false],
    ['Glass', 'Glass.001', false],
    ['Glass*', 'Glass.001', true],
    ['*.001', 'Glass.001', true],
    ['*', '', true],
    ['', '', true],
    ['', 'a', false],
    ['a?c', 'abc', true],
    ['a?c', 'ac', false],
    ['?', '😀', true],
    ['a*b*c', 'a--b--bc', true],
    ['a*b*c', 'a--b--', false],
    ['wheel|door*', 'door_left', true],
    ['wheel|door*', 'wheels', false],
    ['[LOD]+(x)', '[LOD]+(x)', true],
    ['a\\*b', 'a*b', true],
    ['a\\*b', 'axb', false],
    ['a\\|b', 'a|b', true],
    ['a\\\\b', 'a\\b', true],
    ['a\\b', 'a\\b', true],
    ['*\n*', 'one\ntwo', true],
  ])('%j and the name %j: %s', (pattern, name, expected) => {
    expect(matchesPattern(pattern, name)).toBe(expected);
  });

  it('matches like the equivalent regular expression', () => {
    const letters = fc.array(fc.constantFrom('a', 'b', '*', '?'), { maxLength: 8 });
    const names = fc.array(fc.constantFrom('a', 'b'), { maxLength: 8 });
    fc.assert(
      fc.property(letters, names, (words, name) => {
        const expected = new RegExp(`^${words.join('').replace(/\*/g, '.*').replace(/\?/g, '.')}$`);
        expect(matchesPattern(words.join(''), name.join(''))).toBe(expected.test(name.join('')));
      }),
      { numRuns: 2000, seed: 5 },
    );
  });

  it('takes little time for a name that is made to be slow', () => {
    const seconds = processorTime();
    expect(matchesPattern('*a'.repeat(30), 'a'.repeat(29) + 'b'.repeat(50_000))).toBe(false);
    expect(seconds()).toBeLessThan(1);
  });
});
