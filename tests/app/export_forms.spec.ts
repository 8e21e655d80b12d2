/** Formats, levels and presets of the export, as chosen by a user. */

import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import { unzipSync } from 'fflate';
import { sheetObj } from './meshes';
import { drop, goTo, keepFaces, keptFaces, scratch, writeScratch } from './page';

const sheet = writeScratch('sheet-forms.obj', sheetObj(16));
const button = (page: Page, name: string) => page.getByRole('button', { name, exact: true });

async function openExport(page: Page): Promise<void> {
  await page.goto('/');
  await drop(page, sheet);
  await expect(page.locator('.filename').first()).toHaveText('sheet-forms.obj');
  await goTo(page, 'Reduce');
  await expect(keptFaces(page)).toBeEnabled();
  await keepFaces(page, 200);
  await button(page, 'Export').click();
}

async function saved(page: Page, name: string): Promise<Buffer> {
  await expect(button(page, name)).toBeEnabled();
  const [download] = await Promise.all([page.waitForEvent('download'), button(page, name).click()]);
  return readFileSync(await download.path());
}

/** The file `name` as written by the command that the page shows. */
async function writtenByCommand(page: Page, name: string): Promise<Buffer> {
  const command = await page.locator('code.command').innerText();
  const words = command.replaceAll("'", '').split(' ').slice(1);
  const program = join(import.meta.dirname, '..', '..', 'dist', 'cli', 'limber.mjs');
  execFileSync(process.execPath, [program, ...words, '--quiet', '--force'], { cwd: scratch, stdio: 'pipe' });
  return readFileSync(join(scratch, name));
}

test('every format and compression is saved as the command line writes it', async ({ page }) => {
  await openExport(page);
  for (const [format, ending] of [
    ['ply', '.ply'],
    ['obj.zip', '.obj.zip'],
    ['gltf.zip', '.gltf.zip'],
  ]) {
    await page.getByLabel('Format').selectOption(format);
    const bytes = await saved(page, `Save ${ending}`);
    const name = `sheet-forms-limber${ending}`;
    expect((await writtenByCommand(page, name)).equals(bytes), name).toBe(true);
  }
  await page.getByLabel('Format').selectOption('auto');
  for (const compression of ['none', 'quantized', 'meshopt', 'draco']) {
    await page.getByLabel('Compression').selectOption(compression);
    await expect(page.locator('code.command')).toContainText(`--compress ${compression}`);
    const bytes = await saved(page, 'Save .glb');
    const written = await writtenByCommand(page, 'sheet-forms-limber.glb');
    expect(written.equals(bytes), compression).toBe(true);
    const size = page.locator('.facts > div').filter({ hasText: 'File size' });
    await expect(size).toContainText(`→ ${Math.round(bytes.length / 1000)}\u00a0kB`);
  }
  await page.getByLabel('Format').selectOption('ply');
  await expect(page.getByText('it reads only GLB and glTF')).toBeVisible();
  await expect(page.getByLabel('Compression')).toHaveCount(0);
});

test('the button that saves is in view as soon as the panel is open, also on a phone', async ({ page }) => {
  await openExport(page);
  await expect(button(page, 'Save .glb')).toBeInViewport({ ratio: 1 });
  await page.setViewportSize({ width: 390, height: 844 });
  await button(page, 'Close the export panel').click();
  await button(page, 'Export').click();
  await expect(button(page, 'Save .glb')).toBeInViewport({ ratio: 1 });
});

test('the result can be dragged out of the page', async ({ page }) => {
  await openExport(page);
  await expect(page.locator('.drag-out')).toHaveAttribute('draggable', 'true');
  const text = await page.evaluate(() => {
    const dataTransfer = new DataTransfer();
    const event = new DragEvent('dragstart', { dataTransfer, bubbles: true });
    document.querySelector('.drag-out')!.dispatchEvent(event);
    return dataTransfer.getData('DownloadURL');
  });
  const [, type, name, address] = /^([^:]+):([^:]+):(blob:.*)$/.exec(text)!;
  expect([type, name]).toEqual(['model/gltf-binary', 'sheet-forms-limber.glb']);
  const dragged = await page.evaluate(
    async (from) => Array.from(new Uint8Array(await (await fetch(from)).arrayBuffer())),
    address,
  );
  expect(Buffer.from(dragged).equals(await saved(page, 'Save .glb'))).toBe(true);
});

