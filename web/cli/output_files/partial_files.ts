/** Files that are being written, before they take the places of others. Those of a process that was killed are removed by a later one. */

import { readdirSync, rmSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { isAtWork, thisProcess } from './owner';

/** Letters of a name that its partial file keeps: a name can be as long as the system allows. */
const KEPT_LETTERS = 40;

/** Where this process writes the file `end` before it is whole. */
export function partialOf(end: string): string {
  const { host, process } = thisProcess();
  return join(dirname(end), `.${basename(end).slice(0, KEPT_LETTERS)}.${process}@${host}.part`);
}

const PARTIAL = /^\..*\.(\d+)@(.+)\.part$/;

const cleaned = new Set<string>();

/** Removes what processes of this machine that have ended have left in a folder. A folder is looked at once. */
export function removeStalePartials(folder: string): void {
  if (cleaned.has(folder)) return;
  cleaned.add(folder);
  try {
    for (const name of readdirSync(folder)) {
      const [, process, host] = PARTIAL.exec(name) ?? [];
      if (process !== undefined && !isAtWork({ host, process: Number(process) })) rmSync(join(folder, name));
    }
  } catch {
    // The system may let files be made in a folder and not let it be listed: what is left there does no harm.
  }
}
