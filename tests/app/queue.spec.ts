/** Several models at once, and settings files brought back. */

import { readFileSync } from 'node:fs';
import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import { strToU8, unzipSync, zipSync } from 'fflate';
import { sheetObj } from './meshes';
import { drop, goTo, keepFaces, keptFaces, readout, writeScratch } from './page';
import { standingTubes } from './scenes';

const button = (page: Page, name: string) => page.getByRole('button', { name, exact: true });
const models = [16, 18, 20].map((size, i) => writeScratch(`model-${i}.obj`, sheetObj(size)));
const damaged = writeScratch('model-9.stl', 'solid nothing\nfacet');
const queue = (page: Page) => page.locator('.queue');

async function save(page: Page, name: string): Promise<Buffer> {
  const [download] = await Promise.all([page.waitForEvent('download'), button(page, name).click()]);
  return readFileSync(await download.path());
}

test('several files are a queue with one setting, in which a bad one fails alone', async ({ page }) => {
  await page.goto('/');
  await drop(page, ...models, damaged);
  await expect(queue(page)).toContainText('4 models');
  await expect(queue(page).locator('.hint')).toHaveText(/as GLB\.$/);
  await expect(page.locator('.left .filename')).toHaveText('model-0.obj');
  await expect(button(page, 'Optimize all 4')).toBeEnabled();
  await goTo(page, 'Reduce');
  await expect(keptFaces(page)).toBeEnabled();
  await keepFaces(page, 200);
  await button(page, 'Optimize all 4').click();
  await expect(queue(page)).toContainText('3 done and 1 failed');
  await expect(queue(page).locator('li.failed')).toContainText('model-9.stl');
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  const files = unzipSync(await save(page, 'Save the queue as .zip'));
  expect(Object.keys(files).sort()).toEqual([
    'model-0-limber.glb',
    'model-1-limber.glb',
    'model-2-limber.glb',
    'summary.csv',
  ]);
  const lines = new TextDecoder().decode(files['summary.csv']).trim().split('\r\n');
  expect(lines).toHaveLength(5);
  expect(lines[4]).toMatch(/^model-9\.stl,failed,,,,,,,/);
  const share = 200 / Number(lines[1].split(',')[3]);
  for (const line of lines.slice(1, 4)) {
    const [before, after] = line.split(',').slice(3, 5).map(Number);
    expect(after).toBeLessThanOrEqual(Math.ceil(share * before));
    expect(after).toBeGreaterThan(0);
  }
});

test('of a queue whose first model is broken the next is opened, and the error is told', async ({ page }) => {
  await page.goto('/');
  await drop(page, writeScratch('a-broken.stl', 'solid nothing\nfacet'), ...models);
  await expect(page.locator('.left .filename')).toHaveText('model-0.obj');
  await expect(page.locator('.notice')).toContainText('a-broken.stl');
  await expect(queue(page).locator('li.failed')).toContainText('a-broken.stl');
  await expect(queue(page)).toContainText('1 failed and 3 not started');
});

test('a queue names the settings that are not the default', async ({ page }) => {
  await page.goto('/#compress=draco&seams=cross&max-deviation=0');
  await drop(page, ...models);
  await expect(queue(page).locator('.hint')).toHaveText(
    /as GLB; .*Largest deviation: off.*Collapse across texture seams: on.*Compression: Draco.*\.$/,
  );
});

test(
  'a ZIP of several models is a queue, which can be cancelled and closed',
  { tag: '@full' },
  async ({ page }) => {
    const entries = { 'a/sheet.obj': strToU8(sheetObj(40)), 'b/sheet.obj': strToU8(sheetObj(48)) };
    const archive = writeScratch('two.zip', zipSync(entries));
    await page.goto('/');
    await drop(page, archive);
    await expect(queue(page)).toContainText('2 models');
    await button(page, 'Optimize all 2').click();
    await expect(queue(page)).toContainText('1 of 2');
    await button(page, 'Cancel the queue').click();
    await expect(button(page, 'Optimize all 2')).toBeEnabled();
    await queue(page).getByRole('button', { name: 'b/sheet.obj' }).click();
    await expect(readout(page, 'Faces')).toContainText(String((2 * 48 * 48).toLocaleString('en-US')));
    await button(page, 'Close the queue').click();
    await expect(queue(page)).toHaveCount(0);
  },
);

