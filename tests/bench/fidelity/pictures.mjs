// Draws the results of the methods at 25 % side by side with headless Chromium.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { bundle } from '../../../scripts/setup/bundle.mjs';
import { findChromium } from '../../../scripts/setup/environment.mjs';
import { imageFolder, scratch } from './load_engine.mjs';

const RATIO = 0.25;
const COLUMNS = 4;
const WIDTH = 300;

/** `view` points from the body to the eye, +Y up; `height` is that of a panel in pixels, chosen per body. */
export const PICTURES = [
  { mesh: 'bar', view: [1, 0.6, 1.2], height: 300 },
  { mesh: 'hanging cloth', view: [0.3, 0.25, 1], height: 290 },
  { mesh: 'spot', view: [-0.9, 0.3, -0.9], height: 290 },
  { mesh: 'eiffel', view: [0.5, 0.25, 1], height: 420 },
  { mesh: 'skirt', view: [0.4, 0.9, 1], height: 220 },
];
const METHODS = [
  ...['limber', 'paper', 'qem'],
  ...['meshoptimizer', 'meshoptimizer update', 'pymeshlab', 'fast-simplification'],
];

export const fileOf = (mesh) => `${mesh.replaceAll(' ', '-')}.png`;

const flat = ({ positions, triangles }) => ({ positions: [...positions], triangles: [...triangles] });

function panelsOf(cases, { name, faces, prepared }) {
  const original = { title: 'original', note: `${faces} faces`, ...flat(prepared.mesh) };
  const own = (method) =>
    cases.find((one) => one.mesh === name && one.method === method && one.ratio === RATIO);
  const panels = METHODS.map(own)
    .filter((one) => one !== undefined)
    .map(({ method, faces: left, frequencyErrorMean, meshOf }) => ({
      title: method,
      note: `${left} faces, frequencies ${frequencyErrorMean?.toFixed(1) ?? '?'} % off`,
      ...flat(meshOf()),
    }));
  return [original, ...panels];
}

async function buildPage() {
  const outDir = join(scratch, 'picture');
  await bundle({
    outDir,
    lib: {
      entry: 'tests/bench/fidelity/picture_page.ts',
      formats: ['iife'],
      name: 'pictures',
      fileName: () => 'picture_page.js',
    },
  });
  return join(outDir, 'picture_page.js');
}

/** Writes docs/images/simplification/MESH.png; without Chromium it writes none and adds to `missing`. */
export async function writePictures(cases, meshes, missing) {
  const pictures = PICTURES.flatMap(({ mesh: name, view, height }) => {
    const mesh = meshes.find((one) => one.name === name);
    if (!mesh) return [];
    const panels = panelsOf(cases, mesh);
    return [{ file: fileOf(name), picture: { panels, view, columns: COLUMNS, width: WIDTH, height } }];
  });
  await drawPictures(pictures, imageFolder, missing);
}

/** Writes each { file, picture } (see picture_page.ts) to the folder; without Chromium, none, and adds to `missing`. */
export async function drawPictures(pictures, folder, missing) {
  const executablePath = findChromium();
  if (!executablePath) {
    missing.push('Chromium, for the pictures (install one or set CHROMIUM)');
    return;
  }
  mkdirSync(folder, { recursive: true });
  const path = await buildPage();
  const browser = await chromium.launch({
    executablePath,
    args: ['--no-sandbox', '--enable-unsafe-swiftshader'],
  });
  try {
    for (const { file, picture } of pictures) {
      const viewport = { width: picture.columns * picture.width, height: 100 };
      const page = await browser.newPage({ viewport });
      await page.addScriptTag({ path });
      await page.evaluate((drawn) => globalThis.draw(drawn), picture);
      await page.waitForFunction(() => [...document.images].every((image) => image.complete));
      await page.locator('body').screenshot({ path: join(folder, file) });
      await page.close();
      console.log(`wrote ${file}`);
    }
  } finally {
    await browser.close();
  }
}
