/** Round upper ends for scales. */

import { computed } from '@preact/signals';
import { twin } from '../../state/twin';

/** The smallest of 1, 2 or 5 times a power of ten that is at least `value` > 0. */
export function roundUp(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  const step = [1, 2, 5, 10].find((factor) => factor * power >= value * (1 - 1e-9)) ?? 10;
  return Number((step * power).toPrecision(1));
}

/** The lower limit of the scale, in %, however small the deviations. */
const LEAST = 0.1;

/** The deviation at the upper end of the colours, in %. */
export const heatScale = computed(() => roundUp(Math.max(LEAST, twin.worst.value)));
