/** Texts that the page refuses, and the wording of errors next to a control. */

import { OPTIONS, SettingError, wordSentence } from '../../engine/settings/options';

/** A text that was refused, and the sentence for the line below its control. */
export interface Refusal {
  text: string;
  why: string;
}

/** An error as a sentence next to the control that it concerns: the control's text is "This". */
export function besideControl(error: unknown): string {
  if (error instanceof SettingError)
    return wordSentence('This', error.sentence, (setting) => `“${OPTIONS[setting].label}”`);
  return error instanceof Error ? error.message : String(error);
}

/** The reason why `check` refuses the text; null if it does not throw. */
export function refusalOf(text: string, check: () => void): Refusal | null {
  try {
    check();
    return null;
  } catch (error) {
    return { text, why: besideControl(error) };
  }
}
