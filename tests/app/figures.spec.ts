import { readFileSync } from 'node:fs';
import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import { goTo, keepFaces, keptFaces, openPage } from './page';

const button = (page: Page, name: string) => page.getByRole('button', { name, exact: true });

async function openReduce(page: Page): Promise<void> {
  await openPage(page);
  await goTo(page, 'Reduce');
  await expect(keptFaces(page)).toBeEnabled();
}

/** Clicks a button and returns the file that is saved. */
async function saved(page: Page, name: string): Promise<{ name: string; bytes: Buffer }> {
  await expect(button(page, name)).toBeEnabled();
  const [download] = await Promise.all([page.waitForEvent('download'), button(page, name).click()]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

interface Look {
  width: number;
  height: number;
  /** colours that differ by more than rounding */
  colours: number;
  /** the share of transparent pixels, 0..1 */
  clear: number;
}

/** Properties of a PNG, as decoded by the browser. */
const lookOf = (page: Page, bytes: Buffer): Promise<Look> =>
  page.evaluate(async (base64) => {
    const data = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([data], { type: 'image/png' }));
    const { width, height } = bitmap;
    const context = new OffscreenCanvas(width, height).getContext('2d')!;
    context.drawImage(bitmap, 0, 0);
    const pixels = context.getImageData(0, 0, width, height).data;
    const colours = new Set<number>();
    let clear = 0;
    for (let i = 0; i < pixels.length; i += 4) {
      colours.add(((pixels[i] >> 3) << 10) | ((pixels[i + 1] >> 3) << 5) | (pixels[i + 2] >> 3));
      if (pixels[i + 3] < 128) clear += 1;
    }
    return { width, height, colours: colours.size, clear: clear / (width * height) };
  }, bytes.toString('base64'));

/** The properties of a video according to a video element, and the share of pixels that change from its start to its middle. */
const watch = (page: Page, bytes: Buffer) =>
  page.evaluate(async (base64) => {
    const data = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const video = document.createElement('video');
    video.muted = true;
    const happened = (name: string) =>
      new Promise((resolve, reject) => {
        video.addEventListener(name, resolve, { once: true });
        video.addEventListener('error', () => reject(new Error(video.error?.message)), { once: true });
      });
    const loaded = happened('loadeddata');
    video.src = URL.createObjectURL(new Blob([data], { type: 'video/webm' }));
    await loaded;
    const { videoWidth: width, videoHeight: height, duration } = video;
    const shot = () => {
      const context = new OffscreenCanvas(width, height).getContext('2d')!;
      context.drawImage(video, 0, 0);
      return context.getImageData(0, 0, width, height).data;
    };
    const first = shot();
    const sought = happened('seeked');
    video.currentTime = duration / 2;
    await sought;
    const middle = shot();
    let changed = 0;
    for (let i = 0; i < first.length; i += 4) if (Math.abs(first[i] - middle[i]) > 24) changed += 1;
    return { width, height, duration, changed: changed / (width * height) };
  }, bytes.toString('base64'));

test('methods are compared at one number of faces, copied, and chosen by their pictures', async ({
  page,
  context,
}) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await openReduce(page);
  await keepFaces(page, 600);
  await button(page, 'Compare methods').click();
  const panel = page.getByRole('region', { name: 'Methods at 600 faces' });
  await expect(panel.getByText('All are measured.').first()).toBeVisible();
  const rows = panel.getByRole('row');
  await expect(rows).toHaveCount(6);
  for (const name of [
    'Limber',
    'Paper',
    'QEM',
    'meshoptimizer, simplify',
    'meshoptimizer, update + Regularize',
  ])
    await expect(
      panel.getByRole('row', { name: new RegExp(`^${name.replace('+', '\\+')} 600 `) }),
    ).toBeVisible();

  await panel.getByRole('button', { name: 'Copy as CSV' }).click();
  const csv = await page.evaluate(() => navigator.clipboard.readText());
  const lines = csv.trim().split(/\r?\n/);
  expect(lines).toHaveLength(6);
  expect(lines[0]).toMatch(/^Method,Faces,"Mean distance, %","Hausdorff distance, %"/);
  // Limber preserves frequencies better than a simplifier that only considers the shape.
  const errorOf = (name: string) =>
    Number(/,600,[^,]+,[^,]+,([^,]+)/.exec(lines.find((l) => l.includes(name))!)![1]);
  expect(errorOf('Limber')).toBeLessThan(errorOf('meshoptimizer, simplify'));
  await panel.getByRole('button', { name: 'Copy as LaTeX' }).click();
  await expect
    .poll(() => page.evaluate(() => navigator.clipboard.readText()))
    .toContain('\\begin{tabular}{lrrrrrrrrrr}');
  await panel.getByRole('button', { name: 'Copy as Markdown' }).click();
  await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toContain('| QEM | 600 |');

  // The pictures turn together, by keyboard and by pointer, and a drag does not choose.
  const canvases = panel.locator('canvas');
  const shot = (i: number) => canvases.nth(i).screenshot();
  const before = [await shot(1), await shot(5)];
  await panel.getByRole('button', { name: /^Limber/ }).focus();
  for (let press = 0; press < 4; press++) await page.keyboard.press('ArrowRight');
  await expect.poll(async () => (await shot(5)).equals(before[1])).toBe(false);
  expect((await shot(1)).equals(before[0])).toBe(false);
  await expect(panel).toBeVisible();

  await panel.getByRole('button', { name: /^meshoptimizer, simplify/ }).click();
  await expect(panel.getByText('is shown only for comparison')).toBeVisible();
  await panel.getByRole('button', { name: /^QEM/ }).click();
  await expect(panel).toHaveCount(0);
  await expect(
    page.getByRole('group', { name: 'Method' }).getByRole('button', { name: 'Shape only' }),
  ).toHaveAttribute('aria-pressed', 'true');
});

