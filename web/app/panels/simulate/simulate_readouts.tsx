/** The cost of a step of each body, their deviation, and whether the motion is in real time. */

import type { TwinFrame } from '../../worker/simulation_protocol';
import { haveLattice, twin } from '../../state/twin';
import { wants } from '../../state/store';
import { figures, fixed, percent, shortTime } from '../../controls/numbers';
import { Readout } from '../../controls/readout';
import { currentNoise } from './simulate_axes';
import { describeSpeedUp, speedUp } from './speed_up';
import type { StepTimes } from './speed_up';
import { say } from '../../language/say';

/** A speed below this fraction of real time is called slow motion. */
const REAL_TIME = 0.9;

export function SimulateReadouts() {
  const frame = twin.numbers.value;
  const times = stepTimes(frame);
  const last = twin.samples.value.at(-1);
  const noise = currentNoise(twin.samples.value);
  return (
    <dl class="readouts of-test" tabIndex={0}>
      <Readout
        name="Time"
        value={frame ? `${fixed(frame.time, 2)} s` : '...'}
        note={describePace(frame)}
        width="wide"
        phoneOrder={0}
      />
      <Cost name="Original, per step" seconds={times.original} />
      <Cost name="Optimized, per step" seconds={times.optimized} />
      <Readout
        name="Speed-up"
        value={speedUp(times)}
        note={describeSpeedUp(times)}
        width="narrow"
        phoneOrder={1}
      />
      <Readout
        name="Deviation"
        value={last ? percent(last.mean) : '...'}
        note={noise === null ? '' : say('noise {noise}', { noise: percent(noise) })}
        width="wide"
        phoneOrder={2}
      />
      <Readout
        name="Stretch"
        value={frame ? percent(frame.bodies.original.stretch) : '...'}
        note={frame ? say('optimized {stretch}', { stretch: percent(frame.bodies.optimized.stretch) }) : ''}
        width="widest"
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
  return (
    <Readout
      name={name}
      value={seconds > 0 ? `${figures(1000 * seconds)} ms` : '...'}
      note={
        seconds > 0 ? say('{time}/substep', { time: shortTime(seconds / wants.settings.value.substeps) }) : ''
      }
    />
  );
}

const stepTimes = (frame: TwinFrame | null): StepTimes => ({
  original: frame?.bodies.original.stepSeconds ?? 0,
  optimized: frame?.bodies.optimized.stepSeconds ?? 0,
  haveLattice: haveLattice.value,
});
