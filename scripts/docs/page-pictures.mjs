// Takes the pictures of the page that the README shows. Usage, after `npm run build`: node scripts/docs/page-pictures.mjs

import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { chromium } from '@playwright/test';

const root = join(import.meta.dirname, '..', '..');
const folder = join(root, 'docs', 'images');
const port = 4275;
const shared = JSON.parse(readFileSync(join(root, 'tests', 'browser-arguments.json'), 'utf8'));

const goTo = (page, step) =>
  page.getByRole('navigation', { name: 'Steps' }).getByRole('button', { name: step }).click();

/** Waits until nothing runs, and a little longer for the camera. */
async function settle(page, milliseconds = 1500) {
  await page.waitForTimeout(milliseconds);
  await page.waitForFunction(() => !document.querySelector('.notice.busy'), null, { timeout: 120_000 });
  await page.waitForTimeout(milliseconds);
}

async function open(page, sample) {
  await page.goto(`http://localhost:${port}/?sample=${sample}`);
  await page.waitForSelector('.readouts');
  const hints = page.getByRole('button', { name: 'No hints' });
  if (await hints.isVisible()) await hints.click();
}

const PICTURES = {
  start: async (page) => {
    await page.goto(`http://localhost:${port}/`);
    await page.waitForSelector('.card');
    await page.waitForTimeout(4000);
  },
  motion: async (page) => {
    await open(page, 'organic');
    await goTo(page, 'Motion');
    await settle(page);
  },
  reduce: async (page) => {
    await open(page, 'organic');
    await goTo(page, 'Reduce');
    await settle(page, 3000);
  },
  brush: async (page) => {
    await open(page, 'organic');
    await goTo(page, 'Reduce');
    await settle(page);
    await page.getByRole('button', { name: 'Keep', exact: true }).click();
    const box = await page.locator('.viewport canvas').boundingBox();
    const at = (x, y) => [box.x + x * box.width, box.y + y * box.height];
    await page.mouse.move(...at(0.24, 0.25));
    await page.mouse.down();
    await page.mouse.move(...at(0.22, 0.5), { steps: 12 });
    await page.mouse.up();
    await settle(page, 3000);
  },
  test: async (page) => {
    await open(page, 'bar');
    await goTo(page, 'Test');
    await page.getByRole('button', { name: 'Deviation', exact: true }).click();
    await settle(page, 4000);
  },
};

const server = spawn(
  process.execPath,
  ['node_modules/vite/bin/vite.js', 'preview', '--port', String(port), '--strictPort'],
  { cwd: root, stdio: ['ignore', 'pipe', 'inherit'] },
);
try {
  await once(server.stdout, 'data');
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: [...shared, '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
  const wanted = process.argv.slice(2);
  for (const [name, take] of Object.entries(PICTURES)) {
    if (wanted.length > 0 && !wanted.includes(name)) continue;
    const context = await browser.newContext({
      viewport: { width: 1280, height: 800 },
      colorScheme: 'light',
    });
    const page = await context.newPage();
    await take(page);
    await page.screenshot({ path: join(folder, `${name}.png`) });
    await context.close();
  }
  await browser.close();
} finally {
  server.kill();
}
