// The built page, served and opened in Chromium.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { preview } from 'vite';
import { findChromium, root } from '../../../scripts/setup/environment.mjs';
import { observe } from './observe.mjs';

const PORT = 4392;
export const ADDRESS = `http://localhost:${PORT}/`;

/** Calls `use(browser)` while the page is served. */
export async function withBrowser(use, options = []) {
  const configFile = join(root, 'vite.config.ts');
  const server = await preview({ configFile, preview: { port: PORT, strictPort: true }, logLevel: 'silent' });
  const flags = JSON.parse(readFileSync(join(root, 'tests', 'browser-arguments.json'), 'utf8'));
  const browser = await chromium.launch({
    executablePath: findChromium(),
    args: [...flags, '--use-angle=swiftshader', '--enable-unsafe-swiftshader', ...options],
  });
  try {
    await use(browser);
  } finally {
    await browser.close();
    await server.close();
  }
}

/** A fresh page that is watched and has started. */
export async function openWatched(browser) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 } });
  const page = await context.newPage();
  await page.addInitScript(observe);
  await page.goto(ADDRESS);
  await page.waitForFunction(() => globalThis.measured.usable !== null);
  return page;
}

/** Drops files from the disk onto the page, with the events of a real drop. */
export async function drop(page, ...files) {
  const client = await page.context().newCDPSession(page);
  const data = { items: [], files, dragOperationsMask: 1 };
  for (const type of ['dragEnter', 'dragOver', 'drop'])
    await client.send('Input.dispatchDragEvent', { type, x: 640, y: 300, data });
  await client.detach();
}

export const goTo = (page, step) => page.locator(`nav button`).filter({ hasText: step }).first().click();
