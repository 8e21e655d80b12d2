// Measures the built page against its targets and prints one table.
// Usage: node tests/bench/page.mjs [--faces 7000,16000,100000]     (after npm run build; needs Chromium)
//
// Chromium draws in software here. Time inside calls of WebGL is measured by itself and subtracted from tasks.

import { mkdtempSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { brotliCompressSync } from 'node:zlib';
import { chromium } from '@playwright/test';
import { preview } from 'vite';
import { findChromium, root } from '../../scripts/setup/environment.mjs';

const { faces } = parseArgs({ options: { faces: { type: 'string', default: '7000,16000,100000' } } }).values;
const scratch = mkdtempSync(join(tmpdir(), 'limber-bench-'));
const rows = [];
const add = (what, value, target) => rows.push({ what, value, target });

/** A wavy torus of about `count` faces as OBJ; returns its path. */
function writeTorus(count) {
  const [m, n] = [Math.round(Math.sqrt(count)), Math.round(Math.sqrt(count) / 2)];
  const lines = [];
  for (let i = 0; i < m; i++)
    for (let j = 0; j < n; j++) {
      const [u, v] = [(2 * Math.PI * i) / m, (2 * Math.PI * j) / n];
      const r = 0.4 + 0.05 * Math.sin(5 * u);
      lines.push(
        `v ${(1 + r * Math.cos(v)) * Math.cos(u)} ${r * Math.sin(v)} ${(1 + r * Math.cos(v)) * Math.sin(u)}`,
      );
    }
  const at = (i, j) => (i % m) * n + (j % n) + 1;
  for (let i = 0; i < m; i++)
    for (let j = 0; j < n; j++) {
      lines.push(`f ${at(i, j)} ${at(i, j + 1)} ${at(i + 1, j)}`);
      lines.push(`f ${at(i + 1, j)} ${at(i, j + 1)} ${at(i + 1, j + 1)}`);
    }
  const path = join(scratch, `torus-${count}.obj`);
  writeFileSync(path, lines.join('\n'));
  return path;
}

/** Runs in the page before its own scripts: collects long tasks, and the time inside calls of WebGL. */
function observe() {
  const measured = { tasks: [], gl: [], usable: null };
  globalThis.measured = measured;
  new PerformanceObserver((list) => {
    for (const { startTime, duration } of list.getEntries()) measured.tasks.push({ startTime, duration });
  }).observe({ type: 'longtask', buffered: true });
  for (const name of Object.getOwnPropertyNames(WebGL2RenderingContext.prototype)) {
    const { value } = Object.getOwnPropertyDescriptor(WebGL2RenderingContext.prototype, name);
    if (typeof value !== 'function' || name === 'constructor') continue;
    WebGL2RenderingContext.prototype[name] = function (...args) {
      const start = performance.now();
      const result = value.apply(this, args);
      const duration = performance.now() - start;
      if (duration > 0.2) measured.gl.push({ start, duration });
      return result;
    };
  }
  new MutationObserver((_, observer) => {
    const open = [...document.querySelectorAll('button')].some(
      (button) => button.textContent.trim() === 'Open' && !button.disabled,
    );
    if (!open) return;
    measured.usable = performance.now();
    observer.disconnect();
  }).observe(document, { childList: true, subtree: true });
}

/** The longest task since the last call without its calls of WebGL, and these calls; in ms. */
async function longestTask(page) {
  return page.evaluate(() => {
    const { tasks, gl } = globalThis.measured;
    const parts = tasks.map(({ startTime, duration }) => {
      const inside = gl.filter(({ start }) => start >= startTime && start < startTime + duration);
      const calls = inside.reduce((sum, call) => sum + call.duration, 0);
      return { own: duration - calls, calls };
    });
    tasks.length = gl.length = 0;
    return parts.reduce((most, part) => (part.own > most.own ? part : most), { own: 0, calls: 0 });
  });
}

const describeTask = ({ own, calls }) =>
  own === 0 ? 'none over 50 ms' : `${own.toFixed(0)} ms (and ${calls.toFixed(0)} ms in WebGL)`;

async function measureStart(browser, address) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 } });
  const page = await context.newPage();
  await page.addInitScript(observe);
  await page.goto(address);
  await page.waitForFunction(() => globalThis.measured.usable !== null);
  const paint = await page.evaluate(
    () => performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? NaN,
  );
  const usable = await page.evaluate(() => globalThis.measured.usable);
  add('first paint, cold', `${paint.toFixed(0)} ms`, '800 ms');
  add('usable, cold', `${usable.toFixed(0)} ms`, '1,400 ms');
  await context.close();
}

