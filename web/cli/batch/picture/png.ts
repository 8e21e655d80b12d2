/** Grey pictures as PNG (ISO/IEC 15948): the signature, the header, the pixels without filters, the end. */

import { deflateSync } from 'node:zlib';
import { PNG_MARK } from '../../../engine/document/formats/png_chunks';
import type { Picture } from './raster';

const GREY_OF_8_BITS = [8, 0, 0, 0, 0];

export function encodePng({ width, height, pixels }: Picture): Uint8Array {
  const rows = new Uint8Array((width + 1) * height);
  // Every row starts with its filter, which is none.
  for (let y = 0; y < height; ++y) rows.set(pixels.subarray(y * width, (y + 1) * width), y * (width + 1) + 1);
  const parts = [
    Uint8Array.from(PNG_MARK),
    ...chunk('IHDR', Uint8Array.from([...bytesOf(width), ...bytesOf(height), ...GREY_OF_8_BITS])),
    ...chunk('IDAT', deflateSync(rows, { level: 9 })),
    ...chunk('IEND', new Uint8Array(0)),
  ];
  return new Uint8Array(Buffer.concat(parts));
}

function chunk(type: string, data: Uint8Array): Uint8Array[] {
  const named = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  return [Uint8Array.from(bytesOf(data.length)), named, Uint8Array.from(bytesOf(checksum(named)))];
}

const bytesOf = (value: number): number[] => [24, 16, 8, 0].map((shift) => (value >>> shift) & 255);

/** CRC-32 of Annex D. */
function checksum(bytes: Uint8Array): number {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; ++bit) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc >>> 0;
}
