/** The worker that makes a GIF, because choosing the palette of a frame would block the page too long. */

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
