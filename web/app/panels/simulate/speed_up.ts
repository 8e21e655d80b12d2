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

const isFaster = ({ original, optimized }: StepTimes): boolean => original >= MIN_GAIN * optimized;

/** Bodies with the same lattice take equally long: what is measured beyond that is noise, and not shown. */
export function speedUp(times: StepTimes): string {
  const { original, optimized, haveLattice } = times;
  if (!(original > 0 && optimized > 0)) return '...';
  return haveLattice && !isFaster(times) ? say('none') : `x${figures(original / optimized)}`;
}

/** The explanation of what limits the speed-up; '' if nothing does. */
export function describeSpeedUp(times: StepTimes): string {
  const { original, optimized, haveLattice } = times;
  if (optimized <= 0 || isFaster(times)) return '';
  if (haveLattice) return say('same lattice');
  return original < SHORT_STEP ? say('too few faces') : '';
}
