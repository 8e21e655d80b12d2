/** Sets the text of the locked vertices, or explains why it is refused. */

import { batch, signal } from '@preact/signals';
import { checkSetting } from '../../engine/settings/options';
import { refusalOf } from './refusal';
import type { Refusal } from './refusal';
import { changeSettings } from './store';

/** The last text, if it was refused. */
export const refusedLock = signal<Refusal | null>(null);

/** A text that does not have the form of pins is refused with a sentence, and the earlier locks are kept. */
export function setLock(text: string): void {
  const lock = text.replaceAll(/\s*([+:,])\s*/g, '$1').trim();
  batch(() => {
    const refusal = refusalOf(text, () => checkSetting('lock', lock));
    refusedLock.value = refusal;
    if (!refusal) changeSettings({ lock });
  });
}
