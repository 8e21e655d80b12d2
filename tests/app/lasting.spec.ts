import { expect, test } from '@playwright/test';
import type { BrowserContext, Page } from '@playwright/test';
import { sheetObj } from './meshes';
import { drop, goTo, keepFaces, keptFaces, openPage, readout, writeScratch } from './page';
import { followWorkers, killWorker, settle } from './workers';

const sheet = writeScratch('lasting.obj', sheetObj(16));
const larger = writeScratch('larger.obj', sheetObj(90));

async function openSheet(page: Page, path = sheet): Promise<void> {
  await drop(page, path);
  await expect(page.locator('.filename')).toHaveText(path.split('/').pop()!);
}

test('a worker that has ended is noticed and started again, and the work goes on', async ({ page }) => {
  await followWorkers(page);
  await openPage(page);
  await openSheet(page);
  await goTo(page, 'Reduce');
  await expect(keptFaces(page)).toBeEnabled();
  await keepFaces(page, 200);
  await expect(readout(page, 'Deviation')).toContainText('%');
  await settle(page);
  await killWorker(page);
  await expect(page.getByText('It was restarted, and your work is unchanged.')).toBeVisible();
  await keepFaces(page, 150);
  await expect(readout(page, 'Deviation')).not.toContainText('...');
});

test('a worker that ends while it computes is noticed, and the work is offered again', async ({ page }) => {
  await followWorkers(page);
  await openPage(page);
  await openSheet(page, larger);
  await goTo(page, 'Reduce');
  await expect(page.locator('.notice.busy')).toBeVisible();
  await killWorker(page);
  await expect(page.getByRole('alert')).toContainText('The computation has stopped unexpectedly');
  await page.getByRole('button', { name: 'Run again' }).click();
  await expect(keptFaces(page)).toBeEnabled();
});

test('Undo survives a reload', async ({ page }) => {
  await openPage(page);
  await openSheet(page);
  await goTo(page, 'Reduce');
  await expect(keptFaces(page)).toBeEnabled();
  await page.getByLabel('Even triangles, exact').fill('0.3');
  await keepFaces(page, 200);
  await page.reload();
  await expect(page.getByLabel('Kept faces, exact')).toHaveValue('200');
  const undo = page.getByRole('button', { name: /^Undo/ });
  await undo.click();
  await expect(page.getByLabel('Kept faces, exact')).toHaveValue('256');
  await expect(page.getByLabel('Even triangles, exact')).toHaveValue('0.3');
  await undo.click();
  await expect(page.getByLabel('Even triangles, exact')).not.toHaveValue('0.3');
  await page.getByRole('button', { name: /^Redo/ }).click();
  await expect(page.getByLabel('Even triangles, exact')).toHaveValue('0.3');
});

/** A tab that begins with a copy of the other's session storage, as a duplicated tab does. */
async function duplicate(page: Page, context: BrowserContext): Promise<Page> {
  const storage = await page.evaluate(() => Object.entries(sessionStorage));
  const copy = await context.newPage();
  await copy.addInitScript((entries) => {
    if (sessionStorage.length === 0) for (const [key, value] of entries) sessionStorage.setItem(key, value);
  }, storage);
  await copy.goto('/');
  return copy;
}

test(
  'two tabs keep their own work, also one that is a copy of the other',
  { tag: '@full' },
  async ({ page, context }) => {
    await openPage(page);
    await openSheet(page);
    await goTo(page, 'Reduce');
    await keepFaces(page, 200);
    await page.waitForTimeout(600); // until it is saved
    const copy = await duplicate(page, context);
    await expect(copy.locator('.filename')).toHaveText('lasting.obj');
    await expect(copy.getByLabel('Kept faces, exact')).toHaveValue('200');
    await keepFaces(copy, 120);
    await copy.waitForTimeout(600);
    await page.reload();
    await expect(page.getByLabel('Kept faces, exact')).toHaveValue('200');
    await copy.reload();
    await expect(copy.getByLabel('Kept faces, exact')).toHaveValue('120');
  },
);

test(
  'a new tab offers the work of the last one that was closed',
  { tag: '@full' },
  async ({ page, context }) => {
    await openPage(page);
    await openSheet(page);
    await goTo(page, 'Reduce');
    await keepFaces(page, 200);
    await page.waitForTimeout(600);
    await page.close();
    const later = await context.newPage();
    await later.goto('/');
    await later.getByRole('button', { name: 'Open it' }).click();
    await expect(later.locator('.filename')).toHaveText('lasting.obj');
    await expect(later.getByLabel('Kept faces, exact')).toHaveValue('200');
  },
);

test('a lost context comes back with its picture', { tag: '@full' }, async ({ page }) => {
  await openPage(page);
  await openSheet(page);
  const canvas = page.locator('.viewport canvas');
  await settle(page);
  const before = await canvas.screenshot();
  await canvas.evaluate(async (element: HTMLCanvasElement) => {
    const wait = (name: string) =>
      new Promise((resolve) => element.addEventListener(name, resolve, { once: true }));
    const loss = element.getContext('webgl2')!.getExtension('WEBGL_lose_context')!;
    const lost = wait('webglcontextlost');
    loss.loseContext();
    await lost;
    const restored = wait('webglcontextrestored');
    await new Promise((resolve) => setTimeout(resolve, 100));
    loss.restoreContext();
    await restored;
  });
  await expect(async () => {
    expect((await canvas.screenshot()).equals(before)).toBe(true);
  }).toPass();
});
