/** Whether an asset has to be done. */

import type { AssetRecord, WrittenFile } from './record';

/** Why an asset is done; null: its results are up to date. */
export type Reason =
  'new' | 'failed before' | 'changed' | 'result missing' | 'result changed' | 'asked for' | null;

/**
 * `record`: what is remembered of it. `key`: of its input and options now. `hashOfResult`: the SHA-256 of a result as it is now, null where
 * it is gone. Failures are tried again, since what failed may have been the machine.
 */
export async function reasonToDo(
  record: AssetRecord | undefined,
  key: () => Promise<string>,
  hashOfResult: (file: WrittenFile) => string | null,
): Promise<Reason> {
  if (!record) return 'new';
  if (record.state === 'failed') return 'failed before';
  if (record.key !== (await key())) return 'changed';
  const hashes = record.written.map((file) => ({ file, hash: hashOfResult(file) }));
  if (hashes.some(({ hash }) => hash === null)) return 'result missing';
  return hashes.some(({ file, hash }) => hash !== file.sha256) ? 'result changed' : null;
}
