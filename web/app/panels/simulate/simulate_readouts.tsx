/** The cost of a step of each body, their deviation, and whether the motion is in real time. */

import type { TwinFrame } from '../../worker/simulation_protocol';
import { haveLattice, twin } from '../../state/twin';
import { wants } from '../../state/store';
import { fixed, percent } from '../../controls/numbers';
import { Readout } from '../../controls/readout';
import { drawnNoise } from './simulate_axes';
import { describeSpeedUp, speedUp } from './speed_up';
import type { StepTimes } from './speed_up';
import { say } from '../../language/say';

/** A pace below this is called slow motion. */
const REAL_TIME = 0.9;

export function SimulateReadouts() {
  const frame = twin.numbers.value;
  const times = stepTimes(frame);
  const last = twin.samples.value.at(-1);
  const noise = drawnNoise(twin.samples.value);
  return (
    <dl class="readouts" tabIndex={0}>
      <Readout
        name="Time"
        value={frame ? `${fixed(frame.time, 2)} s` : '...'}
        note={describePace(frame)}
        width="wide"
      />
      <Cost name="Original, per step" seconds={times.original} />
      <Cost name="Optimized, per step" seconds={times.optimized} />
      <Readout name="Speed-up" value={speedUp(times)} note={describeSpeedUp(times)} width="wide" />
      <Readout
        name="Deviation"
        value={last ? percent(last.mean) : '...'}
        note={
          noise === null
            ? say('noise floor not measured')
            : say('noise floor {noise}', { noise: percent(noise) })
        }
        width="wider"
      />
      <Readout
        name="Stretch"
        value={frame ? percent(frame.bodies.original.stretch) : '...'}
        note={frame ? say('optimized {stretch}', { stretch: percent(frame.bodies.optimized.stretch) }) : ''}
        width="wide"
      />
    </dl>
  );
}

function describePace(frame: TwinFrame | null): string {
  if (!(twin.playing.value || frame?.playing)) return say('paused');
  if (!frame) return say('about to start');
  return frame.pace < REAL_TIME
    ? say('slow motion x{pace}', { pace: frame.pace.toPrecision(2) })
    : say('real time');
}

function Cost({ name, seconds }: { name: string; seconds: number }) {
  const perSubstep = (1e6 * seconds) / wants.settings.value.substeps;
  return (
    <Readout
      name={name}
      value={seconds > 0 ? `${(1000 * seconds).toPrecision(3)} ms` : '...'}
      note={seconds > 0 ? say('{time} µs/substep', { time: perSubstep.toPrecision(3) }) : ''}
      width="wide"
    />
  );
}

const stepTimes = (frame: TwinFrame | null): StepTimes => ({
  original: frame?.bodies.original.stepSeconds ?? 0,
  optimized: frame?.bodies.optimized.stepSeconds ?? 0,
  haveLattice: haveLattice.value,
});
