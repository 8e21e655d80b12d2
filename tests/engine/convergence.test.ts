import { describe, expect, it } from 'vitest';
import { describeConvergence, substepsToTake } from '../../web/engine/motion/convergence';

const found = { substeps: 20, substepDeviation: 3, deviationMean: 2.4, isConverged: false };

describe('the sentence about substeps', () => {
  it('is absent if the original has converged', () => {
    expect(describeConvergence({ ...found, isConverged: true }, String)).toBeNull();
  });

  it('has the deviation of the original from itself, and the substeps to take', () => {
    expect(describeConvergence(found, (substeps) => `take --substeps ${substeps}`)).toBe(
      'At 20 substeps the deviation of 2.4 % is not reliable, because 40 would move the original itself by 3.0 %: take --substeps 100.',
    );
  });

  it.each([
    [{ ...found, substepDeviation: 0.7 }, 50],
    [{ ...found, substepDeviation: 3 }, 100],
    [{ ...found, substepDeviation: 3.1 }, 200],
    [{ ...found, substeps: 5000 }, 10_000],
    [{ ...found, deviationMean: 0 }, 10_000],
  ])('rounds up to what can be remembered, within the range: %o', (convergence, substeps) => {
    expect(substepsToTake(convergence)).toBe(substeps);
  });
});