test('levels are added, seen where they change, and written as nodes of one file', async ({ page }) => {
  await openExport(page);
  await button(page, 'Add a level').click();
  await button(page, 'Add a level').click();
  await expect(page.getByLabel('Further levels')).toHaveValue('0.2, 0.1');
  // A last level that this sheet reaches within the guard of 1 %.
  await page.getByLabel('Further levels').fill('0.3, 0.15');
  await page.getByLabel('Further levels').press('Enter');
  await expect(page.getByLabel('Further levels')).toHaveValue('0.3, 0.15');
  await page.getByLabel('Further levels').fill('30 %, 500000');
  await page.getByLabel('Further levels').press('Enter');
  await expect(page.getByRole('alert')).toContainText('“500000” is not a level');
  await page.getByLabel('Further levels').fill('30 %, 0.15');
  await page.getByLabel('Further levels').press('Enter');
  await expect(page.getByRole('alert').filter({ hasText: 'is not a level' })).toHaveCount(0);
  await expect(page.getByLabel('Further levels')).toHaveValue('30 %, 0.15');
  await expect(button(page, 'Save all as .zip')).toBeEnabled();
  await expect(page.getByText('a further level has')).toHaveCount(0);
  await page.getByLabel('Further levels').fill('70 %, 0.15');
  await page.getByLabel('Further levels').press('Enter');
  await expect(
    page.getByText(/_lod1.glb: a further level has \d+ faces, more than the \d+ of the result: /),
  ).toBeVisible();
  await page.getByLabel('Further levels').fill('30 %, 0.15');
  await page.getByLabel('Further levels').press('Enter');
  await page.getByLabel('Levels go into').selectOption('nodes');
  await page.getByLabel('See where they change').check();
  const rows = page.getByRole('list', { name: 'Where levels change' }).getByRole('listitem');
  await expect(rows).toHaveCount(3);
  await rows.nth(2).getByRole('button').click();
  await expect(page.locator('.level-preview figcaption')).toContainText('LOD2');
  await page.getByLabel('Distance').fill('0');
  await expect(page.locator('.level-preview figcaption')).toContainText('LOD0');
  const glb = await saved(page, 'Save .glb');
  const json = glb.subarray(20, 20 + glb.readUInt32LE(12)).toString();
  for (const level of [0, 1, 2]) expect(json).toContain(`_LOD${level}"`);
  expect((await writtenByCommand(page, 'sheet-forms-limber.glb')).equals(glb)).toBe(true);
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
});

test('a preset says what it changes before it does', async ({ page }) => {
  await openExport(page);
  await page.getByLabel('Preset').selectOption('mobile');
  await expect(page.locator('.changes li')).toHaveText([
    'Compression: as in the file → quantized',
    'Further levels: none → 0.25, 0.1',
  ]);
  await page.getByLabel('Preset').selectOption('cloth');
  await expect(page.locator('.changes li')).toHaveText([
    'Model: Auto → Shell',
    "Solver: Limber's solid → Limber's shell",
    'Fix open borders: off → on',
    'Fit: To the surface → To the modes of the shell',
  ]);
  await page.getByLabel('Preset').selectOption('mobile');
  await expect(page.getByLabel('Further levels')).toHaveValue('');
  await button(page, 'Use these settings').click();
  await expect(page.getByText('All of these are set.')).toBeVisible();
  await expect(page.getByLabel('Further levels')).toHaveValue('0.25, 0.1');
  const archive = unzipSync(await saved(page, 'Save all as .zip'));
  expect(Object.keys(archive)).toContain('sheet-forms-limber_lod2.glb');
});
