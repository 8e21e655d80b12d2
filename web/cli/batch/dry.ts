/** The dry run of a batch. */

import { join } from 'node:path';
import type { Arguments } from '../arguments';
import { EXIT } from '../failure';
import { counted } from '../../engine/core/words';
import { inOneLine } from '../words';
import type { Journal } from './journal';
import type { AssetRequest } from './orders';
import { reasonOf } from './run';

/** Names every asset that would be done, and why; does no work, and makes no folder. */
export async function runDryBatch(
  { batch: { again } }: Pick<Arguments, 'batch'>,
  out: string,
  requests: AssetRequest[],
  journal: Journal,
): Promise<number> {
  let unchanged = 0;
  for (const request of requests) {
    const found = await reasonOf(request, out, journal).catch(() => 'not readable' as const);
    const reason = again && found === null ? 'asked for' : found;
    if (reason === null) ++unchanged;
    else {
      const { asset, options } = request;
      const asked = JSON.stringify(options, (_, value: unknown) => (value === Infinity ? 'inf' : value));
      const line = `${asset.path} (${reason}) -> ${join(out, asset.result)}${asked === '{}' ? '' : ` ${asked}`}`;
      process.stdout.write(`${inOneLine(line)}\n`);
    }
  }
  const todo = counted(requests.length - unchanged, 'asset');
  process.stdout.write(`would optimize ${todo}; ${unchanged} up to date\n`);
  return EXIT.done;
}
