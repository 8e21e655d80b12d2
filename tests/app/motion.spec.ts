import AxeBuilder from '@axe-core/playwright';
import { Document, WebIO } from '@gltf-transform/core';
import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import { combObj, sheetObj } from './meshes';
import { drop, expectSolved, goTo, openPage, readout, writeScratch } from './page';

const firstMode = (page: Page) => page.getByRole('button', { name: /^Mode 1 / });
const model = (page: Page, name: string) =>
  page.getByRole('group', { name: 'Model' }).getByRole('button', { name });
const button = (page: Page, name: string) => page.getByRole('button', { name, exact: true });

async function frequency(page: Page): Promise<number> {
  return Number(/([\d.e+-]+) Hz/.exec(await firstMode(page).innerText())?.[1]);
}

/** The bar as a solid, at the Motion step. */
async function openSolidBar(page: Page): Promise<void> {
  await openPage(page);
  await goTo(page, 'Motion');
  await model(page, 'Solid').click();
  await expectSolved(page, '6 rigid motions found, 6 expected.');
}

async function pinsText(page: Page) {
  const text = page.getByRole('textbox', { name: 'Held in place, as text' });
  if (!(await text.isVisible())) await page.getByText('As text').click();
  return text;
}

/** A point of the page where the bar is: the middle of the viewport. */
async function middle(page: Page): Promise<{ x: number; y: number }> {
  const box = (await page.locator('.viewport canvas').boundingBox())!;
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

test(
  'another material has other frequencies, and other numbers make a custom material',
  { tag: '@full' },
  async ({ page }) => {
    await openSolidBar(page);
    const rubber = await frequency(page);
    const material = page.getByLabel('Material');
    await material.selectOption('Foam');
    await expect(async () => expect(await frequency(page)).not.toBe(rubber)).toPass();
    await page.getByText('More', { exact: true }).click();
    await expect(page.getByLabel("Young's modulus, exact")).toHaveValue('50000');
    await page.getByLabel('Density, exact').fill('31');
    await page.keyboard.press('Enter');
    await expect(material).toHaveValue('custom');
  },
);

test('a pinned end leaves no rigid motion, and the command line pins it too', async ({ page }) => {
  await openSolidBar(page);
  const free = await frequency(page);
  await button(page, 'Bottom').click();
  await expectSolved(page, '0 rigid motions found, 0 expected.');
  expect(await frequency(page)).not.toBe(free);
  await expect(page.getByText('113 of 898 vertices.')).toBeVisible();
  await button(page, 'Export').click();
  await expect(page.locator('code.command')).toContainText('--model solid --pins low:6');
  await button(page, 'Close the export panel').click();
  await button(page, 'Bottom').click();
  await expectSolved(page, '6 rigid motions found, 6 expected.');
});

test('a click pins the vertex under the cursor or unpins it, a drag pins many, and Shift unpins them', async ({
  page,
}) => {
  await openSolidBar(page);
  const text = await pinsText(page);
  await button(page, 'Pick').click();
  const { x, y } = await middle(page);
  await page.mouse.click(x, y);
  await expect(text).toHaveValue(/^vertices:\d+$/);
  await expect(page.getByText('1 of 898 vertices.')).toBeVisible();
  await page.mouse.click(x, y);
  await expect(text).toHaveValue('');
  const stroke = async () => {
    await page.mouse.move(x, y - 60);
    await page.mouse.down();
    await page.mouse.move(x, y + 60, { steps: 20 });
    await page.mouse.up();
  };
  await stroke();
  await expect(text).toHaveValue(/^vertices:\d+(,\d+){3,}$/);
  await page.keyboard.down('Shift');
  await stroke();
  await page.keyboard.up('Shift');
  await expect(text).toHaveValue('');
});

test('a text with an error gets a sentence beside it, and the pins before it stay', async ({ page }) => {
  await openSolidBar(page);
  await button(page, 'Bottom').click();
  await expectSolved(page, '0 rigid motions found, 0 expected.');
  const text = await pinsText(page);
  await text.fill('left:3');
  await text.press('Enter');
  await expect(page.getByRole('alert')).toContainText('This has "left:3": give low:PCT, high:PCT');
  await text.fill('attribute:_NOPE');
  await text.press('Enter');
  await expect(page.getByRole('alert')).toContainText('This names the attribute _NOPE, but');
  await expect(text).toHaveAttribute('aria-invalid', 'true');
  await expect(button(page, 'Bottom')).toHaveAttribute('aria-pressed', 'true');
  await text.fill('low:6 + high:6');
  await text.press('Enter');
  await expect(page.getByRole('alert')).toHaveCount(0);
  await expect(page.getByText('226 of 898 vertices.')).toBeVisible();
});

test('an attribute of the file pins vertices', { tag: '@full' }, async ({ page }) => {
  await openPage(page);
  await drop(page, writeScratch('flag.glb', await flagWithAttribute(8)));
  await expect(readout(page, 'Faces')).toContainText('128');
  await goTo(page, 'Motion');
  await page.getByLabel('Attribute', { exact: true }).selectOption('_FIXED');
  await expect(page.getByText('9 of 81 vertices.')).toBeVisible();
  await drop(page, writeScratch('plain.obj', sheetObj(8)));
  await expect(page.locator('.filename')).toHaveText('plain.obj');
  await expect(page.getByText('Nothing: the body floats freely.')).toBeVisible();
});

test('modes that strain different places are named', { tag: '@full' }, async ({ page }) => {
  await openSolidBar(page);
  const notes = page.locator('.mode-notes');
  await firstMode(page).click();
  await expect(notes).not.toContainText('strain different places');
  for (let mode = 2; mode <= 8; mode++) await page.getByLabel(`Mode ${mode} guides`).check();
  await expect(notes).toContainText(/Modes \d and \d strain different places \(\d+ % in common\)/);
  await expect(page.locator('.legend')).toContainText('Strain rank, modes 1 to 8');
});

test('a local mode is named and left out on request', { tag: '@full' }, async ({ page }) => {
  await openPage(page);
  await drop(page, writeScratch('comb.obj', combObj()));
  await expect(page.locator('.filename')).toHaveText('comb.obj');
  await goTo(page, 'Motion');
  await model(page, 'Shell').click();
  await expectSolved(page, '6 rigid motions found, 6 expected.');
  const local = page.getByRole('button', { name: /^Mode \d+ local/ }).first();
  await local.click();
  await expect(page.locator('.mode-notes')).toContainText(/Mode \d+ is local: little of the body moves/);
  await button(page, 'Leave local modes out').click();
  await expect(page.locator('.mode-notes')).not.toContainText('local');
  await expect(local).toHaveAttribute('aria-pressed', 'false');
});

test(
  'a model that does not fit the mesh says so, and the modes that are still shown are marked as earlier ones',
  { tag: '@full' },
  async ({ page }) => {
    await openPage(page);
    await drop(page, writeScratch('sheet.obj', sheetObj(8)));
    await expect(readout(page, 'Faces')).toContainText('128');
    await goTo(page, 'Motion');
    await model(page, 'Solid').click();
    await expect(page.getByRole('alert')).toContainText('not closed');
    await expect(page.getByText('The modes shown are those of earlier settings.')).toBeVisible();
  },
);

test('directions can be chosen where the Laplacian is used', { tag: '@full' }, async ({ page }) => {
  await openPage(page);
  await goTo(page, 'Motion');
  await model(page, 'Shell').click();
  const directions = page.getByRole('group', { name: 'Direction' });
  await expect(directions).toHaveCount(0);
  await model(page, 'Laplacian').click();
  await directions.getByRole('button', { name: 'Z' }).click();
  await expectSolved(page, /1 rigid motion found, 1 expected/);
});

test('a large shell is solved on a coarser copy, and on request as it is', async ({ page }) => {
  await openPage(page);
  await drop(page, writeScratch('large.obj', sheetObj(96)));
  await expect(readout(page, 'Faces')).toContainText('18,432');
  await goTo(page, 'Motion');
  await model(page, 'Shell').click();
  await expect(page.getByText(/Modes from a copy with [\d,]+ vertices, enough to guide/)).toBeVisible();
  await page.getByLabel('Solve the mesh itself').check();
  await expect(page.getByText(/Modes from a copy/)).toHaveCount(0);
  await expect(page.getByLabel('Solve the mesh itself')).toBeChecked();
});

test('the step works with the keyboard alone', async ({ page }) => {
  await openSolidBar(page);
  const material = page.getByLabel('Material');
  await material.focus();
  await page.keyboard.press('ArrowDown');
  await expect(material).toHaveValue('foam');
  await button(page, 'Top').focus();
  await page.keyboard.press('Space');
  await expect(page.getByText('113 of 898 vertices.')).toBeVisible();
  await button(page, 'Pick').focus();
  await page.keyboard.press('Enter');
  await expect(button(page, 'Pick')).toHaveAttribute('aria-pressed', 'true');
  await page.keyboard.press('Escape');
  await expect(button(page, 'Pick')).toHaveAttribute('aria-pressed', 'false');
  await page.getByLabel('Mode 8 guides').focus();
  await page.keyboard.press('Space');
  await expect(page.getByRole('button', { name: /^Mode 8 / })).toHaveAttribute('aria-pressed', 'true');
  await button(page, 'Clear the pins').focus();
  await page.keyboard.press('Enter');
  await expect(page.getByText('Nothing: the body floats freely.')).toBeVisible();
});

for (const colorScheme of ['light', 'dark'] as const)
  test(
    `the step passes axe with everything open in the ${colorScheme} scheme`,
    { tag: colorScheme === 'dark' ? '@full' : [] },
    async ({ browser, baseURL }) => {
      const context = await browser.newContext({ baseURL, colorScheme, reducedMotion: 'reduce' });
      const page = await context.newPage();
      await openSolidBar(page);
      await button(page, 'Bottom').click();
      const text = await pinsText(page);
      await text.fill('left:3');
      await text.press('Enter');
      await page.getByText('More', { exact: true }).click();
      await button(page, 'Pick').click();
      await expect(page.locator('.notice.busy')).toHaveCount(0);
      const { violations } = await new AxeBuilder({ page }).analyze();
      expect(violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(' ')}`)).toEqual(
        [],
      );
      await context.close();
    },
  );

/** A flat grid of cells x cells squares whose first column is marked by the attribute _FIXED. */
async function flagWithAttribute(cells: number): Promise<Uint8Array> {
  const side = cells + 1;
  const at = (i: number, j: number) => j * side + i;
  const positions = new Float32Array(3 * side * side);
  const marks = new Float32Array(side * side);
  const indices: number[] = [];
  for (let j = 0; j < side; j++)
    for (let i = 0; i < side; i++) {
      positions.set([i, j, 0.2 * Math.sin(i)], 3 * at(i, j));
      marks[at(i, j)] = i === 0 ? 1 : 0;
      if (i < cells && j < cells)
        indices.push(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  const document = new Document();
  const buffer = document.createBuffer();
  const accessor = (type: 'VEC3' | 'SCALAR', array: Float32Array | Uint32Array) =>
    document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const primitive = document
    .createPrimitive()
    .setAttribute('POSITION', accessor('VEC3', positions))
    .setAttribute('_FIXED', accessor('SCALAR', marks))
    .setIndices(accessor('SCALAR', Uint32Array.from(indices)));
  const node = document.createNode('flag').setMesh(document.createMesh('flag').addPrimitive(primitive));
  document.createScene().addChild(node);
  return new WebIO().writeBinary(document);
}
