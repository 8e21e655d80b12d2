import { describe, expect, it } from 'vitest';
import type { History } from '../../web/engine/core/core';
import { facesWithin, fewerFacesWithin } from '../../web/engine/stages/budget/deviation_limit';

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

/** Within the limit with at least so many faces. */
const within = (fewest: number, asked: number[] = []) => ({
  isWithin: (faces: number) => {
    asked.push(faces);
    return faces >= fewest;
  },
});

describe('the faces at which a deviation limit stops a body', () => {
  it('are the requested ones if these are within it, after a single measurement', () => {
    const asked: number[] = [];
    expect(facesWithin(historyOf(300), 600, within(500, asked))).toBe(600);
    expect(asked).toEqual([600]);
    expect(facesWithin(historyOf(0), 600, within(2000))).toBe(1000);
  });

  it.each([1000, 998, 700, 406, 404, 402])('are the fewest that are within it, if those are %i', (fewest) => {
    for (const guess of [undefined, 0, 150, 299, 300]) {
      const asked: number[] = [];
      const found = facesWithin(historyOf(300), 1, { ...within(fewest, asked), guess });
      expect(found).toBeGreaterThanOrEqual(fewest);
      expect(found).toBeLessThanOrEqual(Math.max(fewest, 1.01 * fewest));
      expect(asked.length).toBeLessThan(20);
    }
  });

  it('have always been measured to be within it', () => {
    const isWithin = (faces: number) => faces % 16 < 6;
    const found = facesWithin(historyOf(300), 410, { isWithin });
    expect(found === 1000 || isWithin(found)).toBe(true);
  });

  it('separate no collapse from its mirror image', () => {
    // No vertex is its own image.
    const mirror = Uint32Array.from({ length: 502 }, (_, v) => 501 - v);
    const found = facesWithin({ ...historyOf(300), mirror }, 1, within(1000 - 2 * 151));
    expect((1000 - found) % 4).toBe(0);
  });
});

describe('fewer faces than those at which a body has stopped', () => {
  const faces = Uint32Array.from({ length: 480 }, (_, i) => 1000 - 2 * i);

  it('are tested once if there are none', () => {
    const asked: number[] = [];
    expect(fewerFacesWithin(faces, [600, 100], within(600, asked).isWithin)).toBe(600);
    expect(asked).toEqual([588]);
  });

  it.each([590, 500, 302, 102])('are the fewest within the limit, if those are %i', (fewest) => {
    const asked: number[] = [];
    const found = fewerFacesWithin(faces, [600, 100], within(fewest, asked).isWithin);
    expect(found).toBeGreaterThanOrEqual(fewest);
    expect(found).toBeLessThanOrEqual(Math.max(fewest + 2, 1.02 * fewest));
    expect(asked.length).toBeLessThan(12);
  });

  it('are never fewer than the wanted number', () => {
    const asked: number[] = [];
    expect(fewerFacesWithin(faces, [600, 400], within(0, asked).isWithin)).toBe(400);
    expect(Math.min(...asked)).toBe(400);
    expect(fewerFacesWithin(faces, [600, 600], within(0).isWithin)).toBe(600);
    expect(fewerFacesWithin(faces, [60, 1], within(0).isWithin)).toBe(42);
  });
});
