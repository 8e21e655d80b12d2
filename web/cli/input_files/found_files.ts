/** Finds files by the names that another file gives them; names of Windows and macOS can differ in case from those on the disk. */

import { readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { isWithin } from '../output_files/identity';

export class FoundFiles {
  /** by folder, and by the lower case of each name in it */
  private readonly listings = new Map<string, Map<string, string>>();

  /** What is found lies below `root`, and with all links followed in or below one of `folders`. */
  constructor(
    private readonly root: string,
    private readonly folders: string[],
  ) {}

  /** The first of these paths, parted by slashes, at which there is a file; where there is none, with `folds` in any case. */
  find(paths: readonly string[], folds: boolean): string | null {
    const exact = paths.find((path) => this.isFile(path));
    if (exact !== undefined || !folds) return exact ?? null;
    return paths.map((path) => this.folded(path)).find((path) => path !== null && this.isFile(path)) ?? null;
  }

  private isFile(path: string): boolean {
    const whole = join(this.root, path);
    try {
      return statSync(whole).isFile() && isWithin(whole, this.folders);
    } catch {
      return false;
    }
  }

  private folded(path: string): string | null {
    let folder = '';
    for (const part of path.split('/')) {
      const name = this.listing(folder).get(part.toLowerCase());
      if (name === undefined) return null;
      folder = folder === '' ? name : `${folder}/${name}`;
    }
    return folder;
  }

  private listing(folder: string): Map<string, string> {
    const known = this.listings.get(folder);
    if (known) return known;
    const names = this.namesIn(folder).sort().reverse();
    const listing = new Map(names.map((name) => [name.toLowerCase(), name]));
    this.listings.set(folder, listing);
    return listing;
  }

  private namesIn(folder: string): string[] {
    try {
      return readdirSync(join(this.root, folder));
    } catch {
      return [];
    }
  }
}
