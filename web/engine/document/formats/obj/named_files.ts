/** Files by their paths; without an exact match, letter case is ignored, as on Windows and macOS. */

import type { SourceFile } from '../../model';
import { pathOf } from './companion_paths';

export class NamedFiles {
  private readonly exact = new Map<string, SourceFile>();
  private readonly folded = new Map<string, SourceFile>();

  constructor(files: readonly SourceFile[]) {
    for (const file of [...files].sort((a, b) => (a.name < b.name ? -1 : 1))) {
      const path = pathOf(file.name);
      if (path === null) continue;
      if (!this.exact.has(path)) this.exact.set(path, file);
      if (!this.folded.has(path.toLowerCase())) this.folded.set(path.toLowerCase(), file);
    }
  }

  /** The file at the first of these paths that has one; null where none has. */
  find(paths: readonly string[]): SourceFile | null {
    const path = paths.find((one) => this.exact.has(one));
    if (path !== undefined) return this.exact.get(path)!;
    const folded = paths.map((one) => one.toLowerCase()).find((one) => this.folded.has(one));
    return folded === undefined ? null : this.folded.get(folded)!;
  }
}
