/** A core that may not grow: requests that need more memory are refused in one sentence, and the page keeps working. */

import { expect, test } from '@playwright/test';
import { addMesh, glbFile, primitiveOf, startDocument } from '../engine/support/gltf';
import { grid } from '../engine/support/shapes';
import { sheetObj } from './meshes';
import { drop, goTo, keepFaces, keptFaces, openPage, readout, writeScratch } from './page';

test('a model that needs more memory than there is gets a sentence, and what is open stays', async ({
  page,
}) => {
  const document = startDocument();
  addMesh(document, 'million', [primitiveOf(document, grid(708, 708))]);
  const million = writeScratch('million.glb', (await glbFile(document)).bytes);
  await openPage(page, '/?sample=bar&memory=512M');
  const started = Date.now();
  await drop(page, million);
  await expect(page.getByRole('alert')).toContainText(
    /million has 1,002,528 faces, for which the core needs about .* GB of memory, but it may use only 0\.5 GB/,
  );
  test.info().annotations.push({
    type: 'seconds to the sentence',
    description: String((Date.now() - started) / 1000),
  });
  await expect(readout(page, 'Faces')).toContainText('1,792');
  await drop(page, writeScratch('sheet.obj', sheetObj(16)));
  await goTo(page, 'Reduce');
  await expect(keptFaces(page)).toBeEnabled();
  await keepFaces(page, 200);
  await expect(readout(page, 'Deviation')).toContainText('%');
});

test('a size of memory that is none gets a sentence', async ({ page }) => {
  await page.goto('/?memory=much');
  await drop(page, writeScratch('sheet.obj', sheetObj(16)));
  await expect(page.getByRole('alert')).toContainText('?memory= is much: give a size such as 512M or 2G.');
});
