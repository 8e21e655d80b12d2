import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import { drop, goTo, openPage, readout, saveGlb, writeScratch } from './page';
import { sheetObj } from './meshes';

const sheet = writeScratch('policy.obj', sheetObj(16));

/** Collects violations of the policy: events of the page, and the browser's messages, which include those of workers. */
async function watch(page: Page): Promise<string[]> {
  const found: string[] = [];
  page.on('console', (message) => {
    if (/Content Security Policy|Refused to/i.test(message.text())) found.push(message.text());
  });
  await page.exposeFunction('tellViolation', (text: string) => found.push(text));
  await page.addInitScript(() => {
    addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI, sourceFile }) =>
      (window as unknown as { tellViolation(text: string): void }).tellViolation(
        `${violatedDirective} ${blockedURI} ${sourceFile}`,
      ),
    );
  });
  return found;
}

test('no step breaks the policy, and the policy forbids what it should', async ({ page }) => {
  const found = await watch(page);
  const response = await page.goto('/');
  const policy = response!.headers()['content-security-policy'];
  expect(policy).toContain("script-src 'self' 'wasm-unsafe-eval'");
  await expect(page.locator('meta[http-equiv="Content-Security-Policy"]')).toHaveAttribute('content', policy);
  await openPage(page);
  await drop(page, sheet);
  await expect(page.locator('.filename')).toHaveText('policy.obj');
  await goTo(page, 'Motion');
  await goTo(page, 'Reduce');
  await expect(readout(page, 'Deviation')).not.toContainText('...');
  await goTo(page, 'Test');
  await expect(readout(page, 'Speed-up')).toContainText(/^x\d/);
  await saveGlb(page);
  expect(found).toEqual([]);
  // The core's own workers do not create code from text either.
  const own = page.workers().find((worker) => /\/worker-[^/]*\.js$/.test(worker.url()))!;
  const refusal = await own.evaluate(
    () =>
      new Promise<string>((resolve) => {
        // Code that a test evaluates directly is exempt from the policy, code that it calls later is not.
        setTimeout(() => {
          try {
            resolve(String(new Function('return 1')()));
          } catch (error) {
            resolve((error as Error).name);
          }
        });
      }),
  );
  expect(refusal).toBe('EvalError');
  await page.evaluate(() => {
    const script = document.createElement('script');
    script.textContent = 'window.broken = true';
    document.head.append(script);
  });
  await expect.poll(() => found.length).toBeGreaterThan(0);
  expect(await page.evaluate(() => 'broken' in window)).toBe(false);
});

const root = join(import.meta.dirname, '..', '..');
const shared = join(process.env.LIMBER_SHARED ?? join(root, '..', 'shared'), 'meshes', 'gltf');

for (const name of ['Box_Draco.glb', 'BoxTextured_meshopt.glb'])
  test(`${name} is decoded without breaking the policy`, { tag: '@full' }, async ({ page }) => {
    test.skip(!existsSync(join(shared, name)), `${name} of ../shared/meshes is not here`);
    const found = await watch(page);
    await openPage(page);
    await drop(page, join(shared, name));
    await expect(page.locator('.filename')).toHaveText(name);
    await expect(readout(page, 'Faces')).toContainText('12');
    await saveGlb(page);
    expect(found).toEqual([]);
  });
