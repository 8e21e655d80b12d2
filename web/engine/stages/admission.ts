/** Refuses work that needs more memory than the core can have, before it begins. */

import type { PreparedBody } from '../body/prepared_body';
import { counted } from '../core/words';
import type { Body } from '../document/model';
import type { Settings } from '../settings/options';

/** Bytes of the core's memory for a face of the largest mesh, measured at a million faces: tests/bench/seconds.mjs prints them. */
const BYTES_PER_FACE = { reduced: 430, fitted: 900 };

/** The memory that the core may have, and the caller, whose means of raising it errors name. */
export interface MemoryLimit {
  heapLimit: number;
  caller: Caller;
}

export type Caller = 'command line' | 'page' | 'library';

/** Throws an Error where a body has more faces than any method can work on within `heapLimit` bytes. */
export function admitBodies(bodies: readonly Body[], { heapLimit, caller }: MemoryLimit): void {
  for (const { name, indices } of bodies) {
    const faces = indices.length / 3;
    const needed = BYTES_PER_FACE.reduced * faces;
    if (needed > heapLimit) throw refusal(name, { faces, needed, heapLimit, cure: CURES[caller].reduced });
  }
}

/** Throws an Error where a body in one part cannot be fitted to its surface within `heapLimit` bytes. */
export function admitFit(
  bodies: readonly PreparedBody[],
  { fit }: Settings,
  { heapLimit, caller }: MemoryLimit,
): void {
  if (fit === 'off') return;
  for (const { body, inspection } of bodies) {
    const needed = BYTES_PER_FACE.fitted * inspection.faces;
    if (inspection.components === 1 && needed > heapLimit)
      throw refusal(body.name, { faces: inspection.faces, needed, heapLimit, cure: CURES[caller].fitted });
  }
}

const ON_PAGE = 'add ?memory=4G to the address, or reduce the mesh in parts';

const CURES: Record<Caller, { reduced: string; fitted: string }> = {
  'command line': {
    reduced: 'raise --memory (at most 4G), or reduce the mesh in parts',
    fitted: 'use --fit off, raise --memory (at most 4G), or reduce the mesh in parts',
  },
  page: { reduced: ON_PAGE, fitted: ON_PAGE },
  library: { reduced: 'reduce the mesh in parts', fitted: 'give fit "off", or reduce the mesh in parts' },
};

interface MemoryShortage {
  faces: number;
  needed: number;
  heapLimit: number;
  cure: string;
}

const refusal = (name: string, { faces, needed, heapLimit, cure }: MemoryShortage): Error =>
  new Error(
    `${name} has ${counted(faces, 'face')}, for which the core needs about ${gigabytes(needed)} of memory, but it may use only ${gigabytes(heapLimit)}: ${cure}.`,
  );

const gigabytes = (bytes: number): string => `${(bytes / 2 ** 30).toFixed(1)} GB`;
