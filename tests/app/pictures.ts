/** Pictures of the viewport, and the differences of two of them in each half: original left, optimized right. */

import { createHash } from 'node:crypto';
import { expect } from '@playwright/test';
import type { Page } from '@playwright/test';

export type Halves = [original: number, optimized: number];

const capture = (page: Page): Promise<Buffer> => page.locator('.viewport canvas').screenshot();

/** The viewport as a hash: a failed comparison of whole pictures would take minutes to print. */
export const picture = async (page: Page): Promise<string> =>
  createHash('sha256')
    .update(await capture(page))
    .digest('hex');

/** Waits until the viewport is still, and returns its picture as PNG. */
export async function stillCapture(page: Page): Promise<Buffer> {
  let last = await capture(page);
  await expect(async () => {
    const before = last;
    await page.waitForTimeout(300);
    last = await capture(page);
    expect(last.equals(before)).toBe(true);
  }).toPass();
  return last;
}

export interface Change {
  /** pixels that differ visibly */
  changed: Halves;
  /** pixels that show a pin in the first picture */
  pins: Halves;
  /** of these, the share that shows a pin in both pictures, 0..1 */
  keptPins: Halves;
  /** mean height of the pins in the first picture: 0 at the upper edge, 1 at the lower one */
  pinHeight: Halves;
}

/** Compares two pictures of one size in the light colour scheme. */
export const compare = (page: Page, before: Buffer, after: Buffer): Promise<Change> =>
  page.evaluate(compareInPage, [before.toString('base64'), after.toString('base64')]);

/** Runs in the page, which can decode PNG. */
async function compareInPage(pictures: string[]): Promise<Change> {
  const [first, second] = await Promise.all(
    pictures.map(async (base64) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
      context.drawImage(bitmap, 0, 0);
      return context.getImageData(0, 0, bitmap.width, bitmap.height);
    }),
  );
  const { width, height } = first;
  // The colour of pins in the light scheme is #e8590c.
  const isPin = ({ data }: ImageData, i: number) =>
    Math.abs(data[i] - 232) + Math.abs(data[i + 1] - 89) + Math.abs(data[i + 2] - 12) < 40;
  const differs = (i: number) => [0, 1, 2].some((c) => Math.abs(first.data[i + c] - second.data[i + c]) > 16);
  const half = () => ({ changed: 0, pins: 0, kept: 0, height: 0 });
  const halves = [half(), half()];
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      const i = 4 * (y * width + x);
      const sums = halves[x < width / 2 ? 0 : 1];
      if (differs(i)) sums.changed += 1;
      if (!isPin(first, i)) continue;
      sums.pins += 1;
      sums.height += y / height;
      if (isPin(second, i)) sums.kept += 1;
    }
  const both = (value: (sums: ReturnType<typeof half>) => number): [number, number] => [
    value(halves[0]),
    value(halves[1]),
  ];
  return {
    changed: both(({ changed }) => changed),
    pins: both(({ pins }) => pins),
    keptPins: both(({ pins, kept }) => kept / pins),
    pinHeight: both(({ pins, height: sum }) => sum / pins),
  };
}

/** [x, y] of pixels, from the upper left corner. */
type Places = [x: number, y: number][];

/** The strongly red and the strongly blue pixels of a picture of panes side by side, without the axes of the scene in each. */
export const strongPixels = (
  page: Page,
  png: Buffer,
  panes = 1,
): Promise<{ width: number; red: Places; blue: Places }> =>
  page.evaluate(
    async ([base64, count]) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
      const { width, height } = bitmap;
      const context = new OffscreenCanvas(width, height).getContext('2d')!;
      context.drawImage(bitmap, 0, 0);
      const { data } = context.getImageData(0, 0, width, height);
      const found = { width, red: [] as [number, number][], blue: [] as [number, number][] };
      for (let i = 0; i < data.length; i += 4) {
        const [x, y] = [(i / 4) % width, Math.floor(i / 4 / width)];
        // The axes have colours of their own.
        if (x % (width / count) < 80 && y > height - 80) continue;
        const [r, g, b] = [data[i], data[i + 1], data[i + 2]];
        if (r > 90 && r > 2 * g && r > 2 * b) found.red.push([x, y]);
        if (b > 90 && b > 2 * r && b > 2 * g) found.blue.push([x, y]);
      }
      return found;
    },
    [png.toString('base64'), panes] as const,
  );
