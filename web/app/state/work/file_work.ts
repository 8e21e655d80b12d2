/**
 * Keeps what is done to each file, so that it comes back when the file is opened again. A tab reads it only as it opens a file, so that
 * tabs with the same file open do not change each other's work; what was done last is kept.
 */

import { batch, effect } from '@preact/signals';
import { fileSettings, withPerson } from '../../../engine/settings/options';
import { writeLink } from '../link';
import type { Wanted } from '../link';
import { status, wants } from '../store';
import { say } from '../../language/say';
import { forgetWork, keepWork, readWork } from './kept_work';

interface OpenWork {
  /** of the file, see contentKey */
  key: string;
  /** what is wanted of it where nothing was done to it */
  fresh: Wanted;
  /** what has been done as it was last kept or read, see `doneText` */
  last: string;
}

const REST_MILLISECONDS = 400;

let open: OpenWork | null = null;

/** Starts to keep what is done. */
export function startKeepingWork(): void {
  effect(() => {
    readWants();
    const timer = setTimeout(save, REST_MILLISECONDS);
    return () => clearTimeout(timer);
  });
  // The page may close before the timer ends.
  addEventListener('pagehide', save);
}

const readWants = (): Wanted => ({
  settings: wants.settings.value,
  faces: wants.faces.value,
  own: wants.own.value,
  body: wants.body.value,
  file: null,
});

/** What has been done to a file as a text: which of its bodies is shown and how its user likes results written is no part of it. */
const doneText = (wanted: Wanted): string => workText({ ...wanted, body: 0 });

const workText = (wanted: Wanted): string =>
  writeLink({ ...wanted, settings: withPerson(wanted.settings, null), file: null });

function save(): void {
  if (!open) return;
  const wanted = readWants();
  const done = doneText(wanted);
  if (done === open.last) return;
  open.last = done;
  try {
    if (done === doneText(open.fresh)) forgetWork(localStorage, open.key);
    else keepWork(localStorage, open.key, { link: workText(wanted), at: Date.now() });
  } catch {
    // The browser refuses its store.
  }
}

/** Keeps what was done to the file that is about to be replaced. */
export function endWork(): void {
  save();
  open = null;
}

/**
 * What was done to the file of this key before, where it is to be shown anew as `fresh`; null where nothing is kept. Where the file is one
 * of several with one setting (`isLinedUp`) only what names parts of it comes back.
 */
export function workBefore(key: string | null, fresh: Wanted, isLinedUp: boolean): Wanted | null {
  const kept = key === null ? null : readKept(key);
  if (!kept) return null;
  const before = isLinedUp
    ? { ...kept, faces: fresh.faces, settings: fileSettings(kept.settings, fresh.settings) }
    : { ...kept, settings: withPerson(kept.settings, fresh.settings) };
  return doneText(before) === doneText(fresh) ? null : before;
}

function readKept(key: string): Wanted | null {
  try {
    return readWork(localStorage, key);
  } catch {
    return null;
  }
}

/** Follows what is done to the file that has just been opened. `isKept`: whether it is shown with what was done before. */
export function beginWork(
  key: string | null,
  { fresh, name, isKept }: { fresh: Wanted; name: string; isKept: boolean },
): void {
  open = key === null ? null : { key, fresh, last: doneText(readWants()) };
  if (!isKept) return;
  status.notice.value = {
    kind: 'info',
    text: say('What you did to {name} before is here again.', { name }),
    action: { label: 'Start anew', run: () => startAnew(fresh) },
  };
}

/** One step of Undo brings back what was done. */
function startAnew({ settings, faces, own }: Wanted): void {
  batch(() => {
    wants.settings.value = withPerson(settings, wants.settings.value);
    wants.faces.value = faces;
    wants.own.value = own;
    status.notice.value = null;
  });
}
