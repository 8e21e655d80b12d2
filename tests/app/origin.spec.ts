/** The page sends no request to other hosts, whatever the user does. */

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

test('no request leaves the origin with a queue, in any format of the export', async ({ page, context }) => {
  const asked = new Set<string>();
  context.on('request', (request) => asked.add(new URL(request.url()).origin));
  context.on('page', (other) => asked.add(`a window at ${other.url()}`));
  const button = (name: string) => page.getByRole('button', { name, exact: true });
  const save = (name: string) => Promise.all([page.waitForEvent('download'), button(name).click()]);
  await page.goto('/');
  await drop(page, ...[8, 10].map((size, i) => writeScratch(`queued-${i}.obj`, sheetObj(size))));
  await button('Optimize all 2').click();
  await expect(page.locator('.queue')).toContainText('2 done');
  await save('Save the queue as .zip');
  await button('Close the queue').click();
  await goTo(page, 'Reduce');
  await button('Export').click();
  for (const [format, ending] of [
    ['ply', '.ply'],
    ['obj.zip', '.obj.zip'],
    ['gltf.zip', '.gltf.zip'],
  ]) {
    await page.getByLabel('Format').selectOption(format);
    await expect(button(`Save ${ending}`)).toBeEnabled();
    await save(`Save ${ending}`);
  }
  await page.getByLabel('Format').selectOption('auto');
  for (const compression of ['meshopt', 'draco']) {
    await page.getByLabel('Compression').selectOption(compression);
    await expect(page.locator('code.command')).toContainText(`--compress ${compression}`);
    await expect(button('Save .glb')).toBeEnabled();
    await save('Save .glb');
  }
  expect(asked.size).toBeGreaterThan(0);
  expect([...asked].filter((origin) => origin !== new URL(page.url()).origin && origin !== 'null')).toEqual(
    [],
  );
});
