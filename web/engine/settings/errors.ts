/** Errors about settings, in a form in which each host can name settings in its own way. */

import { OPTIONS } from './table';
import type { SettingName } from './table';

/** Text with placeholders for settings, so that a host can call them flags or controls. Plain data. */
export type Note = readonly (string | { setting: SettingName })[];

/** A sentence without its subject, which is a setting: "is 2: give a number from 0 to 1." */
export type Sentence = Note;

/** A refused value of a setting, by itself or for a body. Its message calls settings by their labels. */
export class SettingError extends Error {
  readonly sentence: Sentence;

  constructor(
    readonly setting: SettingName,
    sentence: string | Sentence,
  ) {
    const parts = typeof sentence === 'string' ? [sentence] : sentence;
    const labelOf = (name: SettingName) => `“${OPTIONS[name].label}”`;
    super(wordSentence(labelOf(setting), parts, labelOf));
    this.sentence = parts;
  }
}

/** The sentence of an error with its subject; `nameOf` gives the reader's name for other settings. */
export const wordSentence = (
  subject: string,
  sentence: Sentence,
  nameOf: (setting: SettingName) => string,
): string => `${subject} ${wordNote(sentence, nameOf)}`;

/** The text of a note, with settings named by `nameOf`. */
export const wordNote = (note: Note, nameOf: (setting: SettingName) => string): string =>
  note.map((part) => (typeof part === 'string' ? part : nameOf(part.setting))).join('');
