/** What the page opens on its own: the last session of this tab or the request of a link; otherwise it starts empty. */

import { openSample, samples } from './files/samples';
import { awaited, describeFormerLink, describeLinkError, readLink } from './state/link';
import type { Wanted } from './state/link';
import { openFiles } from './state/runner';
import { lastSession, savedSession } from './state/saved_session';
import type { Session } from './state/saved_session';
import { changeEntry, entry } from './state/steps/steps';
import { results, status, wants } from './state/store';
import type { Notice } from './state/store';
import { say, sentence } from './language/say';

/** Call this after `loadSamples`. */
export async function openAtStart(): Promise<void> {
  const isWaiting = isOtherOpen();
  const wanted = readHash();
  const saved = wanted && !isWaiting ? null : await savedSession();
  if (saved) {
    awaited.value = wanted;
    return bringBack(saved);
  }
  const named = new URLSearchParams(location.search).get('sample');
  const asked = samples.value.find(({ id, file }) => id === named || file === wanted?.file);
  if (!asked && wanted?.file) return waitForFile(wanted);
  if (asked) return openSample(asked, wanted ?? undefined);
  if (wanted) awaited.value = wanted;
  else await offerLastSession();
}

function bringBack(session: Session): Promise<void> {
  const stop = afterOpening(() => session.show());
  // If the files cannot be opened, their view must not be applied to the next ones.
  return openFiles(session.files, { asked: session.wanted }).finally(stop);
}

/** Offers to restore the work of the last closed tab while nothing is open. */
async function offerLastSession(): Promise<void> {
  const session = await lastSession();
  if (!session || results.file.value || status.busy.value || status.notice.value) return;
  const run = (): void => void bringBack(session);
  status.notice.value = {
    kind: 'info',
    text: say('Your last work, on {name}, is stored on this computer.', { name: session.name }),
    action: { label: 'Open it', run },
  };
}

/** Runs `show` once files are open, unless the function that it returns is called before. */
function afterOpening(show: () => void): () => void {
  const before = results.opened.value;
  const stop = results.opened.subscribe((opened) => {
    if (opened === before) return;
    queueMicrotask(() => {
      stop();
      show();
    });
  });
  return stop;
}

const removeLink = (): void => changeEntry({ isOtherOpen: false }, location.pathname + location.search);

/** Whether the link of the address still waits for its file, while another file is open. */
const isOtherOpen = (): boolean => entry().isOtherOpen === true;

/** Keeps the link in the address until its file is open, so that it still waits after a reload. */
function removeLinkOnceOpen(): void {
  const before = results.opened.value;
  const stop = results.opened.subscribe((opened) => {
    if (opened === before) return;
    if (awaited.value) return changeEntry({ isOtherOpen: true });
    removeLink();
    queueMicrotask(() => stop());
  });
}

/** A link that the user opens in this page begins anew; Back to a step at which one still waited does not ask for it again. */
function followHash(): void {
  if (entry().step === undefined) location.reload();
  else removeLink();
}

/** What the link asks for; null without a link. A link with an error is reported, and the page starts without it. */
function readHash(): Wanted | null {
  const { hash } = location;
  addEventListener('hashchange', followHash);
  try {
    const wanted = readLink(hash);
    // Once its file is open, a reload restores the session that began with the link.
    if (wanted) removeLinkOnceOpen();
    else removeLink();
    const former = describeFormerLink(hash);
    if (former !== '') showAfterOpening({ kind: 'info', text: `${former}.` });
    return wanted;
  } catch (error) {
    removeLink();
    showAfterOpening({
      kind: 'error',
      text: `${say('The link has an error.')} ${sentence(describeLinkError(error))}`,
    });
    return null;
  }
}

/** Shows the notice now, and again after the first file is open, because opening it removes earlier notices. */
function showAfterOpening(notice: Notice): void {
  status.notice.value = notice;
  afterOpening(() => (status.notice.value = notice));
}

/** Keeps the request of a link until the user opens its file, which a link cannot contain. */
function waitForFile(wanted: Wanted): void {
  awaited.value = wanted;
  wants.settings.value = wanted.settings;
  status.notice.value = {
    kind: 'info',
    text: say('This link is for {file}: open that file.', { file: wanted.file ?? '' }),
  };
}
