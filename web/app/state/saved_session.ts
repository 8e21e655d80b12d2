/** Stores the files, the queue, the settings, the undo history and the view of each tab, for a reload or a later visit. */

import { effect, signal } from '@preact/signals';
import type { SourceFile } from '../../engine/document/open';
import { readLink, writeLink } from './link';
import type { Wanted } from './link';
import { fillQueue, queue } from './queue/queue';
import type { ModelGroup } from './queue/model_groups';
import { forgetTexts, readSaved, storeSaved } from './saved_text';
import type { Saved } from './saved_text';
import { chooseField, results, shownField, view, wants } from './store';
import { liveTabs, ownTab } from './tabs';
import { readUndo, restoreUndo } from './undo';

interface SavedFiles {
  /** names the tab */
  id: string;
  /** ms since 1970 */
  at: number;
  files: SourceFile[];
  /** queued models; their results are not stored */
  queue?: ModelGroup[];
  /** identifies the open files, see Saved; absent in records of earlier versions */
  open?: string;
}

/** The session of a tab. */
export interface Session {
  name: string;
  files: SourceFile[];
  wanted: Wanted;
  /** Must be called once the files are open. */
  show(): void;
}

const SETTINGS_PREFIX = 'limber-session-';
const STORE = 'files';
/** So many tabs that are closed are kept. */
const MAX_CLOSED_TABS = 2;
/** In bytes; larger files are not kept. */
const LARGEST = 400e6;
const REST_MILLISECONDS = 400;

/** Identifies the open files, see Saved. */
const openId = signal('');

/** The settings for the file of this name, as the text of a link; see writeLink. */
export function linkOfWants(file: string | null): string {
  const { settings, faces, own, body } = wants;
  return writeLink({ settings: settings.value, faces: faces.value, own: own.value, body: body.value, file });
}

/** Starts to save the settings and the view whenever they change. */
export async function startSaving(): Promise<void> {
  const { id } = await ownTab;
  effect(() => {
    const file = results.file.value?.name ?? null;
    const saved: Saved = {
      link: linkOfWants(file),
      step: view.step.value,
      layout: view.layout.value,
      field: shownField.value,
      undo: readUndo(),
      hasQueue: queue.value !== null,
      open: openId.value,
    };
    if (file === null) return;
    const save = () => saveText(id, saved);
    const timer = setTimeout(save, REST_MILLISECONDS);
    // The page may close before the timer ends.
    addEventListener('pagehide', save);
    return () => {
      clearTimeout(timer);
      removeEventListener('pagehide', save);
    };
  });
}

function saveText(id: string, saved: Saved): void {
  try {
    storeSaved(localStorage, SETTINGS_PREFIX + id, saved);
  } catch {
    // The browser refuses access to its storage.
  }
}

/** Saves the files of this tab in place of its earlier ones, and deletes those of long closed tabs. */
export async function saveFiles(files: SourceFile[]): Promise<void> {
  const open = (openId.value = crypto.randomUUID());
  const { id } = await ownTab;
  const live = await liveTabs();
  try {
    await withStore('readwrite', (store) => deleteOld(store, id, live));
    // Files that have been opened meanwhile are saved instead.
    if (isTooLarge(files) || open !== openId.value) return;
    const record: SavedFiles = { id, at: Date.now(), files, queue: queueBeside(files), open };
    await withStore('readwrite', (store) => store.put(record));
  } catch {
    // If the browser refuses, nothing is restored after a reload.
  }
}

/** The queued models; none if their total is too large. */
function queueBeside(files: SourceFile[]): ModelGroup[] {
  const groups = (queue.value?.items ?? []).map((item) => ({ name: item.name, files: item.files }));
  return isTooLarge([...files, ...groups.flatMap((group) => group.files)]) ? [] : groups;
}

/** Files that several models share are stored once. */
const isTooLarge = (files: SourceFile[]): boolean =>
  [...new Set(files)].reduce((sum, { bytes }) => sum + bytes.length, 0) > LARGEST;

/** Deletes the files of this tab and of long closed tabs. */
function deleteOld(store: IDBObjectStore, id: string, live: ReadonlySet<string>): IDBRequest<TabKey[]> {
  const all = allKeys(store);
  all.onsuccess = () => {
    const closed = all.result.filter((key) => !live.has(key[1])).sort(([a], [b]) => b - a);
    for (const key of all.result.filter((one) => one[1] === id)) store.delete(key);
    for (const key of closed.slice(MAX_CLOSED_TABS)) store.delete(key);
    // Tabs whose files could not be saved have a text alone, which nothing brings back.
    const kept = closed.slice(0, MAX_CLOSED_TABS).map((key) => key[1]);
    forgetTexts(localStorage, SETTINGS_PREFIX, new Set([...live, ...kept]));
  };
  return all;
}

/** The session of this tab before its reload, or of the tab that it is a copy of; null if nothing is saved. */
export async function savedSession(): Promise<Session | null> {
  const { source } = await ownTab;
  return source === null ? null : sessionOf(source);
}

/** The newest session of the closed tabs; null if there is none. */
export async function lastSession(): Promise<Session | null> {
  try {
    const live = await liveTabs();
    const keys = await withStore('readonly', allKeys);
    const closed = keys.filter((key) => !live.has(key[1])).sort(([a], [b]) => b - a);
    return closed.length > 0 ? await sessionOf(closed[0][1]) : null;
  } catch {
    return null;
  }
}

async function sessionOf(id: string): Promise<Session | null> {
  const text = localStorage.getItem(SETTINGS_PREFIX + id);
  if (text === null) return null;
  try {
    const { link, step, layout, field, undo, hasQueue, open } = readSaved(text);
    const wanted = readLink(link);
    const keys = await withStore('readonly', allKeys);
    const key = keys.findLast((one) => one[1] === id);
    const saved = key && (await withStore('readonly', (store) => store.get(key) as IDBRequest<SavedFiles>));
    // The text may belong to files that could not be saved.
    if (!saved || (saved.open ?? '') !== open || !wanted) return null;
    const { files, queue: groups = [] } = saved;
    const show = () => {
      view.step.value = step;
      view.layout.value = layout;
      chooseField(field);
      restoreUndo(undo);
      if (hasQueue && groups.length > 0) fillQueue(groups);
    };
    return { name: wanted.file ?? files[0].name, files, wanted, show };
  } catch {
    return null;
  }
}

type TabKey = [at: number, id: string];

const allKeys = (store: IDBObjectStore) => store.getAllKeys() as IDBRequest as IDBRequest<TabKey[]>;

function withStore<T>(mode: IDBTransactionMode, ask: (store: IDBObjectStore) => IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    const opening = indexedDB.open('limber', 1);
    opening.onupgradeneeded = () => opening.result.createObjectStore(STORE, { keyPath: ['at', 'id'] });
    opening.onerror = () => reject(opening.error);
    opening.onsuccess = () => {
      const transaction = opening.result.transaction(STORE, mode);
      const request = ask(transaction.objectStore(STORE));
      transaction.oncomplete = () => {
        opening.result.close();
        resolve(request.result);
      };
      transaction.onerror = () => reject(transaction.error);
      transaction.onabort = () => reject(transaction.error);
    };
  });
}
