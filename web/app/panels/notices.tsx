/** Errors and notes, over the upper edge of the viewport. */

import { resume } from '../state/runner';
import { results, status } from '../state/store';
import { Busy } from './busy';
import './notices.css';
import { listed, say, sentence } from '../language/say';

export function Notices() {
  const notice = status.notice.value;
  return (
    <div class="notices">
      {notice && (
        <div class={`notice ${notice.kind}`} role={notice.kind === 'error' ? 'alert' : 'status'}>
          <span>{sentence(notice.text)}</span>
          {notice.action && (
            <button type="button" onClick={notice.action.run}>
              {say(notice.action.label)}
            </button>
          )}
          <button
            type="button"
            class="quiet"
            aria-label={say('Dismiss')}
            onClick={() => (status.notice.value = null)}
          >
            {say('Close')}
          </button>
        </div>
      )}
      {!results.body.value && <Busy />}
      {status.paused.value.length > 0 && !status.busy.value && (
        <div class="notice info" role="status">
          <span>
            {say('{task}: stopped.', { task: listed(status.paused.value.map((what) => say(what))) })}
          </span>
          <button type="button" onClick={resume}>
            {say('Run again')}
          </button>
        </div>
      )}
    </div>
  );
}
