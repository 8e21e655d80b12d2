/** Decodes JPEG pictures, in plain JavaScript, so that every engine gets the same pixels. */

import { ImageUtils } from '@gltf-transform/core';
import { decode } from 'jpeg-js';
import type { Pixels } from './png';

/** The memory that the decoder may use, in bytes per pixel: progressive images are kept as 32-bit coefficients of up to four components. */
const BYTES_PER_PIXEL = 64;

/** The most scans of a progressive image; 10 are usual. Each visits all pixels, however few bytes it has. */
const MAX_SCANS = 100;

/** Throws an Error where the file is broken, has more pixels than `mostPixels` or too many scans. */
export function decodeJpeg(bytes: Uint8Array, mostPixels: number): Pixels {
  if (scanCount(bytes) > MAX_SCANS) throw new Error(`The picture has more than ${MAX_SCANS} scans.`);
  const { width, height, data } = decode(bytes, {
    useTArray: true,
    formatAsRGBA: false,
    maxResolutionInMP: mostPixels / 1e6,
    maxMemoryUsageInMB: Math.ceil((BYTES_PER_PIXEL * mostPixels) / 2 ** 20),
  });
  return { width, height, channels: 3, data };
}

/** The number of start-of-scan markers; in scan data a byte 0xff is followed only by 0 or a restart number. */
function scanCount(bytes: Uint8Array): number {
  let count = 0;
  for (let i = bytes.indexOf(0xff); i >= 0; i = bytes.indexOf(0xff, i + 1))
    if (bytes[i + 1] === 0xda) ++count;
  return count;
}

/** The width and height of a JPEG file; null where it declares none. */
export function sizeOfJpeg(bytes: Uint8Array): [number, number] | null {
  try {
    const [width, height] = ImageUtils.getSize(bytes, 'image/jpeg') ?? [0, 0];
    return width > 0 && height > 0 ? [width, height] : null;
  } catch {
    return null;
  }
}
