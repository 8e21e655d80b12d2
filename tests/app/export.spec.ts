import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import { unzipSync } from 'fflate';
import { sheetObj } from './meshes';
import { drop, goTo, keepFaces, keptFaces, openPage, scratch, writeScratch } from './page';

const sheet = writeScratch('sheet-out.obj', sheetObj(16));
const button = (page: Page, name: string) => page.getByRole('button', { name, exact: true });

async function openExport(page: Page): Promise<void> {
  await openPage(page);
  await drop(page, sheet);
  await expect(page.locator('.filename')).toHaveText('sheet-out.obj');
  await goTo(page, 'Reduce');
  await expect(keptFaces(page)).toBeEnabled();
  await keepFaces(page, 200);
  await button(page, 'Export').click();
}

async function saved(page: Page, name: string): Promise<Buffer> {
  await expect(button(page, name)).toBeEnabled();
  const [download] = await Promise.all([page.waitForEvent('download'), button(page, name).click()]);
  return readFileSync(await download.path());
}

test('that nothing is lost is said once the file is written and checked', async ({ page }) => {
  await openPage(page);
  await drop(page, sheet);
  await expect(page.locator('.filename')).toHaveText('sheet-out.obj');
  // Collects the text after every change of the page until the file has been written.
  await page.evaluate(() => {
    const early: string[] = [];
    Object.assign(window, { early });
    const look = (): void => {
      const panel = document.querySelector<HTMLElement>('.export');
      const isReady = panel?.querySelector('.verdict');
      if (panel && !isReady) early.push(panel.innerText);
    };
    new MutationObserver(look).observe(document.body, {
      childList: true,
      subtree: true,
      characterData: true,
    });
  });
  await button(page, 'Export').click();
  await expect(page.getByText('Nothing in the file is lost.')).toBeVisible();
  const early = await page.evaluate(() => (window as unknown as { early: string[] }).early);
  expect(early.length).toBeGreaterThan(0);
  expect(early.filter((text) => text.includes('Nothing in the file is lost.'))).toEqual([]);
});

test('levels and the binding are checked, packed, and the same as from the command line', async ({
  page,
}) => {
  await openExport(page);
  const levels = page.getByLabel('Further levels');
  await levels.fill('0.3, 0');
  await levels.press('Enter');
  await expect(page.getByRole('alert')).toContainText('“0” is not a level: give shares such as 25 %');
  await levels.fill('0.3, 0.15');
  await levels.press('Enter');
  await page.getByLabel("Binding of the original's vertices").check();
  await expect(page.locator('.levels')).toContainText('sheet-out-limber_lod2.glb');
  await expect(page.locator('.levels .verdict.good')).toHaveCount(2);
  const command = await page.locator('code.command').innerText();
  expect(command).toContain('--faces 200 --lods 0.3,0.15 --bind sheet-out-limber.bind.json');
  const files = unzipSync(await saved(page, 'Save all as .zip'));
  const words = command.split(' ').slice(1);
  const program = join(import.meta.dirname, '..', '..', 'dist', 'cli', 'limber.mjs');
  execFileSync(process.execPath, [program, ...words, '--quiet'], { cwd: scratch });
  const names = ['.glb', '_lod1.glb', '_lod2.glb', '.bind.json'].map((ending) => `sheet-out-limber${ending}`);
  expect(Object.keys(files).sort()).toEqual([...names, 'sheet-out-limber.json'].sort());
  for (const name of names) expect(readFileSync(join(scratch, name)).equals(files[name]), name).toBe(true);
  const report = JSON.parse(new TextDecoder().decode(files['sheet-out-limber.json'])) as {
    levels: { file: string; ratio: number }[];
  };
  expect(report.levels.map(({ ratio }) => ratio)).toEqual([0.3, 0.15]);
});

