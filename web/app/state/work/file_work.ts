/**
 * Stores the work on each file, so that it is restored when the file is opened again. A tab only reads it when it opens
 * a file, so that tabs with the same file do not affect each other; the last change wins.
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
  /** its settings before any work on it */
  fresh: Wanted;
  /** the work as it was last stored or read, see `doneText` */
  last: string;
}

const REST_MILLISECONDS = 400;

let open: OpenWork | null = null;

/** Starts to store the work. */
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

/** The work on a file as a text, without the shown body and the user's preferences for the written format. */
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
    // The browser refuses access to its storage.
  }
}

/** Stores the work on the file that is about to be replaced. */
export function endWork(): void {
  save();
  open = null;
}

/**
 * The earlier work on the file of this key, applied to its initial settings `fresh`; null if nothing is stored. If the
 * file is part of a queue with common settings (`isLinedUp`), only settings that refer to parts of the file are
 * restored.
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

/** Records the work on the file that has just been opened. `isKept`: whether it is shown with its earlier work. */
export function beginWork(
  key: string | null,
  { fresh, name, isKept }: { fresh: Wanted; name: string; isKept: boolean },
): void {
  open = key === null ? null : { key, fresh, last: doneText(readWants()) };
  if (!isKept) return;
  status.notice.value = {
    kind: 'info',
    text: say('Your earlier work on {name} is restored.', { name }),
    action: { label: 'Start anew', run: () => startAnew(fresh) },
  };
}

/** One step of Undo restores the earlier work. */
function startAnew({ settings, faces, own }: Wanted): void {
  batch(() => {
    wants.settings.value = withPerson(settings, wants.settings.value);
    wants.faces.value = faces;
    wants.own.value = own;
    status.notice.value = null;
  });
}
