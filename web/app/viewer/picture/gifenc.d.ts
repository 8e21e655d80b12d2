/** Types of gifenc 1.0.3, which has none of its own. */

declare module 'gifenc' {
  /** Red, green, blue: 0..255 */
  export type Colour = [number, number, number];

  /** The colours that come nearest to those of `rgba`, which is the whole of its buffer. */
  export function quantize(rgba: Uint8ClampedArray, mostColours: number): Colour[];
  /** For each pixel the index of the nearest colour. */
  export function applyPalette(rgba: Uint8ClampedArray, palette: readonly Colour[]): Uint8Array;

  export interface FrameOptions {
    palette: readonly Colour[];
    /** ms, written in steps of 10 */
    delay: number;
    /** what happens to the frame before the next one is drawn; 1: it stays */
    dispose: number;
    transparent: boolean;
    transparentIndex: number;
  }

  export function GIFEncoder(): {
    writeFrame(indices: Uint8Array, width: number, height: number, options: FrameOptions): void;
    finish(): void;
    bytes(): Uint8Array<ArrayBuffer>;
  };
}
