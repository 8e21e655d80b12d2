import { readFileSync } from 'node:fs';
import { WebIO } from '@gltf-transform/core';
import { expect, test } from '@playwright/test';
import { validateBytes } from 'gltf-validator';
import { sheetObj } from './meshes';
import {
  commandLineBytes,
  drop,
  expectSolved,
  goTo,
  keepFaces,
  keptFaces,
  openPage,
  readout,
  saveGlb,
  writeScratch,
} from './page';
import { PLAIN } from '../../playwright.config';

const sheet = writeScratch('sheet.obj', sheetObj(24));

async function faceCount(bytes: Uint8Array): Promise<number> {
  const document = await new WebIO().readBinary(bytes);
  const primitives = document
    .getRoot()
    .listMeshes()
    .flatMap((mesh) => mesh.listPrimitives());
  return primitives.reduce((sum, primitive) => sum + primitive.getIndices()!.getCount() / 3, 0);
}

test('a mesh is dropped, a mode chosen, the slider moved both ways, and the saved file read back', async ({
  page,
}) => {
  await openPage(page);
  await drop(page, sheet);
  await expect(readout(page, 'Faces')).toContainText('1,152');
  await goTo(page, 'Motion');
  const second = page.getByRole('button', { name: /Mode 2/ });
  await second.click();
  await expect(second).toHaveAttribute('aria-pressed', 'true');
  await goTo(page, 'Reduce');
  await keepFaces(page, 300);
  await keepFaces(page, 900);
  await keepFaces(page, 500);
  await expect(readout(page, 'Topology')).toContainText('kept');
  const bytes = await saveGlb(page);
  const report = await validateBytes(bytes);
  expect(report.issues.numErrors).toBe(0);
  const faces = await faceCount(bytes);
  expect(faces).toBeLessThanOrEqual(500);
  expect(faces).toBeGreaterThan(497);
  expect(Buffer.from(bytes).equals(commandLineBytes(sheet, ['--faces', '500', '--mode', '2']))).toBe(true);
});

test('the command line that the page shows makes the same bytes, fields included', async ({ page }) => {
  await openPage(page);
  await drop(page, sheet);
  await expect(readout(page, 'Faces')).toContainText('1,152');
  await goTo(page, 'Reduce');
  await keepFaces(page, 400);
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  await page.getByLabel('Strain and curvature as attributes').check();
  const line = page.locator('code.command');
  await expect(line).toHaveText('limber optimize sheet.obj sheet-limber.glb --faces 400 --fields');
  const save = page.getByRole('button', { name: 'Save .glb' });
  await expect(save).toBeEnabled();
  await expect(page.getByText('No errors')).toBeVisible();
  await page.waitForTimeout(500);
  await expect(page.locator('.notice.busy')).toHaveCount(0);
  const [download] = await Promise.all([page.waitForEvent('download'), save.click()]);
  const saved = readFileSync(await download.path());
  expect(saved.equals(commandLineBytes(sheet, ['--faces', '400', '--fields']))).toBe(true);
});

test('a file that is not a mesh gets one sentence, and the model before it stays', async ({ page }) => {
  await openPage(page);
  await drop(page, writeScratch('letter.txt', 'Dear reader,\n'));
  await expect(page.getByRole('alert')).toContainText('letter.txt is not a mesh that can be read');
  await expect(readout(page, 'Faces')).toContainText('1,792');
  await drop(page, writeScratch('broken.obj', 'v 0 0 0\nv 1 0 0\nf 1 2 9\n'));
  await expect(page.getByRole('alert')).toContainText('broken.obj');
  await expect(readout(page, 'Faces')).toContainText('1,792');
  await drop(page, sheet);
  await expect(readout(page, 'Faces')).toContainText('1,152');
});