function measureSizes() {
  const folder = join(root, 'dist', 'app');
  const assets = readdirSync(join(folder, 'assets')).map((name) => `assets/${name}`);
  const index = readFileSync(join(folder, 'index.html'), 'utf8');
  const first = ['index.html', ...assets.filter((name) => index.includes(name))];
  const core = ['wasm/limber-threads.wasm', 'wasm/limber-threads.mjs'];
  const size = (names) =>
    names.reduce((sum, name) => sum + brotliCompressSync(readFileSync(join(folder, name))).length, 0);
  add('page, compressed', `${(size(first) / 1000).toFixed(0)} kB`, '300 kB');
  add('core, compressed', `${(size(core) / 1000).toFixed(0)} kB`, '520 kB');
}

async function drop(page, file) {
  const client = await page.context().newCDPSession(page);
  const data = { items: [], files: [file], dragOperationsMask: 1 };
  for (const type of ['dragEnter', 'dragOver', 'drop'])
    await client.send('Input.dispatchDragEvent', { type, x: 640, y: 300, data });
}

/** Moves the slider to 20 places; returns the median time until the label has changed, in ms. */
const scrub = (page) =>
  page.evaluate(async () => {
    const input = document.querySelector(
      'input[type="range"][aria-label="Kept faces"], .scrubber input[type="range"]',
    );
    const label = () => document.querySelector('.readouts dd')?.textContent;
    const [low, high] = [Number(input.min), Number(input.max)];
    const times = [];
    for (let i = 1; i <= 20; i++) {
      const before = label();
      const start = performance.now();
      input.value = String(Math.round(high - ((high - low) * i) / 24));
      input.dispatchEvent(new Event('input', { bubbles: true }));
      while (label() === before && performance.now() - start < 5000)
        await new Promise((resolve) => setTimeout(resolve));
      times.push(performance.now() - start);
    }
    return times.sort((a, b) => a - b)[10];
  });

async function measureMesh(browser, address, count) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 } });
  const page = await context.newPage();
  await page.addInitScript(observe);
  await page.goto(address);
  await page.waitForFunction(() => globalThis.measured.usable !== null);
  await page.waitForTimeout(1000);
  await longestTask(page);
  const path = writeTorus(count);
  const name = `${count.toLocaleString('en')} faces`;
  const start = performance.now();
  await drop(page, path);
  await page.getByRole('navigation', { name: 'Steps' }).getByRole('button', { name: 'Reduce' }).click();
  const done = page.locator('.readouts > div').filter({ hasText: 'Deviation' }).filter({ hasText: /\d %/ });
  await done.waitFor({ timeout: 120_000 });
  add(
    `${name}: drop -> finished at 50 %`,
    `${((performance.now() - start) / 1000).toFixed(1)} s`,
    'command line + 20 %',
  );
  add(`${name}: longest task until then`, describeTask(await longestTask(page)), '50 ms');
  add(`${name}: slider -> label`, `${(await scrub(page)).toFixed(0)} ms`, '16 ms');
  await page.waitForTimeout(500);
  add(`${name}: longest task while scrubbed`, describeTask(await longestTask(page)), '50 ms');
  await context.close();
}

const server = await preview({ preview: { port: 4392, strictPort: true }, logLevel: 'silent' });
const address = 'http://localhost:4392/';
const flags = JSON.parse(readFileSync(join(root, 'tests', 'browser-arguments.json'), 'utf8'));
const browser = await chromium.launch({
  executablePath: findChromium(),
  args: [...flags, '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
try {
  await measureStart(browser, address);
  measureSizes();
  for (const count of faces.split(',').filter(Boolean).map(Number))
    await measureMesh(browser, address, count);
} finally {
  await browser.close();
  await server.close();
}
const width = Math.max(...rows.map(({ what }) => what.length));
for (const { what, value, target } of rows)
  console.log(`${what.padEnd(width)}  ${value.padEnd(32)} target ${target}`);
