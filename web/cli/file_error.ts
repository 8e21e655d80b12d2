/** Errors of the file system as sentences. */

import { UsageError } from './failure';

const REASONS: Record<string, string> = {
  ENOENT: 'there is no such file',
  ENOTDIR: 'a part of its path is a file, not a folder',
  EACCES: 'permission is denied',
  EPERM: 'permission is denied',
  ENOSPC: 'the disk is full',
  EDQUOT: 'the disk quota is used up',
  EROFS: 'the disk is read-only',
  ELOOP: 'its links form a loop',
  ENAMETOOLONG: 'its name is too long',
  ERR_FS_FILE_TOO_LARGE: 'it is larger than 2 GB',
};

/** Calls `write`, which writes to `path`. Throws UsageError if the system refuses. */
export function writing<Value>(path: string, write: () => Value): Value {
  try {
    return write();
  } catch (error) {
    throw fileError(`${path} cannot be written`, error);
  }
}

/** `what`: the beginning of the sentence, such as "a.glb cannot be written". */
export function fileError(what: string, error: unknown): Error {
  if (error instanceof UsageError) return error;
  const { code = '' } = error as NodeJS.ErrnoException;
  const reason = REASONS[code] ?? `the system refused it${code ? ` (${code})` : ''}`;
  return new UsageError(`${what}: ${reason}.`);
}
