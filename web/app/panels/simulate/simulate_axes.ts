/** Which part of the motion the chart of the deviation shows. */

import type { TwinSample } from '../../../engine/motion/twin';
import { roundUp } from './simulate_scale';

/** The least and the most seconds that the chart shows. */
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

/** The noise floor where the curve that is drawn ends, %; null where none is drawn. */
export function drawnNoise(samples: TwinSample[]): number | null {
  const start = startOf(samples);
  return samples.findLast(({ time, noise }) => time >= start && noise !== null)?.noise ?? null;
}
