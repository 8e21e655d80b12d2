/** The deviation of the optimized mesh over time, with its noise floor. */

import type { TwinSample } from '../../../engine/motion/twin';
import { twin } from '../../state/simulation';
import { fixed, percent } from '../../controls/numbers';
import { roundUp } from './simulate_scale';

const [WIDTH, HEIGHT] = [1000, 100];

/** Seconds that the curve shows at least, and at most. */
const SHORTEST = 2;
const LONGEST = 10;

interface Frame {
  start: number;
  span: number;
  /** the deviation at the upper end, % */
  high: number;
}

export function DeviationChart() {
  const samples = twin.samples.value;
  const frame = frameOf(samples);
  const shown = samples.filter(({ time }) => time >= frame.start);
  const noise = shown.filter((sample) => sample.noise !== null);
  return (
    <figure class="chart">
      <figcaption>
        <span>
          <span class="key deviation" /> Deviation, mean over the surface
        </span>
        {noise.length > 0 && (
          <span title="The original against itself with its constraints in another order">
            <span class="key noise" /> Noise floor
          </span>
        )}
        <span class="muted">% of the diagonal</span>
      </figcaption>
      <div class="plot">
        <span class="high">{frame.high}</span>
        <span class="low">0</span>
        <svg
          viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
          preserveAspectRatio="none"
          role="img"
          aria-label={describe(samples)}
        >
          <line class="grid" x1={0} x2={WIDTH} y1={HEIGHT / 2} y2={HEIGHT / 2} />
          <line class="grid" x1={0} x2={WIDTH} y1={HEIGHT} y2={HEIGHT} />
          <polyline class="noise" points={pointsOf(noise, (sample) => sample.noise ?? 0, frame)} />
          <polyline class="deviation" points={pointsOf(shown, (sample) => sample.mean, frame)} />
        </svg>
        <span class="from">{fixed(frame.start, 1)} s</span>
        <span class="to">{fixed(frame.start + frame.span, 1)} s</span>
      </div>
    </figure>
  );
}

/** The whole run, or its last seconds. */
function frameOf(samples: TwinSample[]): Frame {
  const end = samples.at(-1)?.time ?? 0;
  const start = Math.max(0, end - LONGEST);
  const span = Math.max(SHORTEST, Math.min(LONGEST, Math.ceil(end)));
  const most = samples.reduce(
    (high, { time, mean, noise }) => (time < start ? high : Math.max(high, mean, noise ?? 0)),
    0.01,
  );
  return { start, span, high: roundUp(most) };
}

function pointsOf(
  samples: TwinSample[],
  valueOf: (sample: TwinSample) => number,
  { start, span, high }: Frame,
) {
  return samples
    .map((sample) => {
      const x = (WIDTH * (sample.time - start)) / span;
      return `${fixed(x, 1)},${fixed(HEIGHT * (1 - valueOf(sample) / high), 2)}`;
    })
    .join(' ');
}

/** The curve in words. */
function describe(samples: TwinSample[]): string {
  const last = samples.at(-1);
  if (!last) return 'Deviation over time: nothing has moved yet.';
  const peak = samples.reduce((most, sample) => (sample.mean > most.mean ? sample : most));
  const mean = samples.reduce((sum, sample) => sum + sample.mean, 0) / samples.length;
  const floor = last.noise === null ? '' : `; noise floor ${percent(last.noise)}`;
  return (
    `Deviation after ${fixed(last.time, 1)} s: now ${percent(last.mean)} of the diagonal, ` +
    `${percent(mean)} on average, at most ${percent(peak.mean)} at ${fixed(peak.time, 1)} s${floor}.`
  );
}
