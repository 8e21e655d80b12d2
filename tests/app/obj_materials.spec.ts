import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import { glbParts } from '../../web/engine/document/glb';
import { pngOf } from '../engine/support/pictures';
import { drop, openPage, saveGlb, writeScratch } from './page';
import { stillCapture } from './pictures';

const RED = [255, 0, 0];
const BLUE = [0, 0, 255];

/** A sheet of 2 n^2 triangles that stands upright, with its UVs from the lower left corner. */
function standingSheet(n: number): string {
  const lines = ['mtllib C:\\work\\sheet.mtl'];
  const numbers = Array.from({ length: n + 1 }, (_, i) => i / n);
  for (const y of numbers)
    for (const x of numbers) lines.push(`v ${x} ${y} ${0.05 * Math.sin(6 * x)}`, `vt ${x} ${y}`);
  lines.push('usemtl painted');
  for (let row = 0; row < n; row++)
    for (let column = 0; column < n; column++) {
      const first = row * (n + 1) + column + 1;
      const corners = [first, first + 1, first + n + 2, first + n + 1];
      lines.push(`f ${corners.map((corner) => `${corner}/${corner}`).join(' ')}`);
    }
  return lines.join('\n');
}

interface Found {
  count: number;
  /** mean, in pixels from the upper edge */
  height: number;
}

/** Strongly red and blue pixels in each half of a picture: original left, optimized right. */
async function coloursOf(page: Page, png: Buffer): Promise<{ red: Found; blue: Found }[]> {
  return page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
    context.drawImage(bitmap, 0, 0);
    const { data, width } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    const halves = [0, 1].map(() => ({ red: { count: 0, height: 0 }, blue: { count: 0, height: 0 } }));
    for (let i = 0; i < data.length; i += 4) {
      const [x, y] = [(i / 4) % width, Math.floor(i / 4 / width)];
      // The axes of the scene have colours of their own.
      if (x % (width / 2) < 80 && y > bitmap.height - 80) continue;
      const [r, g, b] = [data[i], data[i + 1], data[i + 2]];
      const half = halves[Number(x > width / 2)];
      const isStrong = (one: number, other: number) => one > 90 && one > 2 * other && one > 2 * g;
      const found = isStrong(r, b) ? half.red : isStrong(b, r) ? half.blue : null;
      if (!found) continue;
      found.count += 1;
      found.height += (y - found.height) / found.count;
    }
    return halves;
  }, png.toString('base64'));
}

test('an OBJ that is dropped with its library and picture is drawn and saved with them', async ({ page }) => {
  await openPage(page);
  const rows = [...Array<number[]>(8).fill(RED), ...Array<number[]>(8).fill(BLUE)].map((row) => [row, row]);
  await drop(
    page,
    writeScratch('sheet.obj', standingSheet(20)),
    writeScratch('sheet.mtl', 'newmtl painted\nKd 0.8 0.8 0.8\nmap_Kd D:\\textures\\my skin.png\n'),
    writeScratch('my skin.png', pngOf(rows)),
  );
  await expect(page.locator('.left .filename').first()).toHaveText('sheet.obj');
  await expect
    .poll(async () => (await coloursOf(page, await stillCapture(page)))[1].red.count)
    .toBeGreaterThan(1000);
  for (const { red, blue } of await coloursOf(page, await stillCapture(page))) {
    expect(red.count).toBeGreaterThan(1000);
    expect(blue.count).toBeGreaterThan(1000);
    // The upper half of the picture is on the upper half of the sheet.
    expect(red.height).toBeLessThan(blue.height - 50);
  }
  const bytes = await saveGlb(page);
  const json = JSON.parse(new TextDecoder().decode(glbParts({ name: 'a.glb', bytes }).json)) as object;
  expect(json).toMatchObject({
    images: [{ mimeType: 'image/png', name: 'my skin' }],
    materials: [{ name: 'painted', pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
  });
});
