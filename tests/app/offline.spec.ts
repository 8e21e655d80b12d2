import { readFileSync, readdirSync, renameSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import { buildServiceWorker } from '../../scripts/page/offline.mjs';
import { sheetObj } from './meshes';
import { drop, goTo, keepFaces, keptFaces, readout, saveGlb, writeScratch } from './page';
import { startHost } from './static_host';
import type { StaticHost } from './static_host';

const sheet = writeScratch('offline.obj', sheetObj(16));
let host: StaticHost;
test.beforeEach(async () => {
  host = await startHost();
});
test.afterEach(() => host.close());

const isIsolated = (page: Page) => page.evaluate(() => crossOriginIsolated).catch(() => false);

/** Visits the page once: the service worker caches everything, and the page reloads itself for shared memory. */
async function visit(page: Page): Promise<void> {
  await page.goto(host.address);
  await expect.poll(() => isIsolated(page)).toBe(true);
  await expect(page.getByRole('button', { name: 'Open', exact: true })).toBeVisible();
}

/** Opens the sheet and reduces it to 200 faces. */
async function reduceSheet(page: Page): Promise<void> {
  await drop(page, sheet);
  await expect(page.locator('.filename')).toHaveText('offline.obj');
  await goTo(page, 'Reduce');
  await expect(keptFaces(page)).toBeEnabled();
  await keepFaces(page, 200);
}

test('after one visit everything works offline, from a folder of a host without headers', async ({
  page,
  context,
}) => {
  await visit(page);
  await host.close();
  await context.setOffline(true);
  await page.reload();
  expect(await isIsolated(page)).toBe(true);
  await reduceSheet(page);
  const bytes = await saveGlb(page);
  expect(new TextDecoder().decode(bytes.slice(0, 4))).toBe('glTF');
  await expect(page.getByText('No errors')).toBeVisible();
  await page.keyboard.press('Control+e');
  await goTo(page, 'Test');
  await expect(readout(page, 'Speed-up')).toContainText(/^x\d/);
  // The codecs and the samples are cached too.
  const kept = await page.evaluate(async () => {
    const names = await caches.keys();
    const requests = await Promise.all(names.map(async (name) => (await caches.open(name)).keys()));
    return requests.flat().map(({ url }) => url);
  });
  for (const part of ['draco_decoder', 'meshopt_decoder', 'limber-threads.wasm', 'samples/bar.glb'])
    expect(kept.some((address) => address.includes(part))).toBe(true);
});

test('a host that shows no index.html for a folder, and knows no type of the core, serves it too', async ({
  page,
  context,
}) => {
  const plain = await startHost('app', true);
  await page.goto(`${plain.address}index.html`);
  await expect.poll(() => isIsolated(page)).toBe(true);
  await expect(page.getByRole('button', { name: 'Open', exact: true })).toBeVisible();
  await plain.close();
  await context.setOffline(true);
  await page.reload();
  await reduceSheet(page);
  expect((await saveGlb(page)).length).toBeGreaterThan(1000);
});

test('without a service worker too the core starts from a host that knows no type of its files', async ({
  browser,
}) => {
  const plain = await startHost('app', true);
  const context = await browser.newContext({ serviceWorkers: 'block' });
  const page = await context.newPage();
  await page.goto(`${plain.address}index.html`);
  await expect(page.getByText('1 thread', { exact: true })).toBeVisible();
  await reduceSheet(page);
  await context.close();
  await plain.close();
});

test(
  'a part that is gone from the host is said, and a reload brings the work back',
  { tag: '@full' },
  async ({ browser }) => {
    const context = await browser.newContext({ serviceWorkers: 'block' });
    const page = await context.newPage();
    await page.goto(host.address);
    await expect(page.getByText('1 thread', { exact: true })).toBeVisible();
    await reduceSheet(page);
    const assets = join(host.folder, 'assets');
    // The parts that are only loaded by an export.
    const late = readdirSync(assets).filter((name) => /^(module|dist)-.*\.js$/.test(name));
    expect(late.length).toBeGreaterThan(0);
    for (const name of late) renameSync(join(assets, name), join(assets, `gone-${name}`));
    await page.getByRole('button', { name: 'Export', exact: true }).click();
    await expect(page.getByRole('alert')).toContainText('Reload; your work is restored.');
    for (const name of late) renameSync(join(assets, `gone-${name}`), join(assets, name));
    await page.getByRole('alert').getByRole('button', { name: 'Reload' }).click();
    await expect(page.locator('.filename')).toHaveText('offline.obj');
    await expect(page.getByLabel('Kept faces, exact')).toHaveValue('200');
    expect((await saveGlb(page)).length).toBeGreaterThan(1000);
    await context.close();
  },
);

test('an open page does not take the core of a newer version', { tag: '@full' }, async ({ browser }) => {
  const context = await browser.newContext({ serviceWorkers: 'block' });
  const page = await context.newPage();
  await page.goto(host.address);
  await reduceSheet(page);
  const wasm = join(host.folder, 'wasm');
  const [version, ...others] = readdirSync(wasm);
  expect(others).toEqual([]);
  renameSync(join(wasm, version), join(wasm, '0123456789ab'));
  await goTo(page, 'Test');
  await expect(page.locator('.twin-alert')).toContainText('reload the page, and your work is restored');
  const notice = page.getByRole('alert').filter({ hasText: 'Reload; your work is restored.' });
  await expect(notice.getByRole('button', { name: 'Reload' })).toBeVisible();
  await context.close();
});

test(
  'a new version waits until the user reloads, and the open page goes on with its own files',
  { tag: '@full' },
  async ({ page }) => {
    await visit(page);
    await reduceSheet(page);
    const [index, assets] = [join(host.folder, 'index.html'), join(host.folder, 'assets')];
    const late = readdirSync(assets).filter((name) => /^(module|dist)-.*\.js$/.test(name));
    for (const name of late) renameSync(join(assets, name), join(assets, `newer-${name}`));
    writeFileSync(index, readFileSync(index, 'utf8').replace('<title>Limber', '<title>Newer Limber'));
    await buildServiceWorker(host.folder);
    await page.evaluate(async () => (await navigator.serviceWorker.ready).update());
    const notice = page.getByRole('status').filter({ hasText: 'A new version is ready.' });
    await expect(notice).toBeVisible();
    expect((await saveGlb(page)).length).toBeGreaterThan(1000);
    await notice.getByRole('button', { name: 'Reload' }).click();
    await expect(page).toHaveTitle('Newer Limber');
    await expect(page.locator('.filename')).toHaveText('offline.obj');
    await expect(page.getByLabel('Kept faces, exact')).toHaveValue('200');
  },
);

test(
  'a version that never arrived whole does not push out the one that a tab still shows',
  { tag: '@full' },
  async ({ page }) => {
    await visit(page);
    const [shown] = await page.evaluate(() => caches.keys());
    const [index, sample] = ['index.html', 'samples/tower.glb'].map((name) => join(host.folder, name));
    const [text, whole] = [readFileSync(index, 'utf8'), readFileSync(sample)];
    const deploy = async (title: string) => {
      writeFileSync(index, text.replace('<title>Limber', `<title>${title}`));
      await buildServiceWorker(host.folder);
    };
    writeFileSync(sample, 'of this version');
    await deploy('Broken');
    writeFileSync(sample, 'of another version');
    const update = () =>
      page.evaluate(async () => void (await (await navigator.serviceWorker.ready).update().catch(() => {})));
    await update();
    await expect.poll(() => page.evaluate(async () => (await caches.keys()).length)).toBe(2);
    await expect
      .poll(() => page.evaluate(async () => (await navigator.serviceWorker.ready).installing === null))
      .toBe(true);
    writeFileSync(sample, whole);
    await deploy('Newer');
    await update();
    await page.getByRole('status').getByRole('button', { name: 'Reload' }).click();
    await expect(page).toHaveTitle(/^Newer/);
    const kept = await page.evaluate(() => caches.keys());
    expect([kept.length, kept[0]]).toEqual([2, shown]);
  },
);
