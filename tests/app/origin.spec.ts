/** The page asks no other host for anything, whatever is done with it. */

import { expect, test } from '@playwright/test';
import { sheetObj } from './meshes';
import { drop, goTo, openPage, readout, saveGlb, writeScratch } from './page';

test('no request of page and workers leaves the origin in any step', async ({ page, context }) => {
  const asked = new Set<string>();
  context.on('request', (request) => asked.add(new URL(request.url()).origin));
  // Pictures, styles and addresses of a file are text to the page.
  const hostile = writeScratch(
    'hostile.gltf',
    JSON.stringify({
      asset: { version: '2.0', generator: '<img src="http://example.com/a.png">' },
      images: [{ uri: 'http://example.com/b.png' }],
      buffers: [{ uri: 'http://example.com/c.bin', byteLength: 4 }],
      meshes: [{ name: 'url(http://example.com/d.png)', primitives: [{ attributes: {} }] }],
      nodes: [{ mesh: 0 }],
    }),
  );
  await openPage(page);
  await drop(page, hostile);
  await expect(page.getByRole('alert')).toContainText('hostile.gltf');
  await drop(page, writeScratch('own.obj', sheetObj(12)));
  await expect(page.locator('.filename').first()).toHaveText('own.obj');
  await goTo(page, 'Motion');
  await expect(page.getByRole('list', { name: 'Modes' })).toContainText('Hz');
  await goTo(page, 'Reduce');
  await expect(readout(page, 'Deviation')).not.toContainText('...');
  await goTo(page, 'Test');
  await expect(readout(page, 'Speed-up')).toContainText(/^x\d/);
  await saveGlb(page);
  await page.getByRole('button', { name: 'Help' }).click();
  await page.locator('.help').getByRole('button', { name: '日本語' }).click();
  await expect(page.locator('html')).toHaveAttribute('lang', 'ja');
  expect([...asked].filter((origin) => origin !== new URL(page.url()).origin && origin !== 'null')).toEqual(
    [],
  );
});
