// Measures the built page against its targets and prints one table.
// Usage: node tests/bench/page.mjs [--only start,finish,scene,scrub] [--faces 7000,16000,100000] [--write]
//   start   sizes, first paint, usable          finish   drop -> finished at 50 %, beside the command line
//   scene   drop of 29 bodies -> all finished     scrub    slider -> label and picture
// After npm run build; needs Chromium.
//
// Chromium draws in software here. Tasks are measured by the time in which their thread computes, which leaves out waits for the
// rasteriser; the times of the slider are without calls of WebGL other than uploads.

import { execFileSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { brotliCompressSync } from 'node:zlib';
import { root } from '../../scripts/setup/environment.mjs';
import { drop, goTo, openWatched, withBrowser } from './page/browser.mjs';
import { scratchPath, writeScene, writeTorus } from './page/meshes.mjs';
import { drawNothing, forget, scrub } from './page/observe.mjs';
import { longestTask } from './page/tasks.mjs';
import { table, writeSection } from './section.mjs';

const { only, faces, write } = parseArgs({
  options: {
    only: { type: 'string', default: 'start,finish,scene,scrub' },
    faces: { type: 'string', default: '' },
    write: { type: 'boolean', default: false },
  },
}).values;
const parts = new Set(only.split(','));
const counts = (usual) => (faces === '' ? usual : faces.split(',').map(Number));
const rows = [];
function add(what, value, target) {
  rows.push([what, value, target]);
  console.log(`${what}: ${value} (target ${target})`);
}

const describeTask = ({ own, lasted, over }) =>
  `${own.toFixed(0)} ms, ${over} over 50 ms; with waits ${lasted.toFixed(0)} ms`;
const median = (values) => values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];
const milliseconds = (value) => `${value.toFixed(value < 10 ? 1 : 0)} ms`;
const nameOf = (count) => `${count.toLocaleString('en')} faces`;

async function measureStart(browser) {
  const starts = [];
  for (let round = 0; round < 3; round++) {
    const page = await openWatched(browser);
    const paint = await page.evaluate(
      () => performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? NaN,
    );
    starts.push({ paint, usable: await page.evaluate(() => globalThis.measured.usable) });
    await page.context().close();
  }
  add('first paint, cold', milliseconds(median(starts.map(({ paint }) => paint))), '800 ms');
  add('usable, cold', milliseconds(median(starts.map(({ usable }) => usable))), '1,400 ms');
}

function measureSizes() {
  const folder = join(root, 'dist', 'app');
  const assets = readdirSync(join(folder, 'assets')).map((name) => `assets/${name}`);
  const index = readFileSync(join(folder, 'index.html'), 'utf8');
  const first = ['index.html', ...assets.filter((name) => index.includes(name))];
  const [version] = readdirSync(join(folder, 'wasm'));
  const core = ['limber-threads.wasm', 'limber-threads.js'].map((name) => `wasm/${version}/${name}`);
  const size = (names) =>
    names.reduce((sum, name) => sum + brotliCompressSync(readFileSync(join(folder, name))).length, 0);
  add('page, compressed', `${(size(first) / 1000).toFixed(0)} kB`, '300 kB');
  add('core, compressed', `${(size(core) / 1000).toFixed(0)} kB`, '520 kB');
}

/** Seconds of `limber optimize` at its defaults, with its start. */
function commandLineSeconds(path) {
  const program = join(root, 'dist', 'cli', 'limber.mjs');
  const begin = performance.now();
  execFileSync(process.execPath, [
    program,
    'optimize',
    path,
    scratchPath('out.glb'),
    '--ratio',
    '0.5',
    '--quiet',
  ]);
  return (performance.now() - begin) / 1000;
}

/** Drops a mesh and waits on the step Reduce until its result has been measured. */
async function finish(page, path) {
  await drop(page, path);
  await goTo(page, 'Reduce');
  const done = page.locator('.readouts > div').filter({ hasText: 'Deviation' }).filter({ hasText: /\d %/ });
  await done.waitFor({ timeout: 150_000 });
}

const FINISH_ROUNDS = 3;
/** ms in which nobody has found a file yet: the page compiles its engine meanwhile. */
const BEFORE_DROP = 3000;

/** Seconds from the drop of a file to its measured result in a fresh page. */
async function pageSeconds(browser, path, isDrawn) {
  const page = await openWatched(browser);
  if (!isDrawn) await page.evaluate(drawNothing);
  await page.waitForTimeout(BEFORE_DROP);
  const start = performance.now();
  await finish(page, path);
  const seconds = (performance.now() - start) / 1000;
  await page.context().close();
  return seconds;
}

