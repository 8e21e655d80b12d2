/** Says why the simulation has stopped, and outlines the side that has diverged. */

import { twin } from '../../state/twin';
import { wants } from '../../state/store';
import type { TwinFrame } from '../../worker/simulation_protocol';
import { isOverlaid, isSimulating } from './simulate_view';
import './twin_alert.css';

export function TwinAlert() {
  const frame = twin.numbers.value;
  if (!isSimulating()) return null;
  if (twin.failure.value)
    return (
      <p class="twin-alert" role="alert">
        {twin.failure.value}
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
  const subject = diverged.length === 2 ? 'Both meshes have' : `The ${diverged[0]} mesh has`;
  return (
    `${subject} diverged at ${time.toFixed(2)} s: raise the substeps (now ${substeps}) ` +
    'or take a softer material, then reset.'
  );
}
