/**
 * A worker may end at any moment: the page survives, the model is restored, and the next action gives the right result.
 * LIMBER_KILLS=100 ends that many, LIMBER_SEED chooses the moments.
 */

import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import { sheetObj } from './meshes';
import { drop, goTo, keepFaces, keptFaces, openPage, readout, uncaughtErrors, writeScratch } from './page';
import { seeded } from './random_actions';
import { followWorkers, killWorker, settle } from './workers';

const KILLS = Number(process.env.LIMBER_KILLS ?? 5);
const SEED = Number(process.env.LIMBER_SEED ?? 1);
/** ms after the beginning of an action within which the worker ends. */
const LATEST = 1500;
const FACES = 700;
const sheet = writeScratch('killed.obj', sheetObj(40));

/** Actions that keep the worker busy; none leaves settings behind that a later one does not set. */
const ACTIONS: ((page: Page, part: number) => Promise<void>)[] = [
  (page, part) => keptFaces(page).fill(String(Math.round(200 + 2000 * part))),
  (page, part) => page.getByLabel('Even triangles, exact').fill((0.1 * part).toFixed(3)),
  (page) => drop(page, sheet),
  (page) => page.keyboard.press('Control+e'),
];

/** Returns the page to the same settings, as a user would, and returns its text on the result. */
async function deviationAt(page: Page, evenness: string): Promise<string> {
  const again = page.getByRole('button', { name: 'Run again' });
  const opened = page.getByRole('button', { name: 'Export', exact: true, expanded: true });
  await expect(async () => {
    if (await again.isVisible()) await again.click({ timeout: 1000 });
    if (await opened.isVisible()) await opened.click({ timeout: 1000 });
    await goTo(page, 'Reduce');
    await expect(keptFaces(page)).toBeEnabled({ timeout: 5000 });
    await page.getByLabel('Even triangles, exact').fill(evenness, { timeout: 1000 });
    await page.getByLabel('Even triangles, exact').press('Enter', { timeout: 1000 });
  }).toPass({ timeout: 60_000 });
  await settle(page);
  await keepFaces(page, FACES);
  await expect(async () => {
    // The lost work may only be offered again now.
    if (await again.isVisible()) await again.click({ timeout: 1000 });
    await expect(readout(page, 'Deviation')).toContainText('%', { timeout: 2000 });
  }).toPass({ timeout: 60_000 });
  return readout(page, 'Deviation').innerText();
}

test('a worker that ends at random moments loses nothing', async ({ page }) => {
  test.setTimeout(60_000 + 30_000 * KILLS);
  const errors = uncaughtErrors(page);
  page.on('crash', () => errors.push('the page has crashed'));
  await followWorkers(page);
  await openPage(page);
  await drop(page, sheet);
  await expect(page.locator('.filename')).toHaveText('killed.obj');
  await goTo(page, 'Reduce');
  await expect(keptFaces(page)).toBeEnabled();
  const evenness = await page.getByLabel('Even triangles, exact').inputValue();
  const expected = await deviationAt(page, evenness);
  const random = seeded(SEED);
  for (let kill = 1; kill <= KILLS; kill++) {
    const action = Math.floor(random() * ACTIONS.length);
    await ACTIONS[action](page, random());
    await page.waitForTimeout(LATEST * random());
    await killWorker(page);
    expect(await deviationAt(page, evenness), `after kill ${kill}, action ${action}`).toBe(expected);
    await expect(page.locator('.filename')).toHaveText('killed.obj');
    expect(errors).toEqual([]);
  }
});