/** The command line, the page, and the page without the work of the rasteriser, in turn. */
async function measureFinish(browser, count) {
  const path = writeTorus(count);
  const [commandLine, drawn, plain] = [[], [], []];
  for (let round = 0; round < FINISH_ROUNDS; round++) {
    commandLine.push(commandLineSeconds(path));
    drawn.push(await pageSeconds(browser, path, true));
    plain.push(await pageSeconds(browser, path, false));
  }
  const least = Math.min(...commandLine);
  const target = `${(1.2 * least).toFixed(1)} s: command line ${least.toFixed(1)} s + 20 %`;
  const told = `${Math.min(...drawn).toFixed(1)} s; without drawing ${Math.min(...plain).toFixed(1)} s`;
  add(`${nameOf(count)}: drop -> finished at 50 %`, told, target);
}

const SCENE_BODIES = 29;
/** Nothing runs for so long once all is finished, ms. */
const QUIET = 1000;

/** Drops a scene and waits until its shown body has been measured and no body is worked on any more. */
async function measureScene(browser) {
  const path = writeScene(SCENE_BODIES);
  const page = await openWatched(browser);
  await page.waitForTimeout(1000);
  const start = performance.now();
  await finish(page, path);
  const shown = (performance.now() - start) / 1000;
  const quiet = (milliseconds) =>
    new Promise((resolve) => {
      let since = performance.now();
      const look = () => {
        const now = performance.now();
        if (document.querySelector('.notice.busy')) since = now;
        if (now - since < milliseconds) requestAnimationFrame(look);
        else resolve();
      };
      look();
    });
  await page.evaluate(quiet, QUIET);
  const seconds = (performance.now() - start - QUIET) / 1000;
  const faces = await page.locator('.readouts dd').first().innerText();
  console.log(`  (${faces.replaceAll(/\s+/g, ' ')})`);
  add(`${SCENE_BODIES} bodies: drop -> shown body finished at 50 %`, `${shown.toFixed(1)} s`, '20 s');
  add(`${SCENE_BODIES} bodies: drop -> all finished`, `${seconds.toFixed(1)} s`, '20 s');
  await page.context().close();
}

async function measureScrub(browser, count) {
  const page = await openWatched(browser);
  await page.waitForTimeout(1000);
  const path = writeTorus(count);
  const loading = await longestTask(browser, page, async () => {
    await drop(page, path);
    await goTo(page, 'Reduce');
    await page.locator('#faces:not([disabled])').waitFor({ timeout: 150_000 });
    await page.locator('.readouts dd').filter({ hasText: '→' }).first().waitFor({ timeout: 150_000 });
  });
  add(`${nameOf(count)}: longest task while loaded`, describeTask(loading), '50 ms');
  await forget(page);
  let ticks = [];
  const scrubbing = await longestTask(browser, page, async () => {
    ticks = await scrub(page);
    await page.waitForTimeout(500);
  });
  const target = count <= 200_000 ? '16 ms' : '60 ms';
  for (const what of ['label', 'picture', 'uploads']) {
    const times = ticks.map((tick) => tick[what]);
    const most = milliseconds(Math.max(...times));
    add(
      `${nameOf(count)}: slider -> ${what}${what === 'uploads' ? ', with waits for the rasteriser' : ''}`,
      `${milliseconds(median(times))}, at most ${most}`,
      target,
    );
  }
  add(`${nameOf(count)}: longest task while scrubbed`, describeTask(scrubbing), '50 ms');
  await page.context().close();
}

await withBrowser(async (browser) => {
  if (parts.has('start')) {
    measureSizes();
    await measureStart(browser);
  }
  if (parts.has('finish'))
    for (const count of counts([7000, 16_000, 100_000])) await measureFinish(browser, count);
  if (parts.has('scene')) await measureScene(browser);
  if (parts.has('scrub'))
    for (const count of counts([16_000, 100_000, 200_000, 1_000_000])) await measureScrub(browser, count);
});
const header = ['what', 'measured', 'target'];
if (write)
  await writeSection({
    name: 'page',
    title: 'Page',
    remark:
      'Chromium draws in software. For tasks, the first number is the computing time of the main thread without waits for the rasteriser, the second includes them. The slider moves while the result is still being fitted; the median and the maximum of 12 moves each are shown, until the label shows the new number, and until the picture has been prepared (without the wait for a frame). Uploads wait for the rasteriser and are shown separately. Drop to finished: the minimum of three runs, alternating with the command line, starting three seconds after the page is usable, in which it compiles its engine; repeated with empty draw calls, so that the rasteriser has no work.',
    missing: [],
    sections: [table(header, rows)],
  });
