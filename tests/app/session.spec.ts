import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import { sheetObj } from './meshes';
import { drop, goTo, keepFaces, keptFaces, openPage, readout, writeScratch } from './page';

const sheet = writeScratch('kept.obj', sheetObj(16));
const brush = (page: Page, name: string) =>
  page.getByRole('group', { name: 'Brush' }).getByRole('button', { name });

/** Runs in the page: the number of tabs with files in the browser's storage. */
function savedRecords(): Promise<number> {
  return new Promise((resolve) => {
    const opening = indexedDB.open('limber', 1);
    opening.onsuccess = () => {
      const counting = opening.result.transaction('files').objectStore('files').count();
      counting.onsuccess = () => {
        opening.result.close();
        resolve(counting.result);
      };
    };
  });
}

test('a reload brings back the file, the settings, the paint and the slider', async ({ page }) => {
  await openPage(page);
  await drop(page, sheet);
  await expect(page.locator('.filename')).toHaveText('kept.obj');
  await goTo(page, 'Reduce');
  await expect(keptFaces(page)).toBeEnabled();
  await page.getByLabel('Even triangles, exact').fill('0.3');
  await keepFaces(page, 200);
  await brush(page, 'Keep').click();
  const box = (await page.locator('.viewport canvas').boundingBox())!;
  await page.mouse.click(box.x + box.width / 4, box.y + box.height / 2);
  const kept = await page.getByText(/^\d+ kept$/).innerText();
  await page.reload();
  await expect(page.locator('.filename')).toHaveText('kept.obj');
  await expect(page.getByText(kept, { exact: true })).toBeVisible();
  await expect(readout(page, 'Faces')).toContainText('512 → ');
  await expect(page.getByLabel('Kept faces, exact')).toHaveValue('200');
  await expect(page.getByLabel('Even triangles, exact')).toHaveValue('0.3');
});

test('what was done to a file comes back with it, whatever it is called, also in another tab', async ({
  page,
  context,
}) => {
  const notice = (name: string) => `Your earlier work on ${name} is restored.`;
  await openPage(page);
  await drop(page, sheet);
  await expect(page.locator('.filename')).toHaveText('kept.obj');
  await page.getByLabel('One unit of the file, exact').fill('0.01');
  await page.keyboard.press('Enter');
  await drop(page, writeScratch('other.obj', sheetObj(12)));
  await expect(page.locator('.filename')).toHaveText('other.obj');
  await expect(page.getByLabel('One unit of the file, exact')).toHaveValue('1');
  await expect(page.getByRole('button', { name: 'Start anew' })).toHaveCount(0);
  await drop(page, writeScratch('renamed.obj', sheetObj(16)));
  await expect(page.getByText(notice('renamed.obj'))).toBeVisible();
  await expect(page.getByLabel('One unit of the file, exact')).toHaveValue('0.01');
  const other = await context.newPage();
  await openPage(other);
  await drop(other, sheet);
  await expect(other.getByText(notice('kept.obj'))).toBeVisible();
  await page.getByRole('button', { name: 'Start anew' }).click();
  await expect(page.getByText(notice('renamed.obj'))).toHaveCount(0);
  await expect(page.getByLabel('One unit of the file, exact')).toHaveValue('1');
  await expect(other.getByLabel('One unit of the file, exact')).toHaveValue('0.01');
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await expect(page.getByLabel('One unit of the file, exact')).toHaveValue('0.01');
});

test('a button that has copied says so for a moment, and the last one alone', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await openPage(page);
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  const command = page.getByRole('button', { name: 'Copy command line' });
  await command.click();
  await expect(page.getByRole('button', { name: 'Copied' })).toBeVisible();
  await page.getByRole('button', { name: 'Share link' }).click();
  await expect(command).toBeVisible();
  await expect(page.getByRole('button', { name: 'Share link' })).toBeVisible();
  await command.click();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toContain('limber optimize');
  await expect(command).toBeVisible();
});

