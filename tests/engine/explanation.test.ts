import { describe, expect, it } from 'vitest';
import { VERDICTS } from '../../web/engine/core/core';
import type { WhyKept } from '../../web/engine/core/core';
import { explain } from '../../web/engine/report/explanation';

const verdict = (name: (typeof VERDICTS)[number]) => VERDICTS.indexOf(name);

/** Four vertices: a cheap one, one costly for its strain, one kept by paint, and one that cannot be removed. */
const why: WhyKept = {
  error: Float32Array.of(1, 1, 1, 1),
  size: Float32Array.of(1, 1, 1, 1),
  strain: Float32Array.of(0, 6, 0, 0),
  curvature: new Float32Array(4),
  quality: new Float32Array(4),
  keep: Float32Array.of(1, 1, 50, 1),
  neighbour: Uint32Array.of(1, 0, 0, 0),
  verdict: Uint8Array.of(verdict('legal'), verdict('legal'), verdict('legal'), verdict('topology')),
};

describe('the explanation of a kept vertex', () => {
  it('lists the terms as shares of the cost, largest first', () => {
    const { reasons } = explain(why, 1);
    expect(reasons.map(({ text }) => text)).toEqual([
      'it bends here',
      'the surface would move',
      'triangles would get larger',
    ]);
    expect(reasons.map(({ share }) => share)).toEqual([0.75, 0.125, 0.125]);
  });

  it('says how many of the removable vertices are removed before it', () => {
    expect(explain(why, 0).sentence).toBe('0 % of the vertices are removed before it.');
    expect(explain(why, 1).sentence).toBe('33 % of the vertices are removed before it.');
    expect(explain(why, 2)).toMatchObject({
      sentence: '67 % of the vertices are removed before it.',
      keep: 50,
    });
  });

  it('says why its collapses are refused', () => {
    expect(explain(why, 3).sentence).toBe('It cannot be removed: the topology would change.');
  });

  it('has no reasons if nothing costs anything', () => {
    const free = { ...why, error: new Float32Array(4), size: new Float32Array(4) };
    expect(explain(free, 0).reasons).toEqual([]);
  });
});
