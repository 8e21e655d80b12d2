/** What is running, how far it is and how long it will take. */

import { Spoken } from '../controls/spoken';
import { cancelRunning } from '../state/runner';
import { status } from '../state/store';
import type { CallProgress } from '../worker/protocol';
import './busy.css';
import { say } from '../language/say';

export function Busy() {
  const busy = status.busy.value;
  if (!busy) return null;
  const { what, progress, seconds } = busy;
  return (
    <div class="notice busy">
      <Spoken text={say(what)} />
      <span>
        {say(what)} <span class="muted detail">{describeProgress(progress, seconds)}</span>
      </span>
      <progress max={1} value={shareDone(progress) ?? undefined} aria-label={say(what)} />
      <button type="button" class="quiet" onClick={cancelRunning} title={say('Esc')}>
        {say('Cancel')}
      </button>
    </div>
  );
}

/** "7 of 29, 40 s left" for a file of several bodies, otherwise the phase and how far it is. */
function describeProgress(progress: CallProgress | null, seconds: number): string {
  const left = describeLeft(shareDone(progress), seconds);
  if (progress?.part)
    return `${say('{number} of {all}', { number: progress.part.number, all: progress.part.of })}${left}`;
  if (!progress || progress.phase === 'idle') return '';
  return `${say(progress.phase)} ${Math.round(100 * progress.fraction)}\u00a0%${left}`;
}

/** 0..1 of the bodies, or of the phase of a single one; null where nothing is known. */
function shareDone(progress: CallProgress | null): number | null {
  if (!progress) return null;
  const { part, fraction, phase } = progress;
  if (part) return (part.number - 1) / part.of;
  return phase === 'idle' ? null : fraction;
}

/** No time is told before so much is done, as it would be a guess, nor a time that is not worth reading. */
const LEAST_DONE = 0.08;
const LEAST_SECONDS = 3;

/** `seconds`: since the body or phase that `share` counts has begun. */
function describeLeft(share: number | null, seconds: number): string {
  if (share === null || share < LEAST_DONE) return '';
  const left = (seconds * (1 - share)) / share;
  if (left < LEAST_SECONDS) return '';
  return left < 90
    ? say(', {seconds} s left', { seconds: Math.round(left) })
    : say(', {minutes} min left', { minutes: Math.round(left / 60) });
}
