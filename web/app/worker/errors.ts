/** Transfers errors between the page and a worker. Comlink only transfers the message, name and stack of an Error. */

import { transferHandlers } from 'comlink';
import type { TransferHandler } from 'comlink';
import { SettingError } from '../../engine/settings/options';
import type { Sentence, SettingName } from '../../engine/settings/options';

interface CarriedError {
  setting: SettingName;
  sentence: Sentence;
}

/** Comlink's own name for the handler of thrown values. */
const THROWN = 'throw';

/** Makes a SettingError arrive as such, with its setting and its sentence. Both the page and the worker must call this once. */
export function carrySettingErrors(): void {
  const usual = transferHandlers.get(THROWN) as TransferHandler<{ value: unknown }, unknown>;
  const handler: TransferHandler<{ value: unknown }, unknown> = {
    canHandle: usual.canHandle,
    serialize: (thrown) => {
      const { value } = thrown;
      if (!(value instanceof SettingError)) return usual.serialize(thrown);
      const carried: CarriedError = { setting: value.setting, sentence: value.sentence };
      return [{ carried }, []];
    },
    deserialize: (message) => {
      const { carried } = message as { carried?: CarriedError };
      if (carried) throw new SettingError(carried.setting, carried.sentence);
      return usual.deserialize(message);
    },
  };
  transferHandlers.set(THROWN, handler);
}
