/** Below the moving bodies: Play, Pause, Step, Reset, and the chart of their deviation. */

import { reset, stepOnce } from '../../state/simulation';
import { twin } from '../../state/twin';
import { DeviationChart } from './simulate_chart';
import './simulate_transport.css';
import { say } from '../../language/say';

export function SimulateTransport() {
  return (
    <div class="simulation">
      <Buttons />
      <DeviationChart />
    </div>
  );
}

function Buttons() {
  const frame = twin.numbers.value;
  const isOver = frame !== null && (frame.diverged.length > 0 || twin.failure.value !== null);
  const isPlaying = twin.playing.value;
  return (
    <div class="transport" role="group" aria-label={say('Simulation')}>
      <button
        type="button"
        class="primary"
        disabled={isOver}
        title={say('Space')}
        onClick={() => (twin.playing.value = !isPlaying)}
      >
        {isPlaying ? say('Pause') : say('Play')}
      </button>
      <button
        type="button"
        disabled={!frame || isOver}
        title={say('One step of 1/60 s (right arrow)')}
        onClick={stepOnce}
      >
        {say('Step')}
      </button>
      <button
        type="button"
        disabled={!frame && !twin.failure.value}
        title={say('Back to the start (Home)')}
        onClick={reset}
      >
        {say('Reset')}
      </button>
    </div>
  );
}
