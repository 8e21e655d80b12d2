/** The speed-up of a step of the optimized mesh, and an explanation of what limits it. */

import { figures } from '../../controls/numbers';
import { say } from '../../language/say';

/** A speed-up below this saves no time that counts. */
const MIN_GAIN = 1.1;
/** s; a step that is shorter has so little to do that other work than that on faces shows. */
const SHORT_STEP = 0.001;

/** Of one step of each body; `haveLattice`: both have an inside of equally coarse cells. */
export interface StepTimes {
  /** s */
  original: number;
  /** s */
  optimized: number;
  haveLattice: boolean;
}

export const speedUp = ({ original, optimized }: StepTimes): string =>
  original > 0 && optimized > 0 ? `x${figures(original / optimized)}` : '...';

/** The explanation of what limits the speed-up; '' if nothing does. */
export function describeSpeedUp({ original, optimized, haveLattice }: StepTimes): string {
  const isSlow = optimized > 0 && original < MIN_GAIN * optimized;
  if (isSlow && haveLattice) return say('same lattice');
  if (isSlow && original < SHORT_STEP) return say('too few faces');
  return '';
}
