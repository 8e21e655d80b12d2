import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import { sheetObj } from './meshes';
import {
  commandLineBytes,
  drop,
  goTo,
  keepFaces,
  keptFaces,
  openPage,
  readout,
  saveGlb,
  writeScratch,
} from './page';

const sheet = writeScratch('painted.obj', sheetObj(24));
const button = (page: Page, name: string) => page.getByRole('button', { name, exact: true });
const brush = (page: Page, name: string) =>
  page.getByRole('group', { name: 'Brush' }).getByRole('button', { name });

async function openSheet(page: Page): Promise<void> {
  await openPage(page);
  await drop(page, sheet);
  await expect(page.locator('.filename')).toHaveText('painted.obj');
  await goTo(page, 'Reduce');
  await expect(keptFaces(page)).toBeEnabled();
}

/** A stroke over the middle of the original, which is the left one of two. */
async function stroke(page: Page, height = 30): Promise<void> {
  const box = (await page.locator('.stage canvas').boundingBox())!;
  const [x, y] = [box.x + box.width / 4, box.y + box.height / 2];
  await page.mouse.move(x, y - height);
  await page.mouse.down();
  await page.mouse.move(x, y + height, { steps: 8 });
  await page.mouse.up();
}

const flag = async (page: Page, name: string): Promise<string> => {
  const line = await page.locator('code.command').innerText();
  return new RegExp(`--${name} '?([^ ']+)`).exec(line)?.[1] ?? '';
};

test('paint keeps triangles, locks vertices, is wiped off, and undone stroke by stroke', async ({ page }) => {
  await openSheet(page);
  await brush(page, 'Keep').click();
  await stroke(page);
  await expect(page.getByText(/^\d+ kept$/)).toBeVisible();
  await brush(page, 'Lock').click();
  await stroke(page, 10);
  await expect(page.getByText(/^\d+ locked$/)).toBeVisible();
  await page.keyboard.press('Control+z');
  await expect(page.getByText(/^\d+ locked$/)).toHaveCount(0);
  await expect(page.getByText(/^\d+ kept$/)).toBeVisible();
  await page.keyboard.press('Control+Shift+Z');
  await expect(page.getByText(/^\d+ locked$/)).toBeVisible();
  await brush(page, 'Erase').click();
  await stroke(page, 60);
  await expect(page.getByText(/^\d+ (kept|locked)$/)).toHaveCount(0);
  await button(page, 'Undo').click();
  await button(page, 'Undo').click();
  await button(page, 'Undo').click();
  await expect(button(page, 'Undo')).toBeDisabled();
  await expect(button(page, 'Redo')).toBeEnabled();
});

test('a painted sheet is written with the same bytes by the command line', async ({ page }) => {
  await openSheet(page);
  await brush(page, 'Keep').click();
  await stroke(page);
  await brush(page, 'Lock').click();
  await stroke(page, 5);
  await keepFaces(page, 400);
  const bytes = await saveGlb(page);
  const paint = await flag(page, 'paint');
  expect(paint).toMatch(/^0:/);
  expect(Buffer.from(bytes).equals(commandLineBytes(sheet, ['--faces', '400', '--paint', paint]))).toBe(true);
});

test('vertices are locked with the keyboard alone, and a text that does not hold says why', async ({
  page,
}) => {
  await openSheet(page);
  await page.locator('.right summary').first().focus();
  await page.keyboard.press('Enter');
  const lock = page.getByLabel('Locked vertices');
  await lock.fill('left:3');
  await lock.press('Enter');
  await expect(page.getByRole('alert')).toContainText('This has "left:3": give low:PCT');
  await lock.fill('low:6');
  await lock.press('Enter');
  await expect(page.getByRole('alert')).toHaveCount(0);
  await button(page, 'Unlock').focus();
  await page.keyboard.press('Space');
  await expect(lock).toHaveValue('');
});

test('Escape puts the brush down, and brackets size it', async ({ page }) => {
  await openSheet(page);
  await brush(page, 'Keep').click();
  await page.keyboard.press(']');
  await expect(page.getByRole('slider', { name: 'Radius' })).toHaveValue('7.5');
  await page.keyboard.press('Escape');
  await expect(brush(page, 'Turn')).toHaveAttribute('aria-pressed', 'true');
  await stroke(page);
  await expect(page.getByText(/^\d+ kept$/)).toHaveCount(0);
});

test('a slider is undone as a whole, and the kept faces too', async ({ page }) => {
  await openSheet(page);
  const even = page.getByLabel('Even triangles', { exact: true });
  const before = await even.inputValue();
  await even.focus();
  for (let i = 0; i < 6; i++) await page.keyboard.press('ArrowRight');
  await keepFaces(page, 300);
  await button(page, 'Undo').click();
  await expect(readout(page, 'Faces')).toContainText('→ 57');
  await button(page, 'Undo').click();
  await expect(even).toHaveValue(before);
  await expect(button(page, 'Undo')).toBeDisabled();
});
