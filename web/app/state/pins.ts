/** Takes a text for what is held in place, or says why not. */

import { batch } from '@preact/signals';
import { parsePins } from '../../engine/body/pins';
import { changeSettings, status } from './store';

/** A text that does not parse is refused with the engine's sentence, and the pins before it stay. */
export function holdInPlace(text: string): void {
  const pins = text.replaceAll(/\s*([+:,])\s*/g, '$1').trim();
  try {
    parsePins(pins);
  } catch (error) {
    status.refusedPins.value = { text, why: error instanceof Error ? error.message : String(error) };
    return;
  }
  batch(() => {
    status.refusedPins.value = null;
    changeSettings({ pins });
  });
}
