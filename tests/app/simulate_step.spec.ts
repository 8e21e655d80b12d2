import { createHash } from 'node:crypto';
import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import { PLAIN } from '../../playwright.config';
import { goTo, openPage, readout } from './page';

/** Opens the Test step and waits until both bodies stand there. */
async function openTest(page: Page, address?: string): Promise<void> {
  await openPage(page, address);
  await goTo(page, 'Test');
  await expect(readout(page, 'Time')).toContainText(/\d s/);
}

const button = (page: Page, name: string) => page.getByRole('button', { name, exact: true });
const scenario = (page: Page) => page.getByLabel('Scenario', { exact: true });
const curve = (page: Page) => page.getByRole('img', { name: /^Deviation/ });

/** What the stage shows, as a hash: a failed comparison of whole pictures would take minutes to print. */
async function picture(page: Page): Promise<string> {
  const png = await page.locator('.viewport canvas').screenshot();
  return createHash('sha256').update(png).digest('hex');
}

async function numberIn(page: Page, name: string): Promise<number> {
  return Number(/[\d.]+/.exec(await readout(page, name).innerText())![0]);
}

/** Waits until the picture stands still. */
async function stillPicture(page: Page): Promise<string> {
  let last = await picture(page);
  await expect(async () => {
    const before = last;
    await page.waitForTimeout(300);
    last = await picture(page);
    expect(last).toEqual(before);
  }).toPass();
  return last;
}

/** Waits until the motion has come so far, in seconds. */
const untilTime = (page: Page, seconds: number) =>
  expect(async () => expect(await numberIn(page, 'Time')).toBeGreaterThan(seconds)).toPass();

/** Runs in the page, in each of its frames: none is missed where the test itself is slow to look. */
const showsTimeBelow = (seconds: number): boolean =>
  [...document.querySelectorAll('.readouts > div')].some(
    (row) =>
      row.querySelector('dt')?.textContent === 'Time' &&
      parseFloat(row.querySelector('dd')!.textContent) < seconds,
  );

test('both bodies move, and the numbers say how fast and how close they are', async ({ page }) => {
  await openTest(page);
  const before = await picture(page);
  await untilTime(page, 0.5);
  expect(await picture(page)).not.toEqual(before);
  await expect(readout(page, 'Original, a step')).toContainText(/ms\s*[\d.]+ µs\/substep/);
  expect(await numberIn(page, 'Original, a step')).toBeGreaterThan(await numberIn(page, 'Optimized, a step'));
  await expect(readout(page, 'Speed-up')).toContainText(/^x[1-9]/);
  await expect(readout(page, 'Deviation')).toContainText(/[\d.]+ %/);
  await expect(curve(page)).toHaveAccessibleName(
    /now [\d.]+ % of the diagonal.* at most [\d.]+ % at \d\.\d s/,
  );
});

test('pause holds the picture, a step takes a sixtieth of a second, reset goes back to the start', async ({
  page,
}) => {
  await openTest(page);
  await untilTime(page, 0.2);
  await button(page, 'Pause').click();
  await expect(readout(page, 'Time')).toContainText('paused');
  const time = await numberIn(page, 'Time');
  const still = await stillPicture(page);
  await page.waitForTimeout(300);
  expect(await numberIn(page, 'Time')).toBe(time);
  expect(await picture(page)).toEqual(still);
  for (let i = 0; i < 6; i++) await button(page, 'Step').click();
  await expect(readout(page, 'Time')).toContainText(`${(Math.round(60 * time + 6) / 60).toFixed(2)} s`);
  await button(page, 'Reset').click();
  await expect(readout(page, 'Time')).toContainText('0.00 s');
});

test('the same steps give the same motion', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await openTest(page);
  const names: (string | null)[] = [];
  for (let round = 0; round < 2; round++) {
    for (let i = 0; i < 12; i++) await button(page, 'Step').click();
    await expect(readout(page, 'Time')).toContainText('0.20 s');
    names.push(await curve(page).getAttribute('aria-label'));
    await button(page, 'Reset').click();
    await expect(readout(page, 'Time')).toContainText('0.00 s');
  }
  expect(names[0]).toContain('now');
  expect(names[0]).toBe(names[1]);
});

test('who wants less motion starts paused', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await openTest(page);
  await page.waitForTimeout(500);
  await expect(readout(page, 'Time')).toContainText('0.00 s');
  await expect(button(page, 'Play')).toBeVisible();
});

