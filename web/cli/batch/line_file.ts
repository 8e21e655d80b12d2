/** A file to whose end lines are added. */

import { closeSync, fsync, openSync, writeSync } from 'node:fs';
import { writing } from '../file_error';

/**
 * A line is the system's once `add` returns, so that it outlives a kill; it is on the disk soon after, for which nobody waits. Whoever
 * needs it there writes a file of the same content, and waits for that.
 */
export class LineFile {
  private readonly file: number;
  private state: 'quiet' | 'flushing' | 'behind' = 'quiet';
  private isClosed = false;
  private failure: Error | null = null;

  /** Throws UsageError. */
  constructor(private readonly path: string) {
    this.file = writing(path, () => openSync(path, 'a'));
  }

  /** Throws UsageError, as well where an earlier line could not be brought to the disk. */
  add(line: string): void {
    writing(this.path, () => {
      if (this.failure) throw this.failure;
      // The newline before it ends what an earlier program may have left of a line.
      writeSync(this.file, `\n${line}\n`);
    });
    if (this.state === 'quiet') this.flush();
    else this.state = 'behind';
  }

  close(): void {
    this.isClosed = true;
    if (this.state === 'quiet') closeSync(this.file);
  }

  private flush(): void {
    this.state = 'flushing';
    fsync(this.file, (error) => {
      this.failure ??= error;
      const isBehind = this.state === 'behind';
      this.state = 'quiet';
      if (this.isClosed) closeSync(this.file);
      else if (isBehind) this.flush();
    });
  }
}
