/** The task that finds the vertices that the text of the pins names. */

import { batch } from '@preact/signals';
import { CANCELLED } from '../worker/protocol';
import type { PinsResult } from '../worker/protocol';
import type { Client } from './client';
import { besideControl } from './refusal';
import { changeSettings, results, status, wants } from './store';
import { withoutUndo } from './undo';

/** Pins that the body does not have are refused with a sentence, and the earlier ones stay; a new file begins with none. */
export async function findPins(client: Client, body: number): Promise<unknown> {
  const settings = wants.settings.value;
  const text = settings.pins;
  try {
    const pins = await client.call<PinsResult>((worker) => worker.pins(body, settings));
    if (status.refusedPins.value?.text === text) status.refusedPins.value = null;
    return pins;
  } catch (error) {
    if (!(error instanceof Error) || error.message === CANCELLED || text === '') throw error;
    const last = results.pins.value;
    batch(() => {
      status.refusedPins.value = { text, why: besideControl(error) };
      withoutUndo(() => changeSettings({ pins: last && last.text !== text ? last.text : '' }));
    });
    return last;
  }
}
