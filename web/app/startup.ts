/** What the page opens by itself: what this tab had before, what a link asks for, or the first sample. */

import { openSample, samples } from './panels/model/samples';
import { awaited, describeLinkError, readLink } from './state/link';
import type { Wanted } from './state/link';
import { openFiles } from './state/runner';
import { savedSession } from './state/saved_session';
import { results, status, wants } from './state/store';

const FIRST_SAMPLE = 'tower';

/** `samples` must be known. */
export async function begin(): Promise<void> {
  const wanted = readHash();
  const saved = wanted ? null : await savedSession();
  if (saved) {
    const opening = openFiles(saved.files, saved.wanted);
    saved.show();
    return opening;
  }
  const named = new URLSearchParams(location.search).get('sample');
  const asked = samples.value.find(({ id, file }) => id === named || file === wanted?.file);
  if (!asked && wanted?.file) return waitForFile(wanted);
  const first = asked ?? samples.value.find(({ id }) => id === FIRST_SAMPLE);
  if (first) await openSample(first, wanted ?? undefined);
}

/** A link that does not hold is told of, and the page begins as without it. */
function readHash(): Wanted | null {
  const { hash } = location;
  // Read once: a reload brings back what has been made of it.
  history.replaceState(null, '', location.pathname + location.search);
  addEventListener('hashchange', () => location.reload());
  try {
    return readLink(hash);
  } catch (error) {
    showErrorAfterOpening(`The link does not hold. ${describeLinkError(error)}`);
    return null;
  }
}

/** Opening the first file takes earlier notices away. */
function showErrorAfterOpening(text: string): void {
  const stop = results.opened.subscribe((opened) => {
    if (opened === 0) return;
    queueMicrotask(() => {
      stop();
      status.notice.value = { kind: 'error', text };
    });
  });
}

/** A link cannot carry a file: whoever has it opens it. */
function waitForFile(wanted: Wanted): void {
  awaited.value = wanted;
  wants.settings.value = wanted.settings;
  status.notice.value = { kind: 'info', text: `This link is for ${wanted.file}: open that file.` };
}
