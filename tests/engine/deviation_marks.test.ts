import { describe, expect, it } from 'vitest';
import { defaultSettings } from '../../web/engine/settings/options';
import { markDeviations } from '../../web/engine/stages/budget/deviation_marks';
import { STAGES } from '../../web/engine/stages/stages';
import { loadTestCore } from './support/core';
import { runOfMesh } from './support/runs';
import { torus } from './support/shapes';

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

  it('are those of the result that is exported, its fit included', async () => {
    const run = runOfMesh(await loadTestCore(1), torus(48, 24));
    // Without a guard, so that every mark can be reached.
    const settings = { ...defaultSettings(), maxDeviation: 0 };
    const deviationOf = (fit: 'surface' | 'off', targetFaces: number) =>
      run.get(STAGES.measured, { ...settings, fit, targetFaces }).distance.hausdorff;
    const marks = run.get(STAGES.deviationMarks, settings);
    expect(marks.length).toBeGreaterThan(1);
    for (const { deviation, faces } of marks) {
      expect(deviationOf('surface', faces)).toBeLessThanOrEqual(deviation);
      // 5 % fewer faces are beyond the mark, which is found to 2 %.
      expect(deviationOf('surface', Math.floor(0.95 * faces))).toBeGreaterThan(0.9 * deviation);
    }
    const { faces } = marks[marks.length - 1];
    expect(deviationOf('off', faces)).not.toBe(deviationOf('surface', faces));
  });
});
