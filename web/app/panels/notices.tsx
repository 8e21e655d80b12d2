/** What is running and what has gone wrong, over the upper edge of the viewport. */

import { cancelRunning, resume } from '../state/runner';
import { status } from '../state/store';
import './notices.css';

export function Notices() {
  const notice = status.notice.value;
  return (
    <div class="notices">
      {notice && (
        <div class={`notice ${notice.kind}`} role={notice.kind === 'error' ? 'alert' : 'status'}>
          <span>{notice.text}</span>
          {notice.action && (
            <button type="button" onClick={notice.action.run}>
              {notice.action.label}
            </button>
          )}
          <button
            type="button"
            class="quiet"
            aria-label="Dismiss"
            onClick={() => (status.notice.value = null)}
          >
            Close
          </button>
        </div>
      )}
      <Busy />
      {status.paused.value && !status.busy.value && (
        <div class="notice info" role="status">
          <span>{status.paused.value}: stopped.</span>
          <button type="button" onClick={resume}>
            Run again
          </button>
        </div>
      )}
    </div>
  );
}

function Busy() {
  const busy = status.busy.value;
  if (!busy) return null;
  const { what, progress } = busy;
  const detail =
    progress && progress.phase !== 'idle'
      ? `${progress.phase} ${Math.round(100 * progress.fraction)}\u00a0%`
      : '';
  return (
    <div class="notice busy" role="status">
      <span>
        {what} <span class="muted detail">{detail}</span>
      </span>
      <progress max={1} value={progress?.fraction} aria-label={what} />
      <button type="button" class="quiet" onClick={cancelRunning} title="Esc">
        Cancel
      </button>
    </div>
  );
}
