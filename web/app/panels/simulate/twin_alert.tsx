/** Says why the simulation has stopped, and outlines the side that has diverged. */

import { twin } from '../../state/twin';
import { wants } from '../../state/store';
import type { TwinFrame } from '../../worker/simulation_protocol';
import { isOverlaid, isSimulating } from './simulate_view';
import './twin_alert.css';
import { say, sentence } from '../../language/say';

export function TwinAlert() {
  const frame = twin.numbers.value;
  if (!isSimulating()) return null;
  if (twin.failure.value)
    return (
      <p class="twin-alert" role="alert">
        {sentence(twin.failure.value)}
      </p>
    );
  if (!frame || frame.diverged.length === 0) return null;
  return (
    <>
      {!isOverlaid.value && frame.diverged.map((name) => <div key={name} class={`diverged ${name}`} />)}
      <p class="twin-alert" role="alert">
        {describeDivergence(frame)}
      </p>
    </>
  );
}

function describeDivergence({ diverged, time }: TwinFrame): string {
  const { substeps } = wants.settings.value;
  const cure = say('raise the substeps (now {substeps}) or choose a softer material, then reset.', {
    substeps,
  });
  const values = { time: time.toFixed(2), cure };
  if (diverged.length === 2) return say('Both meshes have diverged at {time} s: {cure}', values);
  return diverged[0] === 'original'
    ? say('The original mesh has diverged at {time} s: {cure}', values)
    : say('The optimized mesh has diverged at {time} s: {cure}', values);
}