test('a file that is dropped during a computation is shown before its own computations start', async ({
  page,
}) => {
  // The modes of a copy would be available at once.
  await openPage(page, '/?sample=bar#exact=on');
  await drop(page, writeScratch('first.obj', sheetObj(280)));
  const busy = page.locator('.notice.busy');
  await expect(busy).toContainText('Finding modes');
  // Collects every frame from now on in which modes are computed before the facts of the new file are shown.
  await page.evaluate(() => {
    const seen: string[] = [];
    Object.assign(window, { seen });
    const look = (): void => {
      const facts = document.querySelector('.left')!.textContent;
      const notice = document.querySelector('.notice.busy')?.textContent ?? '';
      if (facts.includes('second.obj') && !facts.includes('Vertices') && notice.includes('modes'))
        seen.push(notice);
      requestAnimationFrame(look);
    };
    look();
  });
  await drop(page, writeScratch('second.obj', sheetObj(130)));
  await expect(page.locator('.left')).toContainText('33,800');
  await expect(busy).toContainText('Finding modes');
  expect(await page.evaluate(() => (window as unknown as { seen: string[] }).seen)).toEqual([]);
});

test('names from a file are text, never markup', async ({ page }) => {
  await openPage(page);
  await drop(
    page,
    writeScratch(
      'evil.obj',
      `o <img src=x onerror=document.title='owned'>\n${sheetObj(4)}o second\n${sheetObj(3)}`,
    ),
  );
  await expect(page.locator('.bodies')).toContainText('<img src=x');
  expect(await page.title()).toBe('Limber');
});

test('a long calculation shows progress, is cancelled, and runs again on request', async ({ page }) => {
  // The modes of a copy would be available at once.
  await page.goto('/#exact=on&file=large.obj');
  await drop(page, writeScratch('large.obj', sheetObj(140)));
  await expect(readout(page, 'Faces')).toContainText('39,200');
  await goTo(page, 'Motion');
  await page.getByRole('button', { name: 'Shell' }).click();
  const busy = page.locator('.notice.busy');
  await expect(busy).toContainText('Finding modes');
  await page.keyboard.press('Escape');
  await expect(page.getByText('Finding modes: stopped.')).toBeVisible();
  await page.getByRole('button', { name: 'Run again' }).click();
  await expectSolved(page, /6 rigid motions found, 6 expected/);
});

test('the main job works with the keyboard alone', async ({ page }) => {
  await openPage(page);
  const step = page.getByRole('navigation', { name: 'Steps' }).getByRole('button', { name: 'Reduce' });
  await step.focus();
  await page.keyboard.press('Enter');
  await expect(keptFaces(page)).toBeEnabled();
  await keptFaces(page).focus();
  const before = Number(await keptFaces(page).inputValue());
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('ArrowLeft');
  expect(Number(await keptFaces(page).inputValue())).toBe(before - 2);
  await page.keyboard.press('Control+e');
  await expect(page.getByRole('complementary', { name: 'Export' })).toBeVisible();
});

test(
  'without isolation headers the same job runs on one thread, and can be cancelled there too',
  { tag: '@full' },
  async ({ page }) => {
    await openPage(page, `${PLAIN}?sample=bar`);
    await expect(page.getByText('1 thread', { exact: true })).toBeVisible();
    await drop(page, sheet);
    await expect(readout(page, 'Faces')).toContainText('1,152');
    await goTo(page, 'Reduce');
    await keepFaces(page, 500);
    const bytes = await saveGlb(page);
    expect(Buffer.from(bytes).equals(commandLineBytes(sheet, ['--faces', '500']))).toBe(true);

    await page.goto(`${PLAIN}#exact=on&file=large.obj`);
    await drop(page, writeScratch('large.obj', sheetObj(140)));
    await expect(readout(page, 'Faces')).toContainText('39,200');
    await goTo(page, 'Motion');
    await page.getByRole('button', { name: 'Shell' }).click();
    await expect(page.locator('.notice.busy')).toContainText('Finding modes');
    await page.keyboard.press('Escape');
    await expect(page.getByText('Finding modes: stopped.')).toBeVisible();
    await page.getByRole('button', { name: 'Laplacian' }).click();
    await expectSolved(page, /3 rigid motions found, 3 expected/);
  },
);
