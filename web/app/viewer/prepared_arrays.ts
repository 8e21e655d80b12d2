/** Prepares the drawn arrays of meshes: of small ones at once, of large ones in workers. */

import { faceCount } from '../../engine/core/mesh';
import type { TriangleMesh } from '../../engine/core/core';
import type { DrawnArrays } from './drawn_arrays';

/** The normals of more faces take longer than a frame. */
const MAX_FACES_AT_ONCE = 6000;

export const isPreparedAtOnce = (mesh: TriangleMesh): boolean => faceCount(mesh) <= MAX_FACES_AT_ONCE;

/** A worker that answers requests in order. */
class Preparer {
  private worker: Worker | null = null;
  /** the pending answers */
  private readonly due: { resolve(drawn: DrawnArrays): void; reject(error: Error): void }[] = [];

  constructor(private readonly isQuick: boolean) {}

  prepare(mesh: TriangleMesh): Promise<DrawnArrays> {
    const worker = (this.worker ??= this.open());
    return new Promise((resolve, reject) => {
      this.due.push({ resolve, reject });
      // Views of a larger buffer would be copied with all of it.
      const compacted = { positions: compact(mesh.positions), triangles: compact(mesh.triangles) };
      worker.postMessage({ mesh: compacted, isQuick: this.isQuick });
    });
  }

  private open(): Worker {
    const opened = new Worker(new URL('./drawn_arrays_worker.ts', import.meta.url), { type: 'module' });
    opened.onmessage = ({ data }: MessageEvent<DrawnArrays>) => this.due.shift()?.resolve(data);
    opened.onerror = () => {
      this.worker = null;
      opened.terminate();
      for (const { reject } of this.due.splice(0)) reject(new Error('The picture could not be prepared.'));
    };
    return opened;
  }
}

// A separate worker, so that a tick of the slider does not wait for the exact normals of the last one.
const quick = new Preparer(true);
const exact = new Preparer(false);

/** Prepares a large mesh with `quickArrays`. Rejects if the worker cannot be loaded. */
export const prepareQuickly = (mesh: TriangleMesh): Promise<DrawnArrays> => quick.prepare(mesh);

/** Prepares a large mesh with `drawnArrays`. Rejects if the worker cannot be loaded. */
export const prepareExactly = (mesh: TriangleMesh): Promise<DrawnArrays> => exact.prepare(mesh);

const compact = <T extends Float32Array | Uint32Array>(array: T): T =>
  array.byteLength === array.buffer.byteLength ? array : (array.slice() as T);
