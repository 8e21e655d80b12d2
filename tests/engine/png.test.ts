import { deflateSync } from 'node:zlib';
import sharp from 'sharp';
import { describe, expect, it } from 'vitest';
import { decodePng } from '../../web/engine/document/textures/png';
import { pngOf } from './support/pictures';
import { processorTime } from './support/processor_time';

const MOST = 1 << 20;
const [WIDTH, HEIGHT] = [37, 23];

/** Smooth, with a noisy part, so that rows are predicted in different ways. */
function pixelsOf(channels: 3 | 4): Buffer {
  return Buffer.from(
    Array.from({ length: WIDTH * HEIGHT * channels }, (_, i) => {
      const [x, y] = [Math.floor(i / channels) % WIDTH, Math.floor(i / channels / WIDTH)];
      return (x * 5 + y * 3 + (i % channels) * 40 + (y > 12 ? (i * 7919) % 251 : 0)) % 256;
    }),
  );
}

const pictureOf = (channels: 3 | 4) =>
  sharp(pixelsOf(channels), { raw: { width: WIDTH, height: HEIGHT, channels } });

describe('a PNG', () => {
  it.each([3, 4] as const)('of %i channels is decoded, with rows of all kinds', async (channels) => {
    const bytes = await pictureOf(channels).png({ adaptiveFiltering: true }).toBuffer();
    const decoded = decodePng(bytes, MOST)!;
    expect({ ...decoded, data: Buffer.from(decoded.data) }).toEqual({
      width: WIDTH,
      height: HEIGHT,
      channels,
      data: pixelsOf(channels),
    });
  });

  it.each([2, 4, 16, 256])('with a palette of %i colours is decoded', async (colours) => {
    const bytes = await pictureOf(3).png({ palette: true, colours, dither: 0 }).toBuffer();
    const expected = await sharp(bytes).removeAlpha().raw().toBuffer();
    expect(Buffer.from(decodePng(bytes, MOST)!.data)).toEqual(expected);
  });

  it('in grey, interlaced, with 16 bits or too large is not decoded, and neither is another file', async () => {
    const grey = await pictureOf(3).toColourspace('b-w').png().toBuffer();
    const interlaced = await pictureOf(3).png({ progressive: true }).toBuffer();
    const fine = await pictureOf(3).toColourspace('rgb16').png().toBuffer();
    const jpeg = await pictureOf(3).jpeg().toBuffer();
    for (const bytes of [grey, interlaced, fine, jpeg, new Uint8Array(), new Uint8Array(7)])
      expect(decodePng(bytes, MOST)).toBeNull();
    expect(decodePng(await pictureOf(3).png().toBuffer(), WIDTH * HEIGHT - 1)).toBeNull();
  });

  it('that is truncated is refused at any length', async () => {
    const bytes = await pictureOf(3).png().toBuffer();
    const dataAt = bytes.indexOf('IDAT') + 4;
    for (let length = dataAt; length < bytes.length - 20; length += 50)
      expect(() => decodePng(bytes.subarray(0, length), MOST)).toThrow();
    const wrong = Uint8Array.from(pngOf([[[1, 2, 3]]]));
    wrong[wrong.length - 20] ^= 255;
    expect(() => decodePng(wrong, MOST)).not.toThrow(RangeError);
  });

  it('with far more rows than its header declares is refused as soon as they are inflated', () => {
    const small = Buffer.from(pngOf([[[1, 2, 3]]]));
    const dataAt = small.indexOf('IDAT') - 4;
    const packed = deflateSync(Buffer.alloc(1 << 28), { level: 9 });
    const chunk = Buffer.alloc(8);
    chunk.writeUInt32BE(packed.length);
    chunk.write('IDAT', 4);
    const bomb = Buffer.concat([small.subarray(0, dataAt), chunk, packed, Buffer.alloc(4)]);
    const seconds = processorTime();
    expect(() => decodePng(bomb, MOST)).toThrow('more rows');
    expect(seconds()).toBeLessThan(2);
  });
});
