import { WebIO } from '@gltf-transform/core';
import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import { sheetObj } from './meshes';
import { stillCapture, strongPixels } from './pictures';
import { drop, goTo, openPage, saveGlb, uncaughtErrors, writeScratch } from './page';
import { standingTubes } from './scenes';

test.beforeEach(async ({ page }) => {
  await openPage(page);
  await drop(page, writeScratch('tubes.glb', await standingTubes()));
  await expect(page.locator('.left .filename').first()).toHaveText('tubes.glb');
});

interface Colours {
  red: number;
  blue: number;
  /** extent of the red pixels */
  width: number;
  height: number;
  left: number;
}

/** Strongly red and blue pixels of a picture. */
async function coloursOf(page: Page, png: Buffer): Promise<Colours> {
  const { red, blue } = await strongPixels(page, png);
  const low = [1e9, 1e9];
  const high = [-1, -1];
  for (const place of red)
    place.forEach((value, c) => ([low[c], high[c]] = [Math.min(low[c], value), Math.max(high[c], value)]));
  const [width, height] = high.map((value, c) => value - low[c]);
  return { red: red.length, blue: blue.length, width, height, left: low[0] };
}

/** Without waiting for it to stand still. */
const now = async (page: Page): Promise<Colours> =>
  coloursOf(page, await page.locator('.viewport canvas').screenshot());

const shown = async (page: Page): Promise<Colours> => coloursOf(page, await stillCapture(page));

test('the stage shows the file in its materials, standing as its scene stands it', async ({ page }) => {
  await expect.poll(async () => (await shown(page)).blue).toBeGreaterThan(1000);
  const { red, width, height } = await shown(page);
  expect(red).toBeGreaterThan(1000);
  // The mesh lies along z; its node turns it upright.
  expect(height).toBeGreaterThan(1.8 * width);
  await goTo(page, 'Motion');
  await expect(page.getByRole('button', { name: 'Bottom', exact: true })).toBeVisible();
  await expect(page.getByRole('button', { name: 'Top', exact: true })).toBeVisible();
  await goTo(page, 'Test');
  await expect(page.getByText('The top turns by 45 degrees. Both ends held.')).toBeVisible();
  await page.getByLabel('Scenario', { exact: true }).selectOption({ label: 'Sway' });
  await expect(page.getByText('The top is struck. The bottom held.')).toBeVisible();
});

test('faces are counted alike everywhere, without degenerate ones, which the health list tells', async ({
  page,
}) => {
  const first = `o one\n${sheetObj(16)}f 1 1 2\nf 2 3 3\n`;
  const second = sheetObj(16)
    .replaceAll(/^v /gm, 'v 2')
    .replaceAll(
      /^f (\d+) (\d+) (\d+)/gm,
      (_, ...abc: string[]) =>
        `f ${abc
          .slice(0, 3)
          .map((v) => Number(v) + 17 * 17)
          .join(' ')}`,
    );
  await drop(page, writeScratch('degenerate.obj', `${first}o two\n${second}f 290 290 291\n`));
  await expect(page.locator('.left .filename').first()).toHaveText('degenerate.obj');
  const rows = page.getByRole('list', { name: 'Meshes' }).getByRole('listitem');
  await expect(rows).toContainText([/one512/, /two512/]);
  await expect(page.locator('.left .facts').last()).toContainText('Faces512');
  await expect(page.getByText('2 faces with a repeated vertex set aside')).toBeVisible();
  await expect(page.locator('.viewport').getByText('1,024 faces')).toBeVisible();
  await goTo(page, 'Reduce');
  const slider = page.getByRole('slider', { name: 'Kept faces of the scene' });
  await expect(slider).toHaveAttribute('aria-valuetext', '512 of 1,024 faces');
  await expect(page.locator('.viewport').getByText('1,024 faces')).toBeVisible();
  await slider.press('Home');
  await expect(page.getByText('fewest: parts or holes would change')).toBeVisible();
});

test('eyes hide meshes, and the stage shows the chosen one alone on request', async ({ page }) => {
  await expect.poll(async () => (await shown(page)).blue).toBeGreaterThan(1000);
  await page.getByRole('button', { name: 'Show blue' }).click();
  await expect.poll(async () => (await shown(page)).blue).toBe(0);
  expect((await shown(page)).red).toBeGreaterThan(1000);
  await page.getByRole('button', { name: 'Show blue' }).click();
  await page.getByText('View', { exact: true }).click();
  await page.getByLabel('Whole scene').uncheck();
  await page.getByRole('button', { name: /^blue/ }).click();
  await expect.poll(async () => (await shown(page)).red).toBe(0);
  expect((await shown(page)).blue).toBeGreaterThan(1000);
});

