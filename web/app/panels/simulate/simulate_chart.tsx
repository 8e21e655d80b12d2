/** The deviation of the optimized mesh over time, with its noise floor. */

import type { TwinSample } from '../../../engine/motion/twin';
import { twin } from '../../state/twin';
import { fixed, percent } from '../../controls/numbers';
import { axesOf, currentNoise, noiseEnd } from './simulate_axes';
import type { Axes } from './simulate_axes';
import './simulate_chart.css';
import { say } from '../../language/say';

/** The view box of the chart. */
const [WIDTH, HEIGHT] = [1000, 100];

export function DeviationChart() {
  const samples = twin.samples.value;
  const axes = axesOf(samples);
  const shown = samples.filter(({ time }) => time >= axes.start);
  const noise = shown.filter((sample) => sample.noise !== null);
  return (
    <figure class="chart">
      <Caption hasNoise={noise.length > 0} noiseEnd={noiseEnd(samples)} />
      <div class="plot">
        <span class="high">{axes.high}</span>
        <span class="low">0</span>
        <svg
          viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
          preserveAspectRatio="none"
          role="img"
          aria-label={describe(samples)}
        >
          <line class="grid" x1={0} x2={WIDTH} y1={HEIGHT / 2} y2={HEIGHT / 2} />
          <line class="grid" x1={0} x2={WIDTH} y1={HEIGHT} y2={HEIGHT} />
          <polyline class="noise" points={pointsOf(noise, (sample) => sample.noise ?? 0, axes)} />
          <polyline class="deviation" points={pointsOf(shown, (sample) => sample.mean, axes)} />
        </svg>
        <span class="from">{fixed(axes.start, 1)} s</span>
        <span class="to">{fixed(axes.start + axes.span, 1)} s</span>
      </div>
    </figure>
  );
}

/** `noiseEnd`: when the measurement of the noise floor was given up, in seconds; null: it was not. */
function Caption({ hasNoise, noiseEnd }: { hasNoise: boolean; noiseEnd: number | null }) {
  return (
    <figcaption>
      <span>
        <span class="key deviation" /> {say('Deviation, mean over the surface')}
      </span>
      {hasNoise && (
        <span title={noiseTitle(noiseEnd)}>
          <span class="key noise" /> {say('Noise floor')}
          {noiseEnd !== null && (
            <span class="muted">{say(', until {time} s', { time: fixed(noiseEnd, 2) })}</span>
          )}
        </span>
      )}
      <span class="muted">{say('% of the diagonal')}</span>
    </figcaption>
  );
}

function noiseTitle(noiseEnd: number | null): string {
  const title = say('The original compared with itself, with its constraints in another order');
  return noiseEnd === null ? title : `${title}${say('; not any more, since it slowed the motion down')}`;
}

function pointsOf(
  samples: TwinSample[],
  valueOf: (sample: TwinSample) => number,
  { start, span, high }: Axes,
) {
  return samples
    .map((sample) => {
      const x = (WIDTH * (sample.time - start)) / span;
      return `${fixed(x, 1)},${fixed(HEIGHT * (1 - valueOf(sample) / high), 2)}`;
    })
    .join(' ');
}

/** Describes the curve in words. */
function describe(samples: TwinSample[]): string {
  const last = samples.at(-1);
  if (!last) return say('Deviation over time: nothing has moved yet.');
  const peak = samples.reduce((most, sample) => (sample.mean > most.mean ? sample : most));
  const mean = samples.reduce((sum, sample) => sum + sample.mean, 0) / samples.length;
  const noise = currentNoise(samples);
  const floor = noise === null ? '' : say('; noise floor {noise}', { noise: percent(noise) });
  return say(
    'Deviation after {time} s: now {now} of the diagonal, {mean} on average, at most {most} at {at} s{floor}.',
    {
      time: fixed(last.time, 1),
      now: percent(last.mean),
      mean: percent(mean),
      most: percent(peak.mean),
      at: fixed(peak.time, 1),
      floor,
    },
  );
}
