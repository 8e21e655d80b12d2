/** Decodes PNG pictures in colour, in plain JavaScript, so that every engine gets the same pixels. */

import { Unzlib } from 'fflate';
import { isPng, pngChunks } from '../formats/png_chunks';

/** Rows from the top; each pixel has `channels` bytes: red, green, blue, and alpha where there are four. */
export interface Pixels {
  width: number;
  height: number;
  channels: number;
  data: Uint8Array;
}

interface Header {
  width: number;
  height: number;
  /** of a sample */
  bits: number;
  /** samples of a pixel in the file */
  samples: number;
}

const SAMPLES_OF_TYPE: Record<number, number | undefined> = { 2: 3, 3: 1, 6: 4 };
/** The compressed bytes that are inflated at a time, so that the size of the output is checked in between. */
const SLICE = 1 << 16;

/**
 * Null where the file is not a PNG, or is grey, interlaced or 16-bit. Throws an Error where it is broken. The memory is in
 * proportion to `mostPixels` whatever the file declares; larger images are null, too.
 */
export function decodePng(bytes: Uint8Array, mostPixels: number): Pixels | null {
  const header = headerOf(bytes);
  if (!header || !(header.width * header.height <= mostPixels)) return null;
  const { width, height, bits, samples } = header;
  const rowLength = Math.ceil((width * samples * bits) / 8);
  const { palette, packed } = contentOf(bytes);
  const rows = inflated(packed, height * (1 + rowLength));
  const data = unfiltered(rows, rowLength, Math.ceil((samples * bits) / 8));
  if (samples > 1) return { width, height, channels: samples, data };
  return { width, height, channels: 3, data: coloured(data, palette, header) };
}

/** The width and height of a PNG that can be decoded; null for any other file. */
export function sizeOfPng(bytes: Uint8Array): [number, number] | null {
  const header = headerOf(bytes);
  return header && [header.width, header.height];
}

function headerOf(bytes: Uint8Array): Header | null {
  if (!isPng(bytes) || bytes.length < 33) return null;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const [width, height, bits, type] = [
    view.getUint32(16),
    view.getUint32(20),
    view.getUint8(24),
    view.getUint8(25),
  ];
  const samples = SAMPLES_OF_TYPE[type];
  const isInterlaced = view.getUint8(28) !== 0;
  const isKnown = samples === 1 ? [1, 2, 4, 8].includes(bits) : bits === 8;
  return samples && isKnown && !isInterlaced && width > 0 && height > 0
    ? { width, height, bits, samples }
    : null;
}

function contentOf(bytes: Uint8Array): { palette: Uint8Array; packed: Uint8Array[] } {
  let palette = new Uint8Array();
  const packed: Uint8Array[] = [];
  for (const { type, data } of pngChunks(bytes)) {
    if (type === 'PLTE') palette = data.slice();
    if (type === 'IDAT') packed.push(data);
    if (type === 'IEND') break;
  }
  return { palette, packed };
}

/** The inflated data. Throws an Error unless it has exactly `size` bytes. */
function inflated(packed: Uint8Array[], size: number): Uint8Array {
  const all = new Uint8Array(size);
  let count = 0;
  const stream = new Unzlib((part) => {
    if (count + part.length > size) throw new Error('The picture has more rows than its header says.');
    all.set(part, count);
    count += part.length;
  });
  for (const part of packed)
    for (let at = 0; at < part.length; at += SLICE) stream.push(part.subarray(at, at + SLICE));
  stream.push(new Uint8Array(), true);
  if (count !== size) throw new Error('The picture has fewer rows than its header says.');
  return all;
}

/** Undoes the prediction of each row and removes its filter byte; `step`: bytes from one pixel to the next. */
function unfiltered(rows: Uint8Array, length: number, step: number): Uint8Array {
  const height = rows.length / (1 + length);
  const all = new Uint8Array(height * length);
  let above = new Uint8Array(length);
  for (let y = 0; y < height; ++y) {
    const from = y * (1 + length);
    const row = all.subarray(y * length, (y + 1) * length);
    row.set(rows.subarray(from + 1, from + 1 + length));
    addPrediction(rows[from], { row, above, step });
    above = row;
  }
  return all;
}

interface Row {
  row: Uint8Array;
  above: Uint8Array;
  step: number;
}

function addPrediction(filter: number, { row, above, step }: Row): void {
  if (filter === 1) for (let x = step; x < row.length; ++x) row[x] += row[x - step];
  else if (filter === 2) for (let x = 0; x < row.length; ++x) row[x] += above[x];
  else if (filter === 3)
    for (let x = 0; x < row.length; ++x) row[x] += ((x < step ? 0 : row[x - step]) + above[x]) >> 1;
  else if (filter === 4) {
    for (let x = 0; x < step; ++x) row[x] += above[x];
    for (let x = step; x < row.length; ++x) row[x] += nearest(row[x - step], above[x], above[x - step]);
  } else if (filter !== 0) throw new Error('The picture has a row of an unknown kind.');
}

/** Paeth's predictor. */
function nearest(left: number, above: number, corner: number): number {
  const a = Math.abs(above - corner);
  const b = Math.abs(left - corner);
  const c = Math.abs(left + above - 2 * corner);
  if (a <= b && a <= c) return left;
  return b <= c ? above : corner;
}

/** Colours beyond the palette are black. */
function coloured(data: Uint8Array, palette: Uint8Array, { width, height, bits }: Header): Uint8Array {
  const colours = new Uint8Array(3 * 256);
  colours.set(palette.subarray(0, colours.length));
  const all = new Uint8Array(3 * width * height);
  const rowLength = data.length / height;
  const perByte = 8 / bits;
  for (let y = 0, to = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const byte = data[y * rowLength + Math.floor(x / perByte)];
      const index = (byte >> (8 - bits - bits * (x % perByte))) & ((1 << bits) - 1);
      for (let c = 0; c < 3; ++c) all[to++] = colours[3 * index + c];
    }
  return all;
}