test('every scenario starts again and moves both', async ({ page }) => {
  await openTest(page); // shows the twist
  for (const name of ['Sway', 'Hang', 'Drape', 'Drop', 'Pull', 'Wind', 'Twist']) {
    await untilTime(page, 0.5);
    const startsAgain = page.waitForFunction(showsTimeBelow, 0.5);
    await scenario(page).selectOption({ label: name });
    await startsAgain;
    await untilTime(page, 0.2);
    await expect(page.getByRole('alert')).toHaveCount(0);
    await expect(readout(page, 'Stretch')).toContainText(/[\d.]+ %\s*optimized [\d.]+ %/);
  }
});

test('more substeps cost more', async ({ page }) => {
  await openTest(page);
  await untilTime(page, 0.3);
  const before = await numberIn(page, 'Original, a step');
  const field = page.getByLabel('Substeps, exact');
  await field.fill('100');
  await field.press('Enter');
  await expect(async () => {
    expect(await numberIn(page, 'Original, a step')).toBeGreaterThan(2 * before);
  }).toPass();
});

test('pins of the motion step hold both bodies', async ({ page }) => {
  await openPage(page);
  await goTo(page, 'Motion');
  await button(page, 'Low end').click();
  await expect(page.getByText(/\d+ of 898 vertices\./)).toBeVisible();
  await goTo(page, 'Test');
  await expect(page.getByLabel('Held in place')).toHaveValue('pins');
  await scenario(page).selectOption('hang');
  await untilTime(page, 0.3);
  await page.getByLabel('Held in place').selectOption('corners');
  await untilTime(page, 0.1);
  await expect(page.getByRole('alert')).toHaveCount(0);
});

test('what both can touch is a text that is checked, and calibration starts again', async ({ page }) => {
  await openTest(page);
  await page.getByText('More', { exact: true }).click();
  const field = page.getByLabel('Can touch');
  await field.fill('ball:0,0');
  await field.press('Enter');
  await expect(page.getByRole('alert')).toContainText('This has "ball:0,0": give');
  await field.fill('ground: -1 + ball: 0,0,0, 0.2');
  await field.press('Enter');
  await expect(page.getByRole('alert')).toHaveCount(0);
  await expect(field).toHaveValue('ground:-1+ball:0,0,0,0.2');
  await page.getByLabel('Calibrated').check();
  await untilTime(page, 0.2);
});

test('a hand pulls at both bodies and lets go', async ({ page }) => {
  await openTest(page);
  await scenario(page).selectOption('sway');
  await untilTime(page, 0.1);
  const box = (await page.locator('.viewport canvas').boundingBox())!;
  const [x, y] = [box.x + box.width / 4, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await expect(page.locator('.viewport canvas')).toHaveClass(/dragging/);
  await page.mouse.move(x + 120, y, { steps: 8 });
  const isPulled = async (name: RegExp, least: number) => {
    const text = await readout(page, 'Stretch').innerText();
    expect(Number(name.exec(text)![1])).toBeGreaterThan(least);
  };
  await expect(async () => {
    await isPulled(/^([\d.]+) %/, 1.5);
    await isPulled(/optimized ([\d.]+) %/, 1.5);
  }).toPass();
  await page.mouse.up();
  await expect(page.locator('.viewport canvas')).not.toHaveClass(/dragging/);
});

test('a drag beside the bodies turns the view of both', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await openTest(page);
  await page.waitForTimeout(500);
  const before = await picture(page);
  const box = (await page.locator('.viewport canvas').boundingBox())!;
  await page.mouse.move(box.x + 20, box.y + 300);
  await page.mouse.down();
  await page.mouse.move(box.x + 100, box.y + 300, { steps: 5 });
  await page.mouse.up();
  await page.waitForTimeout(500);
  expect(await picture(page)).not.toEqual(before);
});

