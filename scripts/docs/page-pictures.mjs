// Takes the pictures of the page for the README, including the animated one. Usage, after `npm run build`:
// node scripts/docs/page-pictures.mjs [name ...]

import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { copyFileSync, readFileSync } from 'node:fs';
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

async function keepFaces(page, ratio) {
  const slider = page.getByRole('slider', { name: 'Kept faces' });
  await slider.fill(String(Math.round(ratio * Number(await slider.getAttribute('max')))));
  await settle(page);
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
    await open(page, 'cloth');
    await goTo(page, 'Reduce');
    await settle(page);
    await keepFaces(page, 0.25);
    await goTo(page, 'Test');
    await page.getByLabel('Solver', { exact: true }).selectOption({ label: 'Jolt' });
    await page.getByRole('button', { name: 'Tuned', exact: true }).click();
    await page.getByRole('button', { name: 'Deviation', exact: true }).click();
    await settle(page, 4000);
  },
};

/** The Test step's motion, as its own GIF: the original on the left, a fifth of its faces on the right. */
async function saveMoving(page) {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page, 'organic');
  await goTo(page, 'Reduce');
  await settle(page);
  await keepFaces(page, 0.2);
  await goTo(page, 'Test');
  await page.getByLabel('Scenario', { exact: true }).selectOption({ label: 'Sway' });
  await settle(page);
  await page.getByRole('button', { name: 'Pictures', exact: true }).click();
  await page.getByLabel('Size', { exact: true }).selectOption('custom');
  const fields = { 'Width in pixels': 480, 'Height in pixels': 320, Seconds: 2 };
  for (const [label, value] of Object.entries(fields)) {
    await page.getByLabel(label).fill(String(value));
    await page.getByLabel(label).press('Tab');
  }
  await page.getByRole('button', { name: 'GIF', exact: true }).click();
  const saved = page.waitForEvent('download', { timeout: 600_000 });
  await page.getByRole('button', { name: 'Save motion' }).click();
  copyFileSync(await (await saved).path(), join(folder, 'moving.gif'));
}

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
  const stills = Object.entries(PICTURES).map(([name, take]) => [
    name,
    async (page) => {
      await take(page);
      await page.screenshot({ path: join(folder, `${name}.png`) });
    },
  ]);
  for (const [name, save] of [...stills, ['moving', saveMoving]]) {
    if (wanted.length > 0 && !wanted.includes(name)) continue;
    const context = await browser.newContext({
      viewport: { width: 1280, height: 800 },
      colorScheme: 'light',
    });
    await save(await context.newPage());
    await context.close();
  }
  await browser.close();
} finally {
  server.kill();
}
