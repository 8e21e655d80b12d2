// Recorded GIFs, read as a viewer reads them.

import { expect, test } from 'vitest';
import { GifFile } from '../../web/app/viewer/picture/gif';
import { readGif } from './support/gif';

const [width, height] = [48, 20];

/** A ground in many colours with a red square that has moved by `frame` pixels. */
function picture(frame: number): Uint8ClampedArray<ArrayBuffer> {
  const rgba = new Uint8ClampedArray(4 * width * height);
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      const isSquare = x >= frame && x < frame + 8 && y >= 4 && y < 12;
      rgba.set(isSquare ? [220, 30, 40, 255] : [40 + 2 * x, 60 + 4 * y, 200, 255], 4 * (y * width + x));
    }
  return rgba;
}

function gifOf(pictures: Uint8ClampedArray<ArrayBuffer>[], milliseconds = 50): Uint8Array {
  const file = new GifFile({ width, height, milliseconds });
  for (const one of pictures) file.add(one);
  return file.finish();
}

/** The largest difference of a channel from what was drawn. */
const farthest = (shown: Uint8ClampedArray, drawn: Uint8ClampedArray): number =>
  shown.reduce((most, value, i) => Math.max(most, Math.abs(value - drawn[i])), 0);

test('a GIF has every frame, each of the requested size and duration, and loops', () => {
  const drawn = Array.from({ length: 12 }, (_, frame) => picture(frame));
  const { frames, ...rest } = readGif(gifOf(drawn.map((one) => one.slice())));
  expect(rest).toEqual({ width, height, isEndless: true });
  expect(frames.map(({ milliseconds }) => milliseconds)).toEqual(Array(12).fill(50));
  // Colours come in steps of 8, as the quantizer counts them.
  frames.forEach(({ rgba }, i) => expect(farthest(rgba, drawn[i])).toBeLessThanOrEqual(16));
});

test('pixels that do not change keep exactly their colour', () => {
  const { frames } = readGif(gifOf([picture(0), picture(3), picture(6)]));
  const ground = 4 * (15 * width + 40);
  const colour = (frame: number): number[] => [...frames[frame].rgba.subarray(ground, ground + 4)];
  expect(colour(1)).toEqual(colour(0));
  expect(colour(2)).toEqual(colour(0));
});

test('a still takes a fraction of the first frame', () => {
  const [one, three] = [1, 3].map((count) => gifOf(Array.from({ length: count }, () => picture(0))).length);
  expect((three - one) / 2).toBeLessThan(0.25 * one);
  expect(readGif(gifOf([picture(0), picture(0)])).frames[1].rgba).toEqual(
    readGif(gifOf([picture(0)])).frames[0].rgba,
  );
});

test('noise, which needs more colours than a GIF has, decodes to the last pixel', () => {
  let seed = 1;
  const noise = picture(0).map((_, i) => (i % 4 === 3 ? 255 : (seed = (seed * 16807) % 2147483647) & 255));
  const { frames } = readGif(gifOf([noise, picture(2)]));
  expect(frames).toHaveLength(2);
  expect(farthest(frames[1].rgba, picture(2))).toBeLessThanOrEqual(16);
});