test('a queue comes back after a reload, unless it was closed', async ({ page }) => {
  await page.goto('/');
  await drop(page, ...models);
  await expect(queue(page)).toContainText('3 models');
  await queue(page).getByRole('button', { name: 'model-1.obj' }).click();
  await expect(page.locator('.left .filename')).toHaveText('model-1.obj');
  await expect(button(page, 'Optimize all 3')).toBeEnabled();
  for (let reloads = 0; reloads < 2; ++reloads) {
    await page.reload();
    await expect(page.locator('.left .filename')).toHaveText('model-1.obj');
    await expect(queue(page)).toContainText('3 models');
    await expect(button(page, 'Optimize all 3')).toBeEnabled();
  }
  await button(page, 'Close the queue').click();
  await page.reload();
  await expect(page.locator('.left .filename')).toHaveText('model-1.obj');
  await expect(queue(page)).toHaveCount(0);
});

test('a settings file brings its solver, parameters and faces back, or says what is wrong', async ({
  page,
}) => {
  await page.goto('/');
  await drop(page, models[2]);
  await goTo(page, 'Reduce');
  await expect(keptFaces(page)).toBeEnabled();
  await keepFaces(page, 300);
  await button(page, 'Export').click();
  await page.getByLabel('Solver').selectOption('hinge-shell');
  await expect(button(page, 'Save settings')).toBeEnabled();
  const text = (await save(page, 'Save settings')).toString();
  const written = writeScratch('model-2.settings.json', text);
  await page.getByLabel('Solver').selectOption('none');
  await keepFaces(page, 400);
  await drop(page, written);
  const faces = (JSON.parse(text) as { bodies: { mesh: { triangles: number[] } }[] }).bodies[0].mesh
    .triangles;
  await expect(page.getByRole('status').filter({ hasText: 'model-2.settings.json' })).toContainText(
    `Discrete Shells with its parameters, ${faces.length / 3} faces.`,
  );
  await expect(page.getByLabel('Solver').first()).toHaveValue('hinge-shell');
  await expect(page.getByRole('button', { name: 'Tuned', exact: true })).toHaveAttribute(
    'aria-pressed',
    'true',
  );
  await goTo(page, 'Reduce');
  await expect(keptFaces(page)).toHaveValue(String(faces.length / 3));
  await drop(page, writeScratch('broken.json', text.replace('"hinge-shell"', '"havok"')));
  await expect(page.getByRole('alert')).toContainText('broken.json is for "havok", which is not one of');
});

test('of a settings file of several bodies the shown one takes its own unit and faces, wherever it is', async ({
  page,
}) => {
  await page.goto('/');
  await drop(page, writeScratch('tubes.glb', await standingTubes()));
  await goTo(page, 'Reduce');
  await expect(keptFaces(page)).toBeEnabled();
  await keptFaces(page).fill('600');
  await keptFaces(page).press('Enter');
  await button(page, 'Export').click();
  await page.getByLabel('Solver').selectOption('springs');
  await expect(button(page, 'Save settings')).toBeEnabled();
  const file = JSON.parse((await save(page, 'Save settings')).toString()) as {
    units: { length: number };
    bodies: { name: string; unit: number; mesh: { triangles: number[] } }[];
  };
  const [red, blue] = file.bodies;
  expect([red.name, blue.name]).toEqual(['red', 'blue']);
  file.bodies = [{ ...blue, unit: 0.01 }, red];
  file.units.length = 0.01;
  await page.getByLabel('Solver').selectOption('none');
  await keptFaces(page).fill('900');
  await keptFaces(page).press('Enter');
  await drop(page, writeScratch('tubes.settings.json', JSON.stringify(file)));
  const faces = (red.mesh.triangles.length + blue.mesh.triangles.length) / 3;
  await expect(page.getByRole('status').filter({ hasText: 'tubes.settings.json' })).toContainText(
    `Springs with its parameters, ${faces} faces.`,
  );
  await goTo(page, 'Reduce');
  await expect(keptFaces(page)).toHaveValue(String(faces));
  await button(page, 'Export').click();
  await expect(page.locator('code.command')).toContainText('--solver springs');
  await expect(page.locator('code.command')).not.toContainText('--unit');
});
