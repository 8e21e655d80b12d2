/** Takes a text for which vertices stay as they are, or says why not. */

import { batch, signal } from '@preact/signals';
import { parsePins } from '../../engine/body/pins';
import { changeSettings } from './store';

/** The last text that does not hold, and why. */
export const refusedLock = signal<{ text: string; why: string } | null>(null);

/** A text that does not parse is refused with the engine's sentence, and the locks before it stay. */
export function lockInPlace(text: string): void {
  const lock = text.replaceAll(/\s*([+:,])\s*/g, '$1').trim();
  try {
    parsePins(lock, 'lock');
  } catch (error) {
    refusedLock.value = { text, why: error instanceof Error ? error.message : String(error) };
    return;
  }
  batch(() => {
    refusedLock.value = null;
    changeSettings({ lock });
  });
}
