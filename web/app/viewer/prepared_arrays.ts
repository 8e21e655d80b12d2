/** Prepares what is drawn of a mesh: small ones at once, large ones in a worker, one after the other. */

import { faceCount } from '../../engine/core/mesh';
import type { TriangleMesh } from '../../engine/core/core';
import type { DrawnArrays } from './drawn_arrays';

/** The normals of more faces take longer than a frame. */
const MOST_FACES_AT_ONCE = 6000;

let worker: Worker | null = null;
/** the answers that are due, in the order of the questions */
const due: { resolve(drawn: DrawnArrays): void; reject(error: Error): void }[] = [];

export const isPreparedAtOnce = (mesh: TriangleMesh): boolean => faceCount(mesh) <= MOST_FACES_AT_ONCE;

/** Prepares a large mesh. Rejects where the worker cannot be loaded. */
export function prepareArrays(mesh: TriangleMesh): Promise<DrawnArrays> {
  worker ??= openWorker();
  return new Promise((resolve, reject) => {
    due.push({ resolve, reject });
    // Views of a larger buffer would be copied with all of it.
    worker!.postMessage({ positions: compact(mesh.positions), triangles: compact(mesh.triangles) });
  });
}

const compact = <T extends Float32Array | Uint32Array>(array: T): T =>
  array.byteLength === array.buffer.byteLength ? array : (array.slice() as T);

function openWorker(): Worker {
  const opened = new Worker(new URL('./drawn_arrays_worker.ts', import.meta.url), { type: 'module' });
  opened.onmessage = ({ data }: MessageEvent<DrawnArrays>) => due.shift()?.resolve(data);
  opened.onerror = () => {
    worker = null;
    opened.terminate();
    for (const { reject } of due.splice(0)) reject(new Error('The picture could not be prepared.'));
  };
  return opened;
}
