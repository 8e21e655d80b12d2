/** Converts the user's settings to the text of a link, and back: values that differ from the defaults, by the names of their flags. */

import { signal } from '@preact/signals';
import {
  OPTIONS,
  SETTING_NAMES,
  SettingError,
  checkSettings,
  wordNote,
  wordSentence,
} from '../../engine/settings/options';
import type { SettingName, Settings } from '../../engine/settings/options';
import { changedSettings, describeRenamedChoices, readSettings } from '../../engine/settings/setting_text';
import { say } from '../language/say';
import { ownFacesText, readOwnFaces } from './own_faces';
import type { OwnFaces } from './own_faces';

export interface Wanted {
  settings: Settings;
  /** kept faces of all bodies without a number of their own; null: half */
  faces: number | null;
  own: OwnFaces;
  body: number;
  /** name of its file; null: any */
  file: string | null;
}

/** The request of a link for a file that is not open yet. */
export const awaited = signal<Wanted | null>(null);

/** Takes the awaited request if it is for the file of this name. */
export function takeAwaited(name: string): Wanted | undefined {
  const wanted = awaited.value;
  if (!wanted || (wanted.file !== null && lastPart(wanted.file) !== lastPart(name))) return undefined;
  awaited.value = null;
  return wanted;
}

const lastPart = (path: string): string => path.split('/').pop()!;

/** Without a leading `#`. */
export function writeLink({ settings, faces, own, body, file }: Wanted): string {
  const words = new URLSearchParams(
    changedSettings(settings).map(({ flag, text }) => [flag, text ?? 'on'] as [string, string]),
  );
  if (faces !== null) words.set('faces', String(faces));
  if (own.size > 0) words.set('own', ownFacesText(own));
  if (body > 0) words.set('body', String(body));
  if (file !== null) words.set('file', file);
  return words.toString();
}

/** The notice on keywords of earlier versions in a link; '' for none. */
export function describeFormerLink(text: string): string {
  const words = new URLSearchParams(text.replace(/^#/, ''));
  const notes = describeRenamedChoices(SETTING_NAMES, (flag) => words.get(flag));
  return notes.map((note) => wordNote(note, (name) => OPTIONS[name].label)).join('; ');
}

/** The request of a link; null for an empty text. Throws SettingError, or an Error with one sentence. */
export function readLink(text: string): Wanted | null {
  const words = new URLSearchParams(text.replace(/^#/, ''));
  if ([...words].length === 0) return null;
  const names = SETTING_NAMES.filter((name) => !OPTIONS[name].isOfMachine);
  const settings = readSettings(names, (flag) => words.get(flag));
  checkSettings(settings);
  return {
    settings,
    faces: wholeOf(words, 'faces'),
    own: ownOf(words),
    body: wholeOf(words, 'body') ?? 0,
    file: words.get('file'),
  };
}

function wholeOf(words: URLSearchParams, name: string): number | null {
  const word = words.get(name);
  if (word === null) return null;
  if (!/^\d+$/.test(word))
    throw new Error(say('The link has {word}: give a whole number.', { word: `${name}=${word}` }));
  return Number(word);
}

function ownOf(words: URLSearchParams): OwnFaces {
  const word = words.get('own');
  if (word === null) return new Map();
  const own = readOwnFaces(word);
  if (own) return own;
  throw new Error(
    say('The link has {word}: give bodies with their faces, as in own=2:400.', { word: `own=${word}` }),
  );
}

/** The reason why `readLink` refuses a link, with its names for settings. */
export function describeLinkError(error: unknown): string {
  const wordOf = (setting: SettingName) => OPTIONS[setting].flag;
  if (error instanceof SettingError)
    return wordSentence(`Its ${wordOf(error.setting)}`, error.sentence, wordOf);
  return error instanceof Error ? error.message : String(error);
}
