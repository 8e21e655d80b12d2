/** The worker that makes a GIF, as choosing the colours of a frame takes longer than the page may be held up. */

import { expose, transfer } from 'comlink';
import { GifFile } from './gif';
import type { GifSize } from './gif';

let file: GifFile;

const api = {
  open: (size: GifSize): void => void (file = new GifFile(size)),
  add: (rgba: Uint8ClampedArray<ArrayBuffer>): void => file.add(rgba),
  finish: (): Uint8Array<ArrayBuffer> => {
    const bytes = file.finish();
    return transfer(bytes, [bytes.buffer]);
  },
};

export type GifApi = typeof api;

expose(api);
