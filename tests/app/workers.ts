/** The workers of the page, which a test may end. */

import { expect } from '@playwright/test';
import type { Page } from '@playwright/test';

/** Lets the test end workers of the page. */
export const followWorkers = (page: Page) =>
  page.addInitScript(() => {
    const workers: Worker[] = [];
    Object.assign(window, { workers });
    window.Worker = class extends Worker {
      constructor(address: string | URL, options?: WorkerOptions) {
        super(address, options);
        if (/\/worker-[^/]*\.js$/.test(String(address))) workers.push(this);
      }
    };
  });

/** Ends the worker of the page as a browser does when it runs out of memory: without an event, and in the middle of its work. */
export const killWorker = (page: Page) =>
  page.evaluate(() => (window as unknown as { workers: Worker[] }).workers.at(-1)!.terminate());

/** Waits until the worker has been idle for a second. */
export const settle = (page: Page) =>
  expect(async () => {
    for (let look = 0; look < 5; ++look) {
      expect(await page.locator('.notice.busy').count()).toBe(0);
      await page.waitForTimeout(200);
    }
  }).toPass();
