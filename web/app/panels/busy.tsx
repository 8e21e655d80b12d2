/** The running work, its progress and the remaining time. */

import { Spoken } from '../controls/spoken';
import { describeLeft, shareDone } from '../state/remaining';
import { cancelRunning } from '../state/runner';
import { status } from '../state/store';
import type { CallProgress } from '../worker/protocol';
import './busy.css';
import { say } from '../language/say';

export function Busy() {
  const busy = status.busy.value;
  if (!busy) return null;
  const { what, progress, left } = busy;
  return (
    <div class="notice busy">
      <Spoken text={say(what)} />
      <span class="what">{say(what)}</span>
      <progress max={1} value={shareDone(progress) ?? undefined} aria-label={say(what)} />
      <span class="muted detail">{describeProgress(progress, left)}</span>
      <button type="button" class="quiet" onClick={cancelRunning} title={say('Esc')}>
        {say('Cancel')}
      </button>
    </div>
  );
}

/** "24 %, 40 s left" for all bodies of a file, otherwise the phase, too: last, because narrow layouts truncate the end. */
function describeProgress(progress: CallProgress | null, seconds: number | null): string {
  const left = describeLeft(seconds);
  const share = shareDone(progress);
  if (!progress || share === null) return '';
  const phase = progress.share === undefined ? ` · ${say(progress.phase)}` : '';
  return `${Math.floor(100 * share)}\u00a0%${left}${phase}`;
}
