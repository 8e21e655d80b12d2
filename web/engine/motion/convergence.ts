/** Whether a simulated original has converged, in words. */

import type { MotionComparison } from '../core/core';
import { counted } from '../core/words';
import { OPTIONS } from '../settings/options';

/** The largest share of the deviation that the error of the substeps may have; as kConverged of wasm/compare/compare_motion.h. */
const CONVERGED = 0.25;

/** The fields of a comparison that describe its convergence. */
export type Convergence = Pick<
  MotionComparison,
  'substeps' | 'substepDeviation' | 'deviationMean' | 'isConverged'
>;

/**
 * The substeps at which the original would have converged, since the error falls about in proportion to the substep. Rounded up to one, two
 * or five times a power of ten, up to the maximum of a step.
 */
export function substepsToTake({ substeps, substepDeviation, deviationMean }: Convergence): number {
  const { max } = OPTIONS.substeps;
  const wanted = (substeps * substepDeviation) / (CONVERGED * deviationMean);
  if (!(wanted < max)) return max;
  let power = 1;
  while (10 * power <= wanted) power *= 10;
  return [1, 2, 5, 10].map((step) => step * power).find((round) => round >= wanted)!;
}

const percentOf = (value: number): string => `${value.toPrecision(2)} %`;

/** One sentence where the original has not converged; null where it has. `take` says how to raise the substeps. */
export function describeConvergence(
  convergence: Convergence,
  take: (substeps: number) => string,
): string | null {
  const { substeps, substepDeviation, deviationMean, isConverged } = convergence;
  if (isConverged) return null;
  const finer = Math.min(2 * substeps, OPTIONS.substeps.max);
  return (
    `At ${counted(substeps, 'substep')} the deviation of ${percentOf(deviationMean)} is not reliable, ` +
    `because ${finer} would move the original itself by ${percentOf(substepDeviation)}: ${take(substepsToTake(convergence))}.`
  );
}