test('the View menu is closed by Escape, by a click elsewhere and by another step', async ({ page }) => {
  const choices = page.locator('.view-choices');
  const open = async () => {
    await page.getByText('View', { exact: true }).click();
    await expect(choices).toBeVisible();
  };
  await open();
  await page.getByLabel('Wireframe').check();
  await page.keyboard.press('Escape');
  await expect(choices).toBeHidden();
  await expect(page.locator('.view-menu summary')).toBeFocused();
  await open();
  await page.locator('.viewport canvas').click({ position: { x: 40, y: 40 } });
  await expect(choices).toBeHidden();
  await open();
  // A press of a key leaves the menu alone until the step has changed.
  await page.getByRole('button', { name: 'Reduce' }).focus();
  await expect(choices).toBeVisible();
  await page.keyboard.press('Enter');
  await expect(page.getByRole('slider', { name: 'Kept faces' })).toBeVisible();
  await expect(choices).toBeHidden();
});

test('a key that is pressed while the step changes finds no menu that is gone', async ({ page }) => {
  const errors = uncaughtErrors(page);
  await page.evaluate(async () => {
    const motion = [...document.querySelectorAll<HTMLElement>('.steps button')].find((button) =>
      button.textContent!.includes('Motion'),
    );
    motion!.click();
    for (let i = 0; i < 20; ++i) {
      document.body.dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape', bubbles: true }));
      await new Promise((resolve) => setTimeout(resolve));
    }
  });
  await expect(page.getByRole('button', { name: 'Bottom', exact: true })).toBeVisible();
  expect(errors).toEqual([]);
});

test(
  'looks change the picture, and the animation of the file moves it',
  { tag: '@full' },
  async ({ page }) => {
    await expect.poll(async () => (await shown(page)).red).toBeGreaterThan(1000);
    await page.getByLabel('Look').selectOption({ label: 'Clay' });
    await expect.poll(async () => (await shown(page)).red).toBe(0);
    await page.getByLabel('Look').selectOption({ label: 'UV checker' });
    await page.getByLabel('Look').selectOption({ label: 'Materials' });
    await page.getByText('View', { exact: true }).click();
    const { left } = await shown(page);
    await page.getByLabel('Animation').check();
    await expect.poll(async () => Math.abs((await now(page)).left - left)).toBeGreaterThan(20);
    await page.getByLabel('Animation').uncheck();
    await expect.poll(async () => (await shown(page)).left).toBe(left);
  },
);

test(
  'a locked mesh keeps its faces, and the tree says what each keeps',
  { tag: '@full' },
  async ({ page }) => {
    const row = (name: string) => page.locator('.body').filter({ hasText: name });
    await expect(row('red')).toContainText('1,280');
    await page.getByRole('button', { name: 'Keep all faces of blue' }).click();
    await goTo(page, 'Reduce');
    await expect(row('blue')).toContainText('640 → 640');
    await expect(row('red')).toContainText(/1,280 → 6[34]\d/);
    // Both meshes rest in their materials, the result too.
    await expect.poll(async () => (await shown(page)).blue).toBeGreaterThan(500);
    // Closed again, for a checked box is blue, too.
    const views = page.getByText('View', { exact: true });
    await views.click();
    await page.getByLabel('Swing').check();
    await views.click();
    await expect.poll(async () => (await now(page)).blue).toBe(0);
    await views.click();
    await page.getByLabel('Swing').uncheck();
    await views.click();
    await expect.poll(async () => (await shown(page)).blue).toBeGreaterThan(500);
    const bytes = await saveGlb(page);
    expect(new TextDecoder().decode(bytes.subarray(0, 4))).toBe('glTF');
  },
);

test('with a solver, the page names the meshes that their nodes scale unevenly', async ({ page }) => {
  const io = new WebIO();
  const document = await io.readBinary(await standingTubes());
  document.getRoot().listNodes()[1].setScale([1, 1, 2]);
  await drop(page, writeScratch('stretched.glb', await io.writeBinary(document)));
  await expect(page.locator('.left .filename').first()).toHaveText('stretched.glb');
  const warning = page.getByText(
    'blue: the node scales the mesh non-uniformly, so mesh and masses for the solver get the mean scale',
  );
  await goTo(page, 'Test');
  await expect(page.getByLabel('Scenario', { exact: true })).toBeVisible();
  await expect(warning).toHaveCount(0);
  await page.getByLabel('Solver', { exact: true }).selectOption('jolt');
  await expect(warning).toBeVisible();
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  await expect(page.getByRole('complementary', { name: 'Export' }).locator(warning)).toBeVisible();
});

test('the diagonal is in units of the file, as the metres beside it, whatever its node scales', async ({
  page,
}) => {
  const io = new WebIO();
  const document = await io.readBinary(await standingTubes());
  document.getRoot().listNodes()[0].setScale([50, 50, 50]);
  await drop(page, writeScratch('large.glb', await io.writeBinary(document)));
  await expect(page.locator('.left .filename').first()).toHaveText('large.glb');
  const diagonal = page
    .locator('.left div')
    .filter({ has: page.getByText('Diagonal', { exact: true }) })
    .last();
  await expect(diagonal).toContainText('212.1 units = 212');
});
