/** A looping GIF. A frame contains the differences from the previous one, with its own palette. */

import { GIFEncoder, applyPalette, quantize } from 'gifenc';
import type { Colour } from 'gifenc';

export interface GifSize {
  width: number;
  height: number;
  /** of each frame; a GIF counts in steps of 10 */
  milliseconds: number;
}

/** Of the 256 that a GIF allows, one stands for what stays. */
const MAX_COLOURS = 255;
/** The next frame is drawn over this one. */
const STAYS = 1;

export class GifFile {
  private readonly encoder = GIFEncoder();
  /** the pixels of the previous frame, as one number each */
  private last: Uint32Array | null = null;

  constructor(private readonly size: GifSize) {}

  /** `rgba`: four bytes a pixel, row by row from the top, opaque, and nothing else in their buffer, which is kept. */
  add(rgba: Uint8ClampedArray<ArrayBuffer>): void {
    const pixels = new Uint32Array(rgba.buffer);
    const { last } = this;
    const changed = last ? pixels.filter((pixel, i) => pixel !== last[i]) : pixels;
    const palette = paletteOf(changed);
    const indices = applyPalette(rgba, palette);
    if (last) pixels.forEach((pixel, i) => pixel === last[i] && (indices[i] = palette.length));
    this.encoder.writeFrame(indices, this.size.width, this.size.height, {
      palette: [...palette, [0, 0, 0]],
      delay: this.size.milliseconds,
      dispose: STAYS,
      transparent: true,
      transparentIndex: palette.length,
    });
    this.last = pixels;
  }

  /** The file. Nothing can be added afterwards. */
  finish(): Uint8Array<ArrayBuffer> {
    this.encoder.finish();
    return this.encoder.bytes();
  }
}

const paletteOf = (pixels: Uint32Array<ArrayBuffer>): Colour[] =>
  pixels.length > 0 ? quantize(new Uint8ClampedArray(pixels.buffer), MAX_COLOURS) : [[0, 0, 0]];
