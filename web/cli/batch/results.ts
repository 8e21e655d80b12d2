/** Results in the folder OUT: what is written there, and by which asset. */

import { chmodSync, copyFileSync, existsSync, mkdirSync, readFileSync, renameSync, statSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { writeWhole } from '../files';
import { followLinks, isSpecial } from '../output_files/identity';
import { hashOf } from './key';
import type { StagedFile, WorkDone } from './messages';
import type { AssetRecord, WrittenFile } from './record';
import { failedRecord } from './record';

/** The folder below OUT with what the batch itself needs. */
export const OWN_FOLDER = '.limber-batch';

/** The SHA-256 of a result as it is; null where it is gone. */
export function hashOfResult(out: string, { name }: WrittenFile): string | null {
  const path = join(out, name);
  return existsSync(path) && !isSpecial(path) ? hashOf(readFileSync(path)) : null;
}

/** Where the picture of an asset is kept. */
export const picturePath = (out: string, asset: string): string =>
  join(out, OWN_FOLDER, 'pictures', `${hashOf(asset).slice(0, 32)}.png`);

/** Takes results out of the folders of the jobs; two assets never write one file, unless both write the same into it, as a shared picture. */
export class Results {
  private readonly owners = new Map<string, { asset: string; sha256: string }>();

  constructor(private readonly out: string) {}

  /** Remembers that these results are an asset's. */
  claim({ asset, written }: AssetRecord): void {
    for (const { name, sha256 } of written) this.owners.set(name, { asset, sha256 });
  }

  /** Puts the files of a finished asset where they belong; returns what is to be remembered of it. */
  take({ record, files, picture }: WorkDone): AssetRecord {
    for (const { name, sha256 } of files) {
      const owner = this.owners.get(name);
      if (owner && owner.asset !== record.asset && owner.sha256 !== sha256)
        return failedRecord(record.asset, `${name} is also a result of ${owner.asset}: rename one of them`);
    }
    for (const file of files) move(file);
    this.claim(record);
    if (picture) {
      const path = picturePath(this.out, record.asset);
      mkdirSync(dirname(path), { recursive: true });
      renameSync(picture, path);
    }
    return record;
  }
}

/** A link stays, and the file that it leads to is replaced, with its permissions; it can be on another disk. */
function move({ staged, path }: StagedFile): void {
  const end = followLinks(path);
  mkdirSync(dirname(end), { recursive: true });
  try {
    if (isSpecial(end)) return copyFileSync(staged, end);
    const old = statSync(end, { throwIfNoEntry: false });
    if (old) chmodSync(staged, old.mode & 0o7777);
    renameSync(staged, end);
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code !== 'EXDEV') throw error;
    writeWhole(path, new Uint8Array(readFileSync(staged)));
  }
}