test('a body that is pulled to pieces stops, is outlined and says what helps', async ({ page }) => {
  await openTest(page);
  await scenario(page).selectOption('sway');
  await untilTime(page, 0.1);
  const box = (await page.locator('.viewport canvas').boundingBox())!;
  const [x, y] = [box.x + box.width / 4, box.y + box.height / 2];
  await page.mouse.move(x, y);
  // So far away that the page is many times as wide as the body.
  for (let i = 0; i < 12; i++) await page.mouse.wheel(0, 240);
  await page.waitForTimeout(500);
  await page.mouse.down();
  await page.mouse.move(1270, y, { steps: 4 });
  await expect(page.getByRole('alert')).toContainText(
    /flown apart at [\d.]+ s: raise the substeps \(now 20\)/,
  );
  await page.mouse.up();
  await expect(page.locator('.exploded')).not.toHaveCount(0);
  await expect(button(page, 'Play')).toBeDisabled();
  await button(page, 'Reset').click();
  await expect(page.getByRole('alert')).toHaveCount(0);
  await expect(button(page, 'Play')).toBeEnabled();
});

test('overlaid, driven and coloured by deviation', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await openTest(page);
  for (let i = 0; i < 5; i++) await button(page, 'Step').click();
  await page.waitForTimeout(300);
  const pictures = [await picture(page)];
  const isNew = async () => {
    await page.waitForTimeout(400);
    const next = await picture(page);
    for (const earlier of pictures) expect(next).not.toEqual(earlier);
    pictures.push(next);
  };
  await page.getByLabel('Original driven by optimized').check();
  await expect(page.locator('.pane-labels')).toContainText('Original, carried by the optimized 896 faces');
  await isNew();
  await button(page, 'Deviation').click();
  await expect(page.locator('.legend')).toContainText(/Deviation, % of diagonal/);
  await isNew();
  await button(page, 'Overlaid').click();
  await isNew();
});

test('another step gives the memory back, and the way back starts again', async ({ page }) => {
  await openTest(page);
  await untilTime(page, 0.1);
  const simulates = () => page.workers().filter((worker) => worker.url().includes('simulation')).length;
  expect(simulates()).toBe(1);
  await goTo(page, 'Reduce');
  await expect.poll(simulates).toBe(0);
  await goTo(page, 'Test');
  await untilTime(page, 0.1);
});

test('it works on one thread, without shared memory', async ({ page }) => {
  await openTest(page, `${PLAIN}?sample=bar`);
  await untilTime(page, 0.2);
  await expect(readout(page, 'Speed-up')).toContainText(/^x\d/);
});

test('the step works with the keyboard alone', async ({ page }) => {
  await openTest(page);
  await page.keyboard.press('Space');
  await expect(readout(page, 'Time')).toContainText('paused');
  await page.keyboard.press('Home');
  await expect(readout(page, 'Time')).toContainText('0.00 s');
  await page.keyboard.press('ArrowRight');
  await expect(readout(page, 'Time')).toContainText('0.02 s');
  await page.keyboard.press('v');
  await expect(button(page, 'Overlaid')).toHaveAttribute('aria-pressed', 'true');
  await page.keyboard.press('d');
  await expect(page.getByLabel('Original driven by optimized')).toBeChecked();
  await page.keyboard.press('2');
  await expect(button(page, 'Deviation')).toHaveAttribute('aria-pressed', 'true');
  await scenario(page).focus();
  await page.keyboard.press('ArrowDown');
  await expect(scenario(page)).toHaveValue('sway');
  await button(page, 'Play').focus();
  await page.keyboard.press('Enter');
  await untilTime(page, 0.1);
});

test('a narrow screen has it in one column', async ({ browser, baseURL }) => {
  const context = await browser.newContext({
    baseURL,
    viewport: { width: 390, height: 844 },
    hasTouch: true,
  });
  const page = await context.newPage();
  await openTest(page);
  await untilTime(page, 0.1);
  const widths = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  expect(widths[0]).toBe(widths[1]);
  await context.close();
});

for (const colorScheme of ['light', 'dark'] as const)
  test(`the step passes axe with everything open in the ${colorScheme} scheme`, async ({
    browser,
    baseURL,
  }) => {
    const context = await browser.newContext({ baseURL, colorScheme, reducedMotion: 'reduce' });
    const page = await context.newPage();
    await openTest(page);
    for (let i = 0; i < 3; i++) await button(page, 'Step').click();
    await button(page, 'Deviation').click();
    await button(page, 'Overlaid').click();
    await page.getByText('More', { exact: true }).click();
    await expect(page.locator('.notice.busy')).toHaveCount(0);
    const { violations } = await new AxeBuilder({ page }).analyze();
    expect(violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(' ')}`)).toEqual(
      [],
    );
    await context.close();
  });