test(
  'what was compared is gone with the model, and Escape closes the comparison',
  { tag: '@full' },
  async ({ page }) => {
    await openReduce(page);
    await button(page, 'Compare methods').click();
    await expect(page.getByText('All are measured.').first()).toBeVisible();
    await page.getByRole('group', { name: 'Samples' }).getByRole('button', { name: 'cloth' }).click();
    await expect(page.locator('.filename')).toHaveText('cloth.glb');
    await expect(page.locator('.method-table')).toHaveCount(0);
    const brush = page.getByRole('group', { name: 'Brush' }).getByRole('button', { name: 'Keep' });
    await brush.click();
    await page.locator('.methods h2').focus();
    await page.keyboard.press('Escape');
    await expect(page.locator('.methods')).toHaveCount(0);
    await expect(brush).toHaveAttribute('aria-pressed', 'true');
  },
);

test('the stage is saved at the size that is asked for, with and without a ground', async ({ page }) => {
  await openReduce(page);
  await button(page, 'Pictures').click();
  const stage = (await page.locator('.viewport canvas').boundingBox())!;
  await page.getByLabel('Size', { exact: true }).selectOption('1x');
  const plain = await saved(page, 'Save PNG');
  expect(plain.name).toBe('bar-picture.png');
  const look = await lookOf(page, plain.bytes);
  expect([look.width, look.height]).toEqual([Math.round(stage.width), Math.round(stage.height)]);
  expect(look.clear).toBe(0);
  expect(look.colours).toBeGreaterThan(40);

  await page.getByLabel('Size', { exact: true }).selectOption('custom');
  await page.getByLabel('Width in pixels').fill('1000');
  await page.getByLabel('Height in pixels').fill('1400');
  await page.getByLabel('Height in pixels').press('Tab');
  await page.getByLabel('Transparent background').check();
  await page.getByLabel('Legend').uncheck();
  const clear = await lookOf(page, (await saved(page, 'Save PNG')).bytes);
  expect([clear.width, clear.height]).toEqual([1000, 1400]);
  expect(clear.clear).toBeGreaterThan(0.3);
  expect(clear.clear).toBeLessThan(0.98);
  // The stage is unchanged.
  const after = (await page.locator('.viewport canvas').boundingBox())!;
  expect(after).toEqual(stage);
});

test(
  'a figure shows original, modes, strain, result and both in motion',
  { tag: '@full' },
  async ({ page }) => {
    await openReduce(page);
    await button(page, 'Pictures').click();
    const { name, bytes } = await saved(page, 'Save figure');
    expect(name).toBe('bar-figure.png');
    const look = await lookOf(page, bytes);
    expect(look.width).toBeGreaterThan(1600);
    expect(look.height).toBeGreaterThan(1600);
    expect(look.colours).toBeGreaterThan(200);
    expect(look.clear).toBe(0);
  },
);

