import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import { glbParts } from '../../web/engine/document/glb';
import { pngOf } from '../engine/support/pictures';
import { drop, openPage, saveGlb, writeScratch } from './page';
import { stillCapture, strongPixels } from './pictures';

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
  const { width, red, blue } = await strongPixels(page, png, 2);
  const foundIn = (pixels: [x: number, y: number][], isRight: boolean): Found => {
    const heights = pixels.filter(([x]) => x > width / 2 === isRight).map(([, y]) => y);
    return { count: heights.length, height: heights.reduce((sum, y) => sum + y, 0) / heights.length };
  };
  return [false, true].map((isRight) => ({ red: foundIn(red, isRight), blue: foundIn(blue, isRight) }));
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
