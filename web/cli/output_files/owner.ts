/** A process that owns a file, such as a lock, and whether it still runs. */

import { hostname } from 'node:os';

export interface Owner {
  host: string;
  process: number;
}

export const thisProcess = (): Owner => ({ host: hostname(), process: process.pid });

/** Whether an owner other than this process runs, as far as is known: processes of other machines cannot be asked. */
export function isAtWork({ host, process: id }: Owner): boolean {
  if (host !== hostname()) return true;
  if (id === process.pid) return false;
  try {
    process.kill(id, 0);
    return true;
  } catch (error) {
    return (error as NodeJS.ErrnoException).code === 'EPERM';
  }
}
