import { describe, expect, it } from 'vitest';
import { markDeviations } from '../../web/engine/stages/budget/deviation_marks';

const falling = (faces: number): number => 50 / faces;

describe('marks of deviation', () => {
  it('are where the deviation is crossed, and evaluate no face count twice', () => {
    const asked: number[] = [];
    const marks = markDeviations(
      (faces) => {
        asked.push(faces);
        return falling(faces);
      },
      { floor: 4, total: 10_000 },
    );
    expect(marks.map(({ deviation }) => deviation)).toEqual([0.1, 0.5, 1]);
    for (const { deviation, faces } of marks) {
      expect(falling(faces)).toBeLessThanOrEqual(deviation);
      expect(falling(faces / 1.03)).toBeGreaterThan(deviation);
    }
    expect(new Set(asked).size).toBe(asked.length);
    expect(asked.length).toBeLessThan(30);
  });

  it('are left out if the floor is within the deviation', () => {
    const marks = markDeviations((faces) => falling(faces), { floor: 80, total: 1000 });
    expect(marks.map(({ deviation }) => deviation)).toEqual([0.1, 0.5]);
  });

  it('are absent if nothing can be removed', () => {
    expect(markDeviations(() => 5, { floor: 12, total: 12 })).toEqual([]);
  });

  it('are at a crossing even if the deviation is not monotonic', () => {
    const uneven = (faces: number) => (faces > 300 && faces < 330 ? 0.9 : falling(faces));
    for (const { deviation, faces } of markDeviations(uneven, { floor: 4, total: 10_000 }))
      expect(uneven(faces)).toBeLessThanOrEqual(deviation);
  });
});
