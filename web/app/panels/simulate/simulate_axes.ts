/** The part of the motion that the deviation chart shows. */

import type { TwinSample } from '../../../engine/motion/twin';
import { roundUp } from './simulate_scale';

/** The smallest and largest time range of the chart, in seconds. */
const SHORTEST = 2;
const LONGEST = 10;

export interface Axes {
  /** s */
  start: number;
  /** s */
  span: number;
  /** the deviation at the upper end, % */
  high: number;
}

const endOf = (samples: TwinSample[]): number => samples.at(-1)?.time ?? 0;

const startOf = (samples: TwinSample[]): number => Math.max(0, endOf(samples) - LONGEST);

/** The range of the axes: the whole run, or its last seconds. */
export function axesOf(samples: TwinSample[]): Axes {
  const [start, end] = [startOf(samples), endOf(samples)];
  const span = Math.max(SHORTEST, Math.min(LONGEST, Math.ceil(end)));
  const most = samples.reduce(
    (high, { time, mean, noise }) => (time < start ? high : Math.max(high, mean, noise ?? 0)),
    0.01,
  );
  return { start, span, high: roundUp(most) };
}

/** The noise floor now, %; null if it is not measured, or not any more. */
export const currentNoise = (samples: TwinSample[]): number | null => samples.at(-1)?.noise ?? null;

/** When the last noise floor in the chart was measured, in seconds, if the motion has gone on without it; otherwise null. */
export function noiseEnd(samples: TwinSample[]): number | null {
  if (currentNoise(samples) !== null) return null;
  const start = startOf(samples);
  return samples.findLast(({ time, noise }) => time >= start && noise !== null)?.time ?? null;
}