/** The properties of a GIF according to the browser's decoder, and the share of pixels that change from its start to its middle. */
const watchGif = (page: Page, bytes: Buffer) =>
  page.evaluate(async (base64) => {
    const data = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const decoder = new ImageDecoder({ type: 'image/gif', data });
    await Promise.all([decoder.completed, decoder.tracks.ready]);
    const { frameCount, repetitionCount } = decoder.tracks.selectedTrack!;
    const pixelsOf = async (frameIndex: number) => {
      const { image } = await decoder.decode({ frameIndex });
      const { displayWidth: width, displayHeight: height, duration } = image;
      const context = new OffscreenCanvas(width, height).getContext('2d')!;
      context.drawImage(image, 0, 0);
      return { width, height, duration, data: context.getImageData(0, 0, width, height).data };
    };
    const first = await pixelsOf(0);
    const middle = await pixelsOf(frameCount >> 1);
    const changed = first.data.filter((value, i) => Math.abs(value - middle.data[i]) > 24).length;
    const { width, height, duration } = first;
    const isEndless = repetitionCount === Infinity;
    // Pixels in the orange of pins.
    const orange = [first, middle].map(({ data: pixels }) => {
      const isOrange = (i: number): boolean => pixels[i] > 200 && pixels[i + 1] < 130 && pixels[i + 2] < 80;
      return pixels.filter((_, i) => i % 4 === 0 && isOrange(i)).length;
    });
    return {
      width,
      height,
      duration,
      frameCount,
      isEndless,
      orange,
      changed: changed / (4 * width * height),
    };
  }, bytes.toString('base64'));

test('a turntable and the motion of the test are saved as GIFs', { tag: '@full' }, async ({ page }) => {
  await openReduce(page);
  await button(page, 'Pictures').click();
  await page.getByLabel('Size', { exact: true }).selectOption('custom');
  await page.getByLabel('Width in pixels').fill('480');
  await page.getByLabel('Height in pixels').fill('320');
  await page.getByRole('group', { name: 'Format of the video' }).getByRole('button', { name: 'GIF' }).click();
  await page.getByLabel('Seconds').fill('0.5');
  await page.getByLabel('Seconds').press('Tab');
  const turntable = await saved(page, 'Save turntable');
  expect(turntable.name).toBe('bar-turntable.gif');
  const turned = await watchGif(page, turntable.bytes);
  expect(turned).toMatchObject({
    width: 480,
    height: 320,
    duration: 50_000,
    frameCount: 10,
    isEndless: true,
  });
  expect(turned.changed).toBeGreaterThan(0.005);

  await goTo(page, 'Test');
  await expect(button(page, 'Save motion')).toBeEnabled();
  // Typed text is kept while the numbers of the motion arrive.
  await page.getByLabel('Seconds').fill('0.4');
  await page.waitForTimeout(1000);
  await page.getByLabel('Seconds').press('Tab');
  const motion = await saved(page, 'Save motion');
  expect(motion.name).toBe('bar-motion.gif');
  const moved = await watchGif(page, motion.bytes);
  expect(moved.frameCount).toBe(8);
  // The pins are in every frame, also in the first, before anything moves.
  for (const pixels of moved.orange) expect(pixels).toBeGreaterThan(100);
  expect(moved.changed).toBeGreaterThan(0.001);
});

test(
  'a turntable and the motion of the test are saved as videos, and the chart as SVG',
  { tag: '@full' },
  async ({ page }) => {
    await openReduce(page);
    await button(page, 'Pictures').click();
    await page.getByLabel('Size', { exact: true }).selectOption('custom');
    await page.getByLabel('Width in pixels').fill('480');
    await page.getByLabel('Height in pixels').fill('320');
    await page.getByLabel('Seconds').fill('0.5');
    await page.getByLabel('Seconds').press('Tab');
    const turntable = await saved(page, 'Save turntable');
    expect(turntable.name).toBe('bar-turntable.webm');
    const seen = await watch(page, turntable.bytes);
    expect([seen.width, seen.height]).toEqual([480, 320]);
    expect(seen.duration).toBeCloseTo(0.5, 2);
    expect(seen.changed).toBeGreaterThan(0.005);

    await goTo(page, 'Test');
    const motion = await saved(page, 'Save motion');
    expect(motion.name).toBe('bar-motion.webm');
    const moved = await watch(page, motion.bytes);
    expect(moved.duration).toBeCloseTo(0.5, 2);
    expect(moved.changed).toBeGreaterThan(0.002);

    const chart = await saved(page, 'Save chart as SVG');
    expect(chart.name).toBe('bar-deviation.svg');
    const svg = chart.bytes.toString('utf8');
    const points = await page.evaluate((text) => {
      const parsed = new DOMParser().parseFromString(text, 'image/svg+xml');
      return [...parsed.querySelectorAll('polyline')].at(-1)!.getAttribute('points')!.split(' ').length;
    }, svg);
    expect(points).toBeGreaterThanOrEqual(28);
  },
);
