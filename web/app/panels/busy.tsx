/** What is running, how far it is and how long it will take. */

import { Spoken } from '../controls/spoken';
import { shareDone } from '../state/remaining';
import { cancelRunning } from '../state/runner';
import { status } from '../state/store';
import type { CallProgress } from '../worker/protocol';
import './busy.css';

export function Busy() {
  const busy = status.busy.value;
  if (!busy) return null;
  const { what, progress, left } = busy;
  return (
    <div class="notice busy">
      <Spoken text={what} />
      <span>
        {what} <span class="muted detail">{describeProgress(progress, left)}</span>
      </span>
      <progress max={1} value={shareDone(progress) ?? undefined} aria-label={what} />
      <button type="button" class="quiet" onClick={cancelRunning} title="Esc">
        Cancel
      </button>
    </div>
  );
}

/** "7 of 29, 40 s left" for a file of several bodies, otherwise the phase and how far it is. */
function describeProgress(progress: CallProgress | null, seconds: number | null): string {
  const left = describeLeft(seconds);
  if (progress?.part) return `${progress.part.number} of ${progress.part.of}${left}`;
  if (!progress || progress.phase === 'idle') return '';
  return `${progress.phase} ${Math.round(100 * progress.fraction)}\u00a0%${left}`;
}

const describeLeft = (left: number | null): string =>
  left === null ? '' : `, ${left < 90 ? `${Math.round(left)} s` : `${Math.round(left / 60)} min`} left`;
