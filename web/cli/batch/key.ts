/** Hashes: of all that a result follows from, and of what was written. */

import { createHash } from 'node:crypto';
import { VERSION } from '../../engine/core/version';
import type { SourceFile } from '../../engine/document/open';
import { OPTIONS, SETTING_NAMES } from '../../engine/settings/options';
import { TARGET_NAMES } from '../../engine/settings/batch_config';
import type { AssetRequest } from './orders';

/** Later versions of the journal remember more, so that what older ones wrote is made again. */
const KEY_VERSION = 'limber-batch-key/2';

/**
 * SHA-256 of the input with its companions, the options as they count, the name of the result, and the version of limber. Two
 * assets with one key have the same results, on any machine and number of threads.
 */
export function keyOf(
  files: SourceFile[],
  asked: Pick<AssetRequest, 'options' | 'fromPreset'>,
  result: string,
): string {
  const hash = createHash('sha256');
  const add = (text: string) => hash.update(`${Buffer.byteLength(text)}:${text};`);
  [KEY_VERSION, VERSION, result, canonicalOptions(asked)].forEach(add);
  for (const { name, bytes } of [files[0], ...files.slice(1).sort(byName)]) {
    add(name);
    add(String(bytes.length));
    hash.update(bytes);
  }
  return hash.digest('hex');
}

const byName = (a: SourceFile, b: SourceFile): number => (a.name < b.name ? -1 : Number(a.name > b.name));

/** Options in the order of the table, with a mark of what only a preset sets; what describes the machine has no part in results. */
function canonicalOptions({ options, fromPreset }: Pick<AssetRequest, 'options' | 'fromPreset'>): string {
  const names = [...SETTING_NAMES.filter((name) => !OPTIONS[name].isOfMachine), ...TARGET_NAMES];
  const given = names.filter((name) => options[name] !== undefined);
  const entries = given.map((name) => [
    ...[name, options[name] === Infinity ? 'inf' : options[name]],
    ...(fromPreset.some((other) => other === name) ? ['preset'] : []),
  ]);
  return JSON.stringify(entries);
}

export const hashOf = (bytes: Uint8Array | string): string =>
  createHash('sha256').update(bytes).digest('hex');
