/** Keeps the file, the settings and the view over a reload of the tab. */

import { effect } from '@preact/signals';
import type { SourceFile } from '../../engine/document/open';
import { readLink, writeLink } from './link';
import type { Wanted } from './link';
import { chooseField, results, shownField, view, wants } from './store';
import type { FieldName, Layout, Step } from './store';

interface Saved {
  link: string;
  step: Step;
  layout: Layout;
  field: FieldName;
}

interface SavedFiles {
  /** names the tab */
  id: string;
  /** ms since 1970 */
  at: number;
  files: SourceFile[];
}

const SETTINGS_KEY = 'limber-session';
const TAB_KEY = 'limber-tab';
const STORE = 'files';
/** The files of at most so many tabs are kept. */
const MOST_TABS = 3;
/** In bytes; larger files are not kept. */
const LARGEST = 400e6;
const REST_MILLISECONDS = 400;

/** Starts to save the settings and the view whenever they change. */
export function startSaving(): void {
  effect(() => {
    const file = results.file.value?.name ?? null;
    const [settings, faces, body] = [wants.settings.value, wants.faces.value, wants.body.value];
    const saved: Saved = {
      link: writeLink({ settings, faces, body, file }),
      step: view.step.value,
      layout: view.layout.value,
      field: shownField.value,
    };
    if (file === null) return;
    const save = () => write(SETTINGS_KEY, JSON.stringify(saved));
    const timer = setTimeout(save, REST_MILLISECONDS);
    // The page may close before the timer ends.
    addEventListener('pagehide', save);
    return () => {
      clearTimeout(timer);
      removeEventListener('pagehide', save);
    };
  });
}

/** Saves a text; where the store is full, the earlier text is removed. */
function write(key: string, text: string): void {
  try {
    sessionStorage.setItem(key, text);
  } catch {
    sessionStorage.removeItem(key);
  }
}

/** Saves the files of this tab, and deletes those of the oldest tabs. */
export async function saveFiles(files: SourceFile[]): Promise<void> {
  if (files.reduce((sum, { bytes }) => sum + bytes.length, 0) > LARGEST) return forgetSession();
  const id = sessionStorage.getItem(TAB_KEY) ?? crypto.randomUUID();
  write(TAB_KEY, id);
  await withStore('readwrite', (store) => {
    const all = allKeys(store);
    all.onsuccess = () => {
      const others = all.result.filter((key) => key[1] !== id).sort(([a], [b]) => b - a);
      for (const key of [...all.result.filter((one) => one[1] === id), ...others.slice(MOST_TABS - 1)])
        store.delete(key);
      store.put({ id, at: Date.now(), files } satisfies SavedFiles);
    };
    return all;
  }).catch(() => forgetSession());
}

function forgetSession(): void {
  sessionStorage.removeItem(SETTINGS_KEY);
}

/** What this tab had open before it was reloaded; null where nothing is saved. */
export async function savedSession(): Promise<{ files: SourceFile[]; wanted: Wanted; show(): void } | null> {
  const [text, id] = [sessionStorage.getItem(SETTINGS_KEY), sessionStorage.getItem(TAB_KEY)];
  if (text === null || id === null) return null;
  try {
    const { link, step, layout, field } = JSON.parse(text) as Saved;
    const wanted = readLink(link);
    const keys = await withStore('readonly', allKeys);
    const key = keys.find((one) => one[1] === id);
    const files =
      key && (await withStore('readonly', (store) => store.get(key) as IDBRequest<SavedFiles>)).files;
    if (!files || !wanted) return null;
    const show = () => {
      view.step.value = step;
      view.layout.value = layout;
      chooseField(field);
    };
    return { files, wanted, show };
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
