/** What the user wants as the text of a link, and back: only what is not as it comes, in the words of the flags. */

import { signal } from '@preact/signals';
import { OPTIONS, checkSettings, defaultSettings } from '../../engine/settings/options';
import type { Settings } from '../../engine/settings/options';
import { changedSettings, readSetting } from '../../engine/settings/setting_text';

export interface Wanted {
  settings: Settings;
  /** kept faces of the shown body; null: half */
  faces: number | null;
  body: number;
  /** name of the file that it was wanted for; null: of any */
  file: string | null;
}

/** What a link asks of a file that is not open yet. */
export const awaited = signal<Wanted | null>(null);

/** What is asked of the file of this name, once. */
export function takeAwaited(name: string): Wanted | undefined {
  const wanted = awaited.value;
  if (!wanted?.file || lastPart(wanted.file) !== lastPart(name)) return undefined;
  awaited.value = null;
  return wanted;
}

const lastPart = (path: string): string => path.split('/').pop()!;

/** Without a leading `#`. */
export function writeLink({ settings, faces, body, file }: Wanted): string {
  const words = new URLSearchParams(
    changedSettings(settings).map(({ flag, text }) => [flag, text ?? 'on'] as [string, string]),
  );
  if (faces !== null) words.set('faces', String(faces));
  if (body > 0) words.set('body', String(body));
  if (file !== null) words.set('file', file);
  return words.toString();
}

/** Throws one sentence that names what does not hold; null for an empty text. */
export function readLink(text: string): Wanted | null {
  const words = new URLSearchParams(text.replace(/^#/, ''));
  if ([...words].length === 0) return null;
  const method = OPTIONS.method.choices!.find((name) => name === words.get('method')) as Settings['method'];
  const settings = defaultSettings(method);
  for (const key of Object.keys(OPTIONS) as (keyof Settings)[]) {
    const word = words.get(OPTIONS[key].flag);
    if (word !== null && key !== 'threads')
      Object.assign(settings, { [key]: readSetting(OPTIONS[key], word) });
  }
  checkSettings(settings);
  return {
    settings,
    faces: wholeOf(words, 'faces'),
    body: wholeOf(words, 'body') ?? 0,
    file: words.get('file'),
  };
}

function wholeOf(words: URLSearchParams, name: string): number | null {
  const word = words.get(name);
  if (word === null) return null;
  if (!/^\d+$/.test(word)) throw new Error(`The link has ${name}=${word}: give a whole number.`);
  return Number(word);
}
