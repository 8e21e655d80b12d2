/**
 * No sequence of user actions leads to an error. LIMBER_ACTIONS=1000 takes that many actions and also checks the growth
 * of the heap: tests/bench/page_actions.mjs.
 */

import { expect, test } from '@playwright/test';
import type { CDPSession, Page } from '@playwright/test';
import { sheetObj } from './meshes';
import { drop, goTo, openPage, readout, uncaughtErrors, writeScratch } from './page';
import { ACTIONS, seeded, takeAction } from './random_actions';

const COUNT = Number(process.env.LIMBER_ACTIONS ?? 60);
const SEED = Number(process.env.LIMBER_SEED ?? 1);
/** Until then the page fills its caches. */
const SETTLED = 100;
const MAX_GROWTH = 1.05;

/** Bytes that are in use after a collection, with the same file on the same step, as they depend on both: the least of three. */
async function heapSize(page: Page, client: CDPSession): Promise<number> {
  await drop(page, writeScratch('sheet-20.obj', sheetObj(20)));
  await goTo(page, 'Model');
  await expect(readout(page, 'Faces')).toContainText('800');
  await page.waitForTimeout(2000);
  const sizes: number[] = [];
  for (let i = 0; i < 3; i++) {
    await client.send('HeapProfiler.collectGarbage');
    sizes.push((await client.send('Runtime.getHeapUsage')).usedSize);
  }
  return Math.min(...sizes);
}

test('random actions lead to no error, and to no growth of the heap', { tag: '@full' }, async ({ page }) => {
  test.setTimeout(60_000 + 2500 * COUNT);
  const errors = uncaughtErrors(page);
  page.on('console', (message) => {
    if (message.type() === 'error') errors.push(message.text());
  });
  page.on('crash', () => errors.push('the page has crashed'));
  await openPage(page);
  const client = await page.context().newCDPSession(page);
  const random = seeded(SEED);
  const taken = new Map<string, number>();
  const heap: number[] = [];
  for (let i = 1; i <= COUNT; i++) {
    const { name, isTaken } = await takeAction(page, random);
    if (isTaken) taken.set(name, (taken.get(name) ?? 0) + 1);
    expect(errors, `after action ${i}, ${name}`).toEqual([]);
    if (i % SETTLED === 0) {
      heap.push(await heapSize(page, client));
      process.stdout.write(`${i} actions: ${(heap.at(-1)! / 1e6).toFixed(1)} MB\n`);
    }
  }
  const counts = [...taken].map(([name, times]) => `${name} ${times}`).join(', ');
  process.stdout.write(`taken: ${counts}\n`);
  const least = COUNT >= 200 ? Object.keys(ACTIONS).length : 6;
  expect(taken.size).toBeGreaterThanOrEqual(least);
  if (heap.length > 1) expect(heap.at(-1)! / heap[0]).toBeLessThanOrEqual(MAX_GROWTH);
});
