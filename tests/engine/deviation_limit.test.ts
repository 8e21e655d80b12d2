import { describe, expect, it } from 'vitest';
import type { History } from '../../web/engine/core/core';
import { endWithin } from '../../web/engine/stages/deviation_limit';

/** A history of `count` collapses that take two faces each from 1,000. */
function historyOf(count: number): History {
  return {
    vertexCount: 502,
    triangleCount: 1000,
    kept: Uint32Array.from({ length: count }, (_, i) => i),
    removed: Uint32Array.from({ length: count }, (_, i) => 400 - i),
    positions: Float32Array.from({ length: 3 * count }, (_, i) => i),
    trianglesAfter: Uint32Array.from({ length: count }, (_, i) => 998 - 2 * i),
    refused: { topology: 1, flip: 2, lock: 3, angle: 4, deviation: 5 },
    stop: 'exhausted',
  };
}

describe('the end of a history with a largest deviation', () => {
  it('stays where it is if it is within that deviation', () => {
    const history = historyOf(300);
    expect(endWithin(history, 1, () => 1)).toBe(history);
    expect(endWithin(historyOf(0), 1, () => 1).kept.length).toBe(0);
  });

  it.each([0, 1, 150, 297, 298, 299])('moves back to the last of %i collapses that are within it', (good) => {
    const asked: number[] = [];
    const deviationAt = (faces: number) => {
      asked.push(faces);
      return faces >= 1000 - 2 * good ? 0.5 : 2;
    };
    const ended = endWithin(historyOf(300), 1, deviationAt);
    expect(ended.stop).toBe('deviation');
    expect([ended.kept.length, ended.removed.length, ended.trianglesAfter.length]).toEqual([
      good,
      good,
      good,
    ]);
    expect(ended.positions.length).toBe(3 * good);
    expect(asked.length).toBeLessThan(20);
  });

  it('separates no collapse from its mirror image', () => {
    const history = historyOf(300);
    // No vertex is its own image.
    const mirror = Uint32Array.from({ length: 502 }, (_, v) => 501 - v);
    const deviationAt = (faces: number) => (faces >= 1000 - 2 * 151 ? 0.5 : 2);
    expect(endWithin({ ...history, mirror }, 1, deviationAt).kept.length).toBe(150);
  });
});
