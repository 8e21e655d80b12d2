import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import { drop, goTo, openPage, readout, SPEED_UP, writeScratch } from './page';
import { sheetObj } from './meshes';
import { stillCapture } from './pictures';

const card = (page: Page, name: string) =>
  page.getByRole('region', { name: 'Or try a sample' }).getByRole('button', { name });

test('the page begins with a place to drop a file, and samples that move', async ({ page }) => {
  await page.goto('/');
  await expect(page.getByRole('heading', { name: 'Fewer triangles that still move right' })).toBeVisible();
  await expect(page.getByText('Your file stays on this computer.')).toBeVisible();
  await expect(page.locator('.readouts')).toHaveCount(0);
  const picture = card(page, 'Lattice tower').locator('canvas');
  const drawn = () =>
    picture.evaluate((canvas: HTMLCanvasElement) => {
      const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
      return data.reduce((sum, value, i) => (sum * 31 + value * (i % 97)) % 1_000_003, 0);
    });
  await expect.poll(drawn).not.toBe(0);
  const first = await drawn();
  await expect.poll(drawn).not.toBe(first);
  await card(page, 'Bar').click();
  await expect(readout(page, 'Faces')).toContainText('1,792');
  await expect(page.getByText('Your file stays on this computer.')).toHaveCount(0);
});

test('a sample that is opened by keyboard leaves the focus at the step, and its hint at the panel', async ({
  page,
}) => {
  await page.goto('/');
  await expect(page.locator('.viewport canvas')).toHaveAttribute('tabindex', '-1');
  await card(page, 'Bar').press('Enter');
  await expect(page.getByRole('button', { name: 'Model' }).and(page.locator('[aria-current]'))).toBeFocused();
  await expect(page.locator('.viewport canvas')).toHaveAttribute('tabindex', '0');
  await page.getByRole('button', { name: 'Got it' }).press('Enter');
  await expect(page.getByRole('complementary', { name: 'Settings of this step' })).toBeFocused();
});

test('drawing is prepared behind the start screen, and nothing of that is seen', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'light' });
  const light = page.waitForResponse(/room_light/);
  await page.goto('/');
  await light;
  await page.waitForTimeout(2000);
  await page.locator('.start').evaluate((start: HTMLElement) => (start.style.visibility = 'hidden'));
  const png = await stillCapture(page);
  const darkest = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
    context.drawImage(bitmap, 0, 0);
    return context
      .getImageData(0, 0, bitmap.width, bitmap.height)
      .data.reduce((least, value) => Math.min(least, value));
  }, png.toString('base64'));
  // The ground alone, whose darkest colour is #dfe6ec.
  expect(darkest).toBeGreaterThan(215);
});

test(
  'a first visit shows a hint on every step, and a dismissed one stays away',
  { tag: '@full' },
  async ({ page }) => {
    await openPage(page);
    const hint = page.getByRole('region', { name: 'Hint' });
    for (const [step, number] of [
      ['Model', '1'],
      ['Motion', '2'],
      ['Reduce', '3'],
      ['Test', '4'],
    ] as const) {
      await goTo(page, step);
      await expect(hint).toContainText(`${number} of 4.`);
    }
    await goTo(page, 'Model');
    await hint.getByRole('button', { name: 'Got it' }).click();
    await expect(hint).toHaveCount(0);
    await page.reload();
    await expect(readout(page, 'Faces')).toContainText('1,792');
    await expect(hint).toHaveCount(0);
    await goTo(page, 'Reduce');
    await hint.getByRole('button', { name: 'No hints' }).click();
    await goTo(page, 'Motion');
    await expect(hint).toHaveCount(0);
  },
);

test('a file that cannot be used never takes the place of the open one', async ({ page }) => {
  await openPage(page);
  const alert = page.getByRole('alert');
  // All of its faces are lines: it reads well and cannot be prepared.
  await drop(page, writeScratch('lines.obj', 'v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 2\nf 2 3 3\n'));
  await expect(alert).toContainText('Body "lines" has no usable face');
  await expect(page.locator('.left .filename').first()).toHaveText('bar.glb');
  await expect(readout(page, 'Faces')).toContainText('1,792');
  await drop(page, writeScratch('chair.fbx', 'Kaydara FBX Binary'));
  await expect(alert).toContainText('import it in Blender and choose File > Export > glTF 2.0 (.glb)');
  await drop(page, writeScratch('chair.blend', 'BLENDER'));
  await expect(alert).toContainText('chair.blend is a Blender file');
  await expect(readout(page, 'Faces')).toContainText('1,792');
  await goTo(page, 'Motion');
  await expect(page.getByRole('button', { name: /^Mode 1 / })).toBeVisible();
});

test('files beside a model that are left out are named, with the cure', async ({ page }) => {
  await page.goto('/');
  const notice = page.locator('.notices .notice.info');
  const [sheet, chair] = [writeScratch('sheet.obj', sheetObj(8)), writeScratch('stool.fbx', 'Kaydara FBX')];
  await drop(page, sheet, chair);
  await expect(page.locator('.filename')).toHaveText('sheet.obj');
  await expect(notice).toContainText(
    'stool.fbx is in a format that Limber cannot read: import it in Blender',
  );
  await drop(page, sheet, writeScratch('sheet.settings.json', '{}'));
  await expect(notice).toContainText('sheet.settings.json was left out: drop it alone once the model');
  await drop(page, sheet, writeScratch('sheet.png', ''));
  await expect(notice).toHaveCount(0);
  await drop(page, sheet, writeScratch('other.obj', sheetObj(6)), chair, writeScratch('b.blend', 'BLENDER'));
  await expect(page.getByRole('button', { name: 'Optimize all 2' })).toBeVisible();
  await expect(notice).toContainText(/stool\.fbx is .* 1 other was left out, too\./);
});

test('the Test step shows no numbers of a model that is gone', async ({ page }) => {
  await openPage(page);
  await goTo(page, 'Test');
  await expect(readout(page, 'Speed-up')).toContainText(SPEED_UP);
  await page.evaluate(() => {
    const seen: string[] = ((window as unknown as { seen: string[] }).seen = []);
    const look = () => {
      const name = document.querySelector('.left .filename')?.textContent ?? '';
      const faces = document.querySelector('.pane-labels')?.textContent ?? '';
      const text = document.querySelector('.readouts')?.textContent ?? '';
      if (name === 'other.obj' && !faces.includes('8,450') && /x\d|none/.test(text)) seen.push(text);
      requestAnimationFrame(look);
    };
    look();
  });
  await drop(page, writeScratch('other.obj', sheetObj(65)));
  await expect(page.locator('.pane-labels')).toContainText('8,450');
  await expect(readout(page, 'Speed-up')).toContainText(/^x\d/);
  expect(await page.evaluate(() => (window as unknown as { seen: string[] }).seen)).toEqual([]);
});
