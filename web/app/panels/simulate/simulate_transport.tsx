/** Below the moving bodies: play, pause, single step, reset, and the curve of their deviation. */

import { reset, stepOnce, twin } from '../../state/simulation';
import { DeviationChart } from './simulate_chart';

export function SimulateTransport() {
  const frame = twin.numbers.value;
  const isOver = frame !== null && (frame.exploded.length > 0 || twin.failure.value !== null);
  const isPlaying = twin.playing.value;
  return (
    <div class="bench">
      <div class="transport" role="group" aria-label="Simulation">
        <button
          type="button"
          class="primary"
          disabled={isOver}
          title="Space"
          onClick={() => (twin.playing.value = !isPlaying)}
        >
          {isPlaying ? 'Pause' : 'Play'}
        </button>
        <button
          type="button"
          disabled={!frame || isOver}
          title="One step of 1/60 s (right arrow)"
          onClick={stepOnce}
        >
          Step
        </button>
        <button
          type="button"
          disabled={!frame && !twin.failure.value}
          title="Back to the start (Home)"
          onClick={reset}
        >
          Reset
        </button>
      </div>
      <DeviationChart />
    </div>
  );
}
