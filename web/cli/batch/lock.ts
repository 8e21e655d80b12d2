/** One batch at a time works on a folder. */

import { linkSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { UsageError } from '../failure';
import { fileError } from '../file_error';
import { isAtWork, thisProcess } from '../output_files/owner';
import type { Owner } from '../output_files/owner';

/** Takes the lock of `folder`; a lock whose process has ended is taken over. Throws UsageError where another batch is at work. */
export function takeLock(folder: string, out: string): () => void {
  const path = join(folder, 'lock.json');
  const own = thisProcess();
  for (let tries = 0; !created(path, own); ++tries) {
    const owner = ownerOf(path);
    if (tries > 2 || (owner && isAtWork(owner)))
      throw new UsageError(
        `Another batch is at work on ${out}${owner ? ` (process ${owner.process} on ${owner.host})` : ''}: wait for it, or remove ${path} if it has ended.`,
      );
    removeEnded(path);
  }
  return () => {
    if (ownerOf(path)?.process === process.pid) rmSync(path, { force: true });
  };
}

/** Whether there was no lock before. The file appears with its content, so that nobody takes it for a damaged one. */
function created(path: string, owner: Owner): boolean {
  const draft = `${path}.${process.pid}`;
  try {
    writeFileSync(draft, JSON.stringify(owner));
    linkSync(draft, path);
    return true;
  } catch (error) {
    const { code } = error as NodeJS.ErrnoException;
    if (code === 'EEXIST') return false;
    if (!WITHOUT_LINKS.includes(code!)) throw fileError(`${path} cannot be written`, error);
    return createdWithoutLinks(path, owner);
  } finally {
    rmSync(draft, { force: true });
  }
}

/** What file systems answer that have no hard links, as that of a memory stick. */
const WITHOUT_LINKS = ['EPERM', 'ENOTSUP', 'EOPNOTSUPP', 'ENOSYS'];

function createdWithoutLinks(path: string, owner: Owner): boolean {
  try {
    writeFileSync(path, JSON.stringify(owner), { flag: 'wx' });
    return true;
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code === 'EEXIST') return false;
    throw fileError(`${path} cannot be written`, error);
  }
}

/** Removes a lock whose process has ended, but not one that another batch has put there in the meantime. */
function removeEnded(path: string): void {
  const aside = `${path}.${process.pid}.ended`;
  try {
    renameSync(path, aside);
    const owner = ownerOf(aside);
    if (owner && isAtWork(owner)) created(path, owner);
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code !== 'ENOENT') throw error;
  } finally {
    rmSync(aside, { force: true });
  }
}

/** Null where the file is damaged, as a kill can leave it. */
function ownerOf(path: string): Owner | null {
  try {
    return JSON.parse(readFileSync(path, 'utf8')) as Owner;
  } catch {
    return null;
  }
}
