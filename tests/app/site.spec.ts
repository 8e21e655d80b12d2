/** The site: documents, gallery and app, served from a folder by a host that sends no headers. */

import { readdirSync } from 'node:fs';
import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import { readout } from './page';
import { startHost } from './static_host';
import type { StaticHost } from './static_host';

let host: StaticHost;

test.beforeAll(async () => {
  host = await startHost('site');
});
test.afterAll(() => host.close());

/** Collects the problems of a page from now on: errors and missing files. */
function problemsOf(page: Page): string[] {
  const problems: string[] = [];
  page.on('pageerror', ({ message }) => problems.push(message));
  page.on('response', (response) => {
    if (response.status() >= 400) problems.push(`${response.status()} ${response.url()}`);
  });
  return problems;
}

async function violations(page: Page): Promise<string[]> {
  const { violations: found } = await new AxeBuilder({ page }).analyze();
  return found.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(' ')}`);
}

test('every page opens whole, from narrow to wide windows', async ({ page }) => {
  const problems = problemsOf(page);
  const pages = readdirSync(host.folder, { recursive: true })
    .map(String)
    .filter((name) => name.endsWith('.html') && !name.startsWith('app'));
  expect(pages.length).toBeGreaterThan(20);
  for (const name of pages) {
    await page.goto(host.address + name);
    await expect(page.locator('h1')).toBeVisible();
    for (const width of [390, 820, 1440]) {
      await page.setViewportSize({ width, height: 800 });
      expect([name, await page.evaluate(() => document.documentElement.scrollWidth)]).toEqual([name, width]);
    }
  }
  expect(problems).toEqual([]);
});

for (const colorScheme of ['light', 'dark'] as const)
  test(`its pages pass axe in the ${colorScheme} scheme`, async ({ browser }) => {
    const context = await browser.newContext({ colorScheme, reducedMotion: 'reduce' });
    const page = await context.newPage();
    for (const name of ['index.html', 'gallery/index.html', 'guide.html', 'docs/engines.html']) {
      await page.goto(host.address + name);
      expect([name, await violations(page)]).toEqual([name, []]);
    }
    await context.close();
  });

test('results of the gallery turn, and move when asked to', async ({ browser }) => {
  const context = await browser.newContext({ reducedMotion: 'reduce' });
  const page = await context.newPage();
  const problems = problemsOf(page);
  await page.goto(`${host.address}gallery/index.html`);
  await expect(page.locator('body')).toHaveAttribute('data-shown', '8');
  const canvases = page.locator('.result').first().locator('canvas');
  const pictures = () =>
    canvases.evaluateAll((all) => all.map((canvas) => (canvas as HTMLCanvasElement).toDataURL()));
  const [original, result, motion] = await pictures();
  expect(new Set([original, result, motion]).size).toBe(3);

  await canvases.first().press('ArrowRight');
  await expect.poll(async () => (await pictures())[0]).not.toBe(original);
  await expect.poll(async () => (await pictures())[1]).not.toBe(result);
  expect((await pictures())[2]).toBe(motion);

  await page.getByRole('checkbox', { name: 'Motion' }).check();
  await expect.poll(async () => (await pictures())[2]).not.toBe(motion);
  expect(problems).toEqual([]);
  await context.close();
});

test('the app opens from the gallery with its model', async ({ page }) => {
  await page.goto(`${host.address}gallery/index.html`);
  await page.getByRole('link', { name: 'Open it in the app' }).last().click();
  await expect(readout(page, 'Faces')).toContainText('1,792');
});