test('a link opens the sample with all settings; a link with an error is reported', async ({
  page,
  context,
}) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await openPage(page);
  await goTo(page, 'Reduce');
  await expect(keptFaces(page)).toBeEnabled();
  await page.getByRole('button', { name: 'Paper' }).click();
  await keepFaces(page, 500);
  await page.getByRole('button', { name: 'Share link' }).click();
  await expect(page.getByRole('button', { name: 'Copied' })).toBeVisible();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  expect(link).toContain('?sample=bar#method=paper&faces=500');
  const other = await context.newPage();
  await other.goto(link);
  await goTo(other, 'Reduce');
  await expect(other.getByLabel('Kept faces, exact')).toHaveValue('500');
  await expect(other.getByRole('button', { name: 'Paper' })).toHaveAttribute('aria-pressed', 'true');
  const wrong = await context.newPage();
  await wrong.goto('/?sample=bar#p=0');
  await expect(wrong.getByRole('alert')).toContainText('The link has an error. Its p is 0: give a number');
  await expect(readout(wrong, 'Faces')).toContainText('1,792');
});

test('a link for a file of one’s own waits for that file', { tag: '@full' }, async ({ page }) => {
  await page.goto('/#quality-weight=0.4&faces=100&file=kept.obj');
  const notice = page.getByText('This link is for kept.obj: open that file.');
  await expect(notice).toBeVisible();
  await page.reload();
  await expect(notice).toBeVisible();
  await drop(page, writeScratch('other.obj', sheetObj(12)));
  await expect(page.locator('.filename')).toHaveText('other.obj');
  await expect.poll(() => page.evaluate(savedRecords)).toBe(1);
  await page.reload();
  await expect(page.locator('.filename')).toHaveText('other.obj');
  await drop(page, sheet);
  await expect(page.locator('.filename')).toHaveText('kept.obj');
  expect(new URL(page.url()).hash).toBe('');
  await goTo(page, 'Reduce');
  await expect(page.getByLabel('Kept faces, exact')).toHaveValue('100');
  await expect(page.getByLabel('Even triangles, exact')).toHaveValue('0.4');
});

test(
  'files that cannot be saved do not bring back the ones before them',
  { tag: '@full' },
  async ({ page }) => {
    await openPage(page);
    await drop(page, sheet);
    await expect(page.locator('.filename')).toHaveText('kept.obj');
    await page.evaluate(() => {
      IDBObjectStore.prototype.put = () => {
        throw new DOMException('full', 'QuotaExceededError');
      };
    });
    await drop(page, writeScratch('unsaved.obj', sheetObj(12)));
    await expect(page.locator('.filename')).toHaveText('unsaved.obj');
    await page.waitForTimeout(600);
    await page.reload();
    await expect(page.locator('.filename')).toHaveText('bar.glb');
  },
);

test('Back goes to the step before, also after a reload, and leaves the page from the first', async ({
  page,
}) => {
  const current = page.getByRole('navigation', { name: 'Steps' }).locator('[aria-current]');
  await page.goto('/samples/index.json');
  await openPage(page);
  await goTo(page, 'Motion');
  await goTo(page, 'Reduce');
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  await page.waitForTimeout(600);
  await page.reload();
  await expect(readout(page, 'Faces')).toContainText('1,792 → ');
  await expect(current).toContainText('Reduce');
  await page.goBack();
  await expect(current).toContainText('Motion');
  await page.goForward();
  await expect(current).toContainText('Reduce');
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  await page.goBack();
  await expect(current).toContainText('Motion');
  await expect(page.getByRole('complementary', { name: 'Export' })).toHaveCount(0);
  await page.goBack();
  await expect(current).toContainText('Model');
  await page.goBack();
  expect(new URL(page.url()).pathname).toBe('/samples/index.json');
});

test('Back to a step at which a link still waited does not ask for it again', async ({ page }) => {
  const current = page.getByRole('navigation', { name: 'Steps' }).locator('[aria-current]');
  await page.goto('/#quality-weight=0.4&file=kept.obj');
  await expect(page.getByText('This link is for kept.obj: open that file.')).toBeVisible();
  await drop(page, writeScratch('other.obj', sheetObj(12)));
  await expect(page.locator('.filename')).toHaveText('other.obj');
  await goTo(page, 'Motion');
  await drop(page, sheet);
  await expect(page.locator('.filename')).toHaveText('kept.obj');
  await page.evaluate(() => ((window as unknown as { isSame: boolean }).isSame = true));
  await page.goBack();
  await expect(current).toContainText('Model');
  await page.waitForTimeout(500);
  expect(await page.evaluate(() => (window as unknown as { isSame?: boolean }).isSame)).toBe(true);
  expect(new URL(page.url()).hash).toBe('');
});
