/** Actions of a user on the page. */

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect } from '@playwright/test';
import type { Page } from '@playwright/test';

const root = join(import.meta.dirname, '..', '..');
export const scratch = mkdtempSync(join(tmpdir(), 'limber-page-'));

export function writeScratch(name: string, content: string | Uint8Array): string {
  const path = join(scratch, name);
  writeFileSync(path, content);
  return path;
}

/** Opens the page with the bar, or with the file of an address, and waits until it is shown. */
export async function openPage(page: Page, address = '/?sample=bar'): Promise<void> {
  await page.goto(address);
  await expect(readout(page, 'Faces')).toContainText('1,792');
}

/** Drops files from the disk onto the middle of the page, with the events of a real drop. */
export async function drop(page: Page, ...files: string[]): Promise<void> {
  const client = await page.context().newCDPSession(page);
  const data = { items: [], files, dragOperationsMask: 1 };
  for (const type of ['dragEnter', 'dragOver', 'drop'] as const)
    await client.send('Input.dispatchDragEvent', { type, x: 640, y: 300, data });
}

/** The errors that no code of the page catches; collected from now on. */
export function uncaughtErrors(page: Page): string[] {
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(error.stack ?? error.message));
  return errors;
}

export const goTo = (page: Page, step: 'Model' | 'Motion' | 'Reduce' | 'Test') =>
  page.getByRole('navigation', { name: 'Steps' }).getByRole('button', { name: step }).click();

export const readout = (page: Page, name: string) =>
  page
    .locator('.readouts > div')
    .filter({ has: page.getByText(name, { exact: true }) })
    .locator('dd');

/** A measured speed-up; solids of the same lattice, as of the bar, mostly have none. */
export const SPEED_UP = /^(x\d|none)/;

export const keptFaces = (page: Page) => page.getByRole('slider', { name: 'Kept faces' });

/** Moves the slider to a number of faces and waits until the page shows a mesh of at most that many. */
export async function keepFaces(page: Page, faces: number): Promise<void> {
  await keptFaces(page).fill(String(faces));
  await expect(async () => {
    const text = await readout(page, 'Faces').innerText();
    const shown = Number(/→ ([\d,]+)/.exec(text)![1].replaceAll(',', ''));
    expect(shown).toBeLessThanOrEqual(faces);
    expect(shown).toBeGreaterThan(faces - 3);
  }).toPass();
}

/** Saves the file through the export panel and returns the downloaded bytes. */
export async function saveGlb(page: Page): Promise<Uint8Array> {
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  const save = page.getByRole('button', { name: 'Save .glb' });
  await expect(save).toBeEnabled();
  const [download] = await Promise.all([page.waitForEvent('download'), save.click()]);
  return new Uint8Array(readFileSync(await download.path()));
}

/** The bytes that `limber optimize` writes for the same input. */
export function commandLineBytes(input: string, options: string[]): Uint8Array {
  const output = join(scratch, 'command-line.glb');
  const program = join(root, 'dist', 'cli', 'limber.mjs');
  execFileSync(process.execPath, [program, 'optimize', input, output, '--quiet', ...options], {
    stdio: 'pipe',
  });
  return new Uint8Array(readFileSync(output));
}

/** Waits until the Motion step shows this text on how the modes were solved. */
export async function expectSolved(page: Page, text: string | RegExp): Promise<void> {
  const details = page.locator('details').filter({ hasText: 'How it was solved' });
  await expect(async () => {
    const isOpen = (await details.getAttribute('open', { timeout: 1000 })) !== null;
    if (!isOpen) await details.locator('summary').click({ timeout: 10_000 });
    await expect(details.getByText(text)).toBeVisible({ timeout: 10_000 });
  }).toPass({ timeout: 100_000 });
}