test('the settings of a solver are told, checked where typed, and the same as from the command line', async ({
  page,
}) => {
  await openExport(page);
  await page.getByLabel('Solver').selectOption('hinge-shell');
  await expect(page.locator('.tuning')).toContainText('In Discrete Shells the first ten frequencies are off');
  await page.getByText('Your parameters').click();
  const young = page.getByLabel('young');
  await young.fill('soft');
  await young.press('Enter');
  await expect(page.getByRole('alert')).toContainText('This has soft for young: give a number.');
  await young.fill('2e5');
  await young.press('Enter');
  await expect(page.locator('code.command')).toContainText(
    "--solver hinge-shell --engine 'young=2e5' --settings sheet-out-limber.settings.json",
  );
  const settings = await saved(page, 'Save settings');
  const command = await page.locator('code.command').innerText();
  const words = command.replaceAll("'", '').split(' ').slice(1);
  const program = join(import.meta.dirname, '..', '..', 'dist', 'cli', 'limber.mjs');
  execFileSync(process.execPath, [program, ...words, '--quiet'], { cwd: scratch });
  expect(readFileSync(join(scratch, 'sheet-out-limber.settings.json')).equals(settings)).toBe(true);
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
});

test('the report is saved as JSON, CSV and Markdown', { tag: '@full' }, async ({ page }) => {
  await openExport(page);
  const json = JSON.parse((await saved(page, 'Save report as JSON')).toString()) as {
    output: { faces: number };
  };
  expect(json.output.faces).toBeLessThanOrEqual(200);
  expect((await saved(page, 'Save report as CSV')).toString()).toContain(
    `output.faces,${json.output.faces}\r\n`,
  );
  const text = (await saved(page, 'Save report as Markdown')).toString();
  expect(text).toContain(`| faces | ${json.output.faces} |`);
});

test('files of earlier settings cannot be saved', { tag: '@full' }, async ({ page }) => {
  await openExport(page);
  await expect(button(page, 'Save .glb')).toBeEnabled();
  // The button may be disabled for a moment only.
  const isDisabled = await page.evaluate(() => {
    const save = document.querySelector<HTMLButtonElement>('.export .actions button')!;
    const seen = new Promise<boolean>((resolve) =>
      new MutationObserver(() => save.disabled && resolve(true)).observe(save, { attributes: true }),
    );
    document.querySelector<HTMLInputElement>('.export .toggle input')!.click();
    return Promise.race([seen, new Promise<boolean>((resolve) => setTimeout(() => resolve(false), 5000))]);
  });
  expect(isDisabled).toBe(true);
  await expect(button(page, 'Save .glb')).toBeEnabled();
});

for (const colorScheme of ['light', 'dark'] as const)
  test(
    `Reduce and Export pass axe with everything open in the ${colorScheme} scheme`,
    { tag: colorScheme === 'dark' ? '@full' : [] },
    async ({ browser, baseURL }) => {
      const context = await browser.newContext({ baseURL, colorScheme, reducedMotion: 'reduce' });
      const page = await context.newPage();
      const violations = async () => {
        const { violations: found } = await new AxeBuilder({ page }).analyze();
        return found.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(' ')}`);
      };
      await openPage(page);
      await drop(page, sheet);
      await goTo(page, 'Reduce');
      await expect(page.locator('.tick').first()).toBeVisible();
      await page.locator('.right summary').first().click();
      await page.getByLabel('Why is vertex').fill('3');
      await expect(page.locator('.why li').first()).toBeVisible();
      await page.getByRole('button', { name: 'Slider' }).click();
      const lock = page.getByLabel('Locked vertices');
      await lock.fill('left');
      await lock.press('Enter');
      expect(await violations()).toEqual([]);
      await page.getByRole('group', { name: 'Brush' }).getByRole('button', { name: 'Keep' }).click();
      expect(await violations()).toEqual([]);
      await button(page, 'Export').click();
      await page.getByLabel('Further levels').fill('0.3');
      await page.keyboard.press('Enter');
      await expect(page.locator('.levels li')).toHaveCount(1);
      expect(await violations()).toEqual([]);
      await context.close();
    },
  );
