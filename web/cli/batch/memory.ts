/** How much memory jobs may take, and how much they take. */

import { readFileSync } from 'node:fs';
import { totalmem } from 'node:os';

/** What is left to the batch itself and to all else on the machine. */
const SHARE_OF_JOBS = 0.8;

/** Bytes that each job may take: what was asked for in megabytes, or its share of the machine's memory. */
export function memoryLimit(megabytes: number, jobs: number): number {
  if (megabytes > 0) return megabytes * 2 ** 20;
  // A container can have less than its machine; 0 or more than there is means that it has no limit.
  const own = process.constrainedMemory?.() ?? 0;
  const all = own > 0 && own < totalmem() ? own : totalmem();
  return Math.floor((SHARE_OF_JOBS * all) / jobs);
}

/** Bytes of memory that a process has; null where the system does not tell, which only Linux does without a program. */
export function memoryOf(id: number): number | null {
  try {
    const resident = /^VmRSS:\s*(\d+) kB$/m.exec(readFileSync(`/proc/${id}/status`, 'utf8'));
    return resident ? 1024 * Number(resident[1]) : null;
  } catch {
    return null;
  }
}
