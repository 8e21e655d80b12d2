import { expect, test } from '@playwright/test';
import type { BrowserContext, Page } from '@playwright/test';
import { sheetObj } from './meshes';
import { drop, goTo, keepFaces, keptFaces, openPage, readout, writeScratch } from './page';

const sheet = writeScratch('lasting.obj', sheetObj(16));
const larger = writeScratch('larger.obj', sheetObj(90));

/** Ends the worker of the page as a browser does that runs out of memory: without an event. */
async function killWorker(page: Page): Promise<void> {
  const own = page.workers().find((worker) => /\/worker-[^/]*\.js$/.test(worker.url()));
  await own!.evaluate(() => close());
}

async function openSheet(page: Page, path = sheet): Promise<void> {
  await drop(page, path);
  await expect(page.locator('.filename')).toHaveText(path.split('/').pop()!);
}

test('a worker that has ended is noticed and started again, and the work goes on', async ({ page }) => {
  await openPage(page);
  await openSheet(page);
  await goTo(page, 'Reduce');
  await expect(keptFaces(page)).toBeEnabled();
  await keepFaces(page, 200);
  await expect(page.locator('.notice.busy')).toHaveCount(0);
  await expect(readout(page, 'Deviation')).toContainText('%');
  await killWorker(page);
  await expect(page.getByText('It has started again, and your work is as it was.')).toBeVisible();
  await keepFaces(page, 150);
  await expect(readout(page, 'Deviation')).not.toContainText('...');
});

test('a worker that ends while it computes is noticed, and the work is offered again', async ({ page }) => {
  await openPage(page);
  await openSheet(page, larger);
  await goTo(page, 'Reduce');
  await expect(page.locator('.notice.busy')).toBeVisible();
  const { length } = page.workers();
  // A computing worker runs no code of a test, so the browser ends it.
  const browser = await page.context().newCDPSession(page);
  const { targetInfos } = await browser.send('Target.getTargets');
  const target = targetInfos.find(({ type, url }) => type === 'worker' && /\/worker-[^/]*\.js$/.test(url));
  if (target) await browser.send('Target.closeTarget', { targetId: target.targetId });
  else await killWorker(page);
  await expect(page.getByRole('alert')).toContainText('The computation has stopped unexpectedly');
  expect(length).toBeGreaterThan(0);
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

test('two tabs keep their own work, also one that is a copy of the other', async ({ page, context }) => {
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
});

test('a new tab offers the work of the last one that was closed', async ({ page, context }) => {
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
});

test('a lost context comes back with its picture', async ({ page }) => {
  await openPage(page);
  await openSheet(page);
  const canvas = page.locator('.viewport canvas');
  const before = await canvas.screenshot();
  const wait = (name: string) =>
    canvas.evaluate(
      (element, event) => new Promise((r) => element.addEventListener(event, r, { once: true })),
      name,
    );
  await page.evaluate(() => {
    const gl = document.querySelector<HTMLCanvasElement>('.viewport canvas')!.getContext('webgl2')!;
    Object.assign(window, { lost: gl.getExtension('WEBGL_lose_context') });
  });
  const end = (name: 'loseContext' | 'restoreContext') =>
    page.evaluate((call) => (window as unknown as { lost: WEBGL_lose_context }).lost[call](), name);
  const lost = wait('webglcontextlost');
  await end('loseContext');
  await lost;
  const restored = wait('webglcontextrestored');
  await page.waitForTimeout(100);
  await end('restoreContext');
  await restored;
  await expect(async () => {
    expect((await canvas.screenshot()).equals(before)).toBe(true);
  }).toPass();
});
