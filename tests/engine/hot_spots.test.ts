import { describe, expect, it } from 'vitest';
import {
  describeHotSpots,
  differentPairs,
  hotFaces,
  sharedHotSpots,
} from '../../web/engine/report/hot_spots';

const hot = (...faces: number[]) => Uint8Array.from(faces);

describe('hot spots', () => {
  it('are the faces of rank 0.9 and above', () => {
    expect([...hotFaces(Float32Array.from([0, 0.89, 0.9, 1]))]).toEqual([0, 0, 1, 1]);
  });

  it('coincide fully for a mode with itself, and with another mode in the faces of both', () => {
    const shared = sharedHotSpots([hot(1, 1, 0, 0), hot(0, 1, 1, 1), hot(0, 0, 0, 0)]);
    const [third] = Float32Array.of(1 / 3);
    expect([...shared]).toEqual([1, 0.5, 0, third, 1, 0, 0, 0, 0]);
  });

  it('that hardly overlap make a pair of modes different; pairs with the least overlap come first', () => {
    const shared = Float32Array.from([1, 0.2, 0.5, 0.1, 1, 0.04, 0.5, 0.02, 1]);
    expect(differentPairs(shared, 3, [3, 1, 2])).toEqual([
      { first: 2, second: 3, common: Math.fround(0.04) },
      { first: 1, second: 2, common: Math.fround(0.2) },
    ]);
  });

  it('of a mode that does not guide or does not exist make no pair', () => {
    const shared = Float32Array.from([1, 0, 0, 1]);
    expect(differentPairs(shared, 2, [1])).toEqual([]);
    expect(differentPairs(shared, 2, [2, 3])).toEqual([]);
  });

  it('are described in one sentence', () => {
    const pair = (first: number, second: number, common: number) => ({ first, second, common });
    expect(describeHotSpots([])).toBe('');
    expect(describeHotSpots([pair(1, 3, 0.04)])).toBe(
      'Modes 1 and 3 strain different places (4 % in common): faces stay at both.',
    );
    expect(describeHotSpots([pair(1, 3, 0), pair(1, 2, 0.1)])).toBe(
      'Modes 1 and 3 strain different places (0 % in common): 1 other pair does, too, and faces stay at all of them.',
    );
    expect(describeHotSpots([pair(1, 3, 0), pair(1, 2, 0.1), pair(2, 3, 0.1)])).toContain('2 other pairs do');
  });
});
