/** Results in the folder OUT: what is written there, and by which asset. */

import { chmodSync, copyFileSync, existsSync, readFileSync, renameSync, statSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileError } from '../file_error';
import { makeFolder, writeWhole } from '../files';
import { followLinks, identityOf, isSpecial } from '../output_files/identity';
import { isOwnCompanion } from '../output_files/own_companions';
import { isOwnFile } from '../output_files/own_files';
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

export interface ResultsOptions {
  /** the folder OUT */
  out: string;
  /** files of the user's own may be replaced */
  force: boolean;
  /** names of files below OUT that batches have written */
  known: Iterable<string>;
  /** paths of the models of this batch, over which nothing is written */
  sources: string[];
  /** Looks at an asset of this batch, and calls `settle` with what it finds. */
  lookAt: (asset: string) => Promise<unknown>;
}

/** Takes results out of the folders of the jobs; two assets never write one file, unless both write the same into it, as a shared picture. */
export class Results {
  /** by the name of a file: the assets that it is a result of, with the SHA-256 of what each has written */
  private readonly owners = new Map<string, Map<string, string>>();
  /** results of earlier runs whose assets have not been looked at yet */
  private readonly expected = new Map<string, AssetRecord>();
  private readonly known: Set<string>;
  private readonly sources: Set<string>;

  constructor(private readonly options: ResultsOptions) {
    this.known = new Set(options.known);
    this.sources = new Set(options.sources.map(identityOf));
  }

  /** Remembers that these results of an earlier run are an asset's, for as long as it is not known whether it is done again. */
  expect(record: AssetRecord): void {
    this.claim(record);
    this.expected.set(record.asset, record);
  }

  /** What an asset has written before stays its own where it is up to date; otherwise it is to be written again, and is nobody's. */
  settle(asset: string, isUpToDate: boolean): void {
    const { written = [] } = this.expected.get(asset) ?? {};
    if (!isUpToDate) for (const { name } of written) this.owners.get(name)?.delete(asset);
    this.expected.delete(asset);
  }

  /** Puts the files of a finished asset where they belong; returns what is to be remembered of it. */
  async take({ record, files, picture }: WorkDone): Promise<AssetRecord> {
    let rival = this.rivalOf(record);
    while (rival && this.expected.has(rival.asset)) {
      await this.options.lookAt(rival.asset);
      rival = this.rivalOf(record);
    }
    // From here on nothing is waited for, so that no other asset is taken in between.
    if (rival)
      return failedRecord(
        record.asset,
        `${rival.name} is also a result of ${rival.asset}: rename one of them`,
      );
    const source = files.find(({ path }) => existsSync(path) && this.sources.has(identityOf(path)));
    if (source)
      return failedRecord(
        record.asset,
        `${source.path} is also a model of this batch: choose another folder for the results`,
      );
    const foreign = this.options.force ? undefined : files.find((file) => this.isForeign(file, files));
    if (foreign)
      return failedRecord(
        record.asset,
        `${foreign.path} exists and was not written by a batch: choose another folder for the results, or replace it with --force`,
      );
    for (const file of files) move(file);
    this.claim(record);
    if (picture) {
      const path = picturePath(this.options.out, record.asset);
      makeFolder(dirname(path));
      renameSync(picture, path);
    }
    return record;
  }

  private claim({ asset, written }: AssetRecord): void {
    for (const { name, sha256 } of written) {
      if (!this.owners.has(name)) this.owners.set(name, new Map());
      this.owners.get(name)!.set(asset, sha256);
      this.known.add(name);
    }
  }

  /** A file that another asset has written otherwise. */
  private rivalOf({ asset, written }: AssetRecord): { name: string; asset: string } | null {
    for (const { name, sha256 } of written)
      for (const [owner, hash] of this.owners.get(name) ?? [])
        if (owner !== asset && hash !== sha256) return { name, asset: owner };
    return null;
  }

  /** Whether there is a file in the place of a result that no batch has written, as far as can be told without its memory, too. */
  private isForeign(file: StagedFile, files: StagedFile[]): boolean {
    const { name, path, sha256 } = file;
    if (this.known.has(name) || !existsSync(path) || isSpecial(path)) return false;
    if (hashOf(readFileSync(path)) === sha256 || isOwnFile(path)) return false;
    return !files.some((model) => isOwnCompanion(path, model.path));
  }
}

/** A link stays, and the file that it leads to is replaced, with its permissions; it can be on another disk. */
function move({ staged, path }: StagedFile): void {
  const end = followLinks(path);
  makeFolder(dirname(end));
  try {
    if (isSpecial(end)) return copyFileSync(staged, end);
    const old = statSync(end, { throwIfNoEntry: false });
    if (old) chmodSync(staged, old.mode & 0o7777);
    renameSync(staged, end);
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code !== 'EXDEV')
      throw fileError(`${path} cannot be written`, error);
    writeWhole(path, new Uint8Array(readFileSync(staged)));
  }
}
