/** The task that finds the vertices named by the text of the pins. */

import { batch } from '@preact/signals';
import { CANCELLED } from '../worker/protocol';
import type { PinsResult } from '../worker/protocol';
import { WorkerLost } from './client';
import type { Client } from './client';
import { besideControl } from './refusal';
import { changeSettings, results, status, wants } from './store';
import { withoutUndo } from './undo';

/**
 * Pins that the body does not have are refused with a sentence, and the earlier ones stay. If this body has no earlier
 * pins, the text stays too, because it may belong to another body of the file. Throws an Error with CANCELLED if the
 * text has changed meanwhile.
 */
export async function findPins(client: Client, body: number): Promise<unknown> {
  const settings = wants.settings.value;
  const text = settings.pins;
  const isOutdated = (): boolean => wants.settings.value.pins !== text;
  try {
    const pins = await client.call<PinsResult>((worker) => worker.pins(body, settings));
    // The shown pins belong to a later stroke.
    if (isOutdated()) throw new Error(CANCELLED);
    if (status.refusedPins.value?.text === text) status.refusedPins.value = null;
    return pins;
  } catch (error) {
    if (!isRefusal(error) || text === '') throw error;
    if (isOutdated()) throw new Error(CANCELLED);
    const { value: last } = results.pins;
    const earlier = last && last.text !== text ? last : null;
    batch(() => {
      status.refusedPins.value = { text, why: besideControl(error) };
      if (earlier) withoutUndo(() => changeSettings({ pins: earlier.text }));
    });
    return earlier;
  }
}

/** Whether an error comes from the text, and not from the worker. */
const isRefusal = (error: unknown): boolean =>
  error instanceof Error && error.message !== CANCELLED && !(error instanceof WorkerLost);
