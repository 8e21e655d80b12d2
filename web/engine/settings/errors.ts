/** Why a setting is refused: the setting, and a sentence about it that each host words for its readers. */

import { OPTIONS } from './table';
import type { SettingName } from './table';

/**
 * A sentence without its subject, which is the setting: "is 2: give a number from 0 to 1." Other settings stand in it by name,
 * so that a host can call them flags or controls. Plain data.
 */
export type Sentence = readonly (string | { setting: SettingName })[];

/** The value of a setting is refused, by itself or for a body. Its message calls settings by their labels. */
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

/** The whole sentence with this subject; `nameOf` says what the reader knows other settings as. */
export function wordSentence(
  subject: string,
  sentence: Sentence,
  nameOf: (setting: SettingName) => string,
): string {
  const words = sentence.map((part) => (typeof part === 'string' ? part : nameOf(part.setting)));
  return `${subject} ${words.join('')}`;
}
