/** Sets the text of the pins, or explains why it is refused. */

import { batch } from '@preact/signals';
import { checkSetting } from '../../engine/settings/options';
import { refusalOf } from './refusal';
import { changeSettings, status } from './store';

/** A text that does not have the form of pins is refused with a sentence, and the earlier pins are kept. */
export function setPins(text: string): void {
  const pins = text.replaceAll(/\s*([+:,])\s*/g, '$1').trim();
  batch(() => {
    const refusal = refusalOf(text, () => checkSetting('pins', pins));
    status.refusedPins.value = refusal;
    if (!refusal) changeSettings({ pins });
  });
}
