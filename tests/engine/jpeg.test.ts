import sharp from 'sharp';
import { describe, expect, it } from 'vitest';
import { decodeJpeg, sizeOfJpeg } from '../../web/engine/document/textures/jpeg';
import { isJpeg } from '../../web/engine/document/formats/jpeg_mark';

const MOST = 1 << 20;
const [WIDTH, HEIGHT] = [37, 23];

const smooth = Buffer.from(
  Array.from({ length: WIDTH * HEIGHT * 3 }, (_, i) => {
    const [x, y] = [Math.floor(i / 3) % WIDTH, Math.floor(i / 3 / WIDTH)];
    return x * 4 + y * 3 + (i % 3) * 20;
  }),
);
const pictureOf = () => sharp(smooth, { raw: { width: WIDTH, height: HEIGHT, channels: 3 } });

describe('a JPEG', () => {
  it.each([
    ['as it is', {}],
    ['progressive', { progressive: true }],
    ['with colours at half the size', { chromaSubsampling: '4:2:0' }],
  ])('%s has nearly the pixels that another decoder finds', async (_, options) => {
    const bytes = await pictureOf()
      .jpeg({ quality: 95, ...options })
      .toBuffer();
    expect(isJpeg(bytes)).toBe(true);
    expect(sizeOfJpeg(bytes)).toEqual([WIDTH, HEIGHT]);
    const { width, height, channels, data } = decodeJpeg(bytes, MOST);
    expect([width, height, channels]).toEqual([WIDTH, HEIGHT, 3]);
    const expected = await sharp(bytes).raw().toBuffer();
    expect(data.length).toBe(expected.length);
    const differences = expected.map((value, i) => Math.abs(value - data[i]));
    expect(Math.max(...differences)).toBeLessThanOrEqual(8);
  });

  it('in grey has three equal channels', async () => {
    const bytes = await pictureOf().toColourspace('b-w').jpeg().toBuffer();
    const { channels, data } = decodeJpeg(bytes, MOST);
    expect(channels).toBe(3);
    expect(data.length).toBe(3 * WIDTH * HEIGHT);
    for (let i = 0; i < data.length; i += 3) expect([data[i + 1], data[i + 2]]).toEqual([data[i], data[i]]);
  });

  it('is refused where it has more scans than any program writes', async () => {
    const bytes = await pictureOf().jpeg({ progressive: true }).toBuffer();
    const first = bytes.indexOf(Buffer.from([0xff, 0xda]));
    const end = bytes.indexOf(0xff, first + 2);
    const repeated = (times: number) =>
      Buffer.concat([
        bytes.subarray(0, end),
        ...Array(times).fill(bytes.subarray(first, end)),
        bytes.subarray(end),
      ]);
    expect(decodeJpeg(repeated(10), MOST).width).toBe(WIDTH);
    expect(() => decodeJpeg(repeated(100), MOST)).toThrow('scans');
  });

  it('is refused where it is larger than allowed, and harmless where it ends early', async () => {
    const bytes = await pictureOf().jpeg().toBuffer();
    expect(() => decodeJpeg(bytes, WIDTH * HEIGHT - 1)).toThrow();
    for (let length = 0; length < bytes.length - 2; length += 7) {
      const cut = bytes.subarray(0, length);
      expect(() => sizeOfJpeg(cut)).not.toThrow();
      try {
        expect(decodeJpeg(cut, MOST).data.length).toBe(3 * WIDTH * HEIGHT); // what is missing is left grey
      } catch (error) {
        expect(error).toBeInstanceOf(Error);
      }
    }
  });
});
