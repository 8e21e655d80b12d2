import { readdirSync, readFileSync } from 'node:fs';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { arcCosine, length3 } from '../../web/engine/core/exact_math';

describe('exact mathematics', () => {
  it('computes the arc cosine to within 2e-8', () => {
    fc.assert(
      fc.property(fc.double({ min: -1, max: 1, noNaN: true }), (x) => {
        expect(Math.abs(arcCosine(x) - Math.acos(x))).toBeLessThan(3e-8);
      }),
      { seed: 6 },
    );
    expect([arcCosine(1), arcCosine(1.5), arcCosine(-1.5)]).toEqual([0, 0, Math.PI]);
  });

  it('computes a length', () => {
    expect(length3(2, 3, 6)).toBe(7);
  });

  it('is used throughout the engine, so that browsers and Node agree to the bit', () => {
    const folder = new URL('../../web/engine/', import.meta.url);
    const files = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((name) =>
      name.endsWith('.ts'),
    );
    // The oscillation of exported shapes is for display only.
    const offenders = files.filter((name) => {
      const text = readFileSync(new URL(name, folder), 'utf8').replace(/\/\*[^]*?\*\//g, '');
      return /Math\.(hypot|a?cosh?|a?sinh?|a?tanh?|atan2|cbrt|pow|exp|log)\w*\(/.test(text);
    });
    expect(offenders).toEqual(['document/shapes.ts']);
  });
});
