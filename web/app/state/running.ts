/** The only client of the page, and its progress and error messages. */

import { Client, WorkerLost } from './client';
import { isMissingFile, reloadPage } from './offline';
import type { CallProgress } from '../worker/protocol';
import { remainingTime, shareDone } from './remaining';
import { Replayer } from './replayer';
import { status } from './store';
import type { Notice } from './store';
import { say, sentence } from '../language/say';

const SLOW_MILLISECONDS = 200;
/** ms between two updates of the progress: every repaint of the page takes time from the computation. */
const LOOK_MILLISECONDS = 100;
/** A call without progress for this long may be stuck. */
const STUCK_MILLISECONDS = 60_000;

const base = new URL('.', document.baseURI).href;

export const replayer = new Replayer(base);

export const client = new Client(base, tellRestarted, (port) => replayer.listen(port));

function tellRestarted(): void {
  status.notice.value = {
    kind: 'info',
    text: say('The computation has stopped unexpectedly. It was restarted, and your work is unchanged.'),
  };
}

export function complain(error: unknown): void {
  status.notice.value = noticeOf(error);
}

function noticeOf(error: unknown): Notice {
  const text = error instanceof Error ? error.message : String(error);
  if (isMissingFile(error))
    return {
      kind: 'error',
      text: say(
        'A part of the page could not be loaded: the network is down, or there is a new version. Reload; your work is restored.',
      ),
      action: { label: 'Reload', run: reloadPage },
    };
  if (error instanceof WorkerLost)
    return {
      kind: 'error',
      text: say('The computation has stopped unexpectedly: {why}. Your file and your settings are kept.', {
        why: sentence(text),
      }),
    };
  return { kind: 'error', text };
}

/** Shows the progress while `make` runs, unless it is quick. */
export async function whileBusy<T>(what: string, make: () => Promise<T>): Promise<T> {
  let begin = performance.now();
  let phase = '';
  const isStuck = stuckness();
  const remaining = remainingTime();
  const show = () => {
    const progress = client.progress();
    const now = performance.now();
    const own = progress?.share === undefined ? (progress?.phase ?? '') : 'bodies';
    if (own !== phase) [phase, begin] = [own, now];
    const left = remaining((now - begin) / 1000, shareDone(progress));
    status.busy.value = { what, progress, left };
    if (isStuck(progress)) offerRestart(what);
    timer = setTimeout(show, LOOK_MILLISECONDS);
  };
  let timer = setTimeout(show, SLOW_MILLISECONDS);
  try {
    return await make();
  } finally {
    clearTimeout(timer);
    status.busy.value = null;
  }
}

/** Shows a notice once if the progress has not changed for too long. */
function stuckness(): (progress: CallProgress | null) => boolean {
  let [last, since, isTold] = ['', performance.now(), false];
  return (progress) => {
    const [text, now] = [JSON.stringify(progress), performance.now()];
    if (text !== last) [last, since] = [text, now];
    if (isTold || now - since < STUCK_MILLISECONDS) return false;
    return (isTold = true);
  };
}

function offerRestart(what: string): void {
  const run = (): void => {
    status.notice.value = null;
    client.forceCancel();
  };
  status.notice.value = {
    kind: 'info',
    text: say('{task}: no progress for a minute. It may need more time or be stuck.', {
      task: say(what),
    }),
    action: { label: 'Start again', run },
  };
}
