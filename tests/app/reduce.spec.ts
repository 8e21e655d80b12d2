import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import { sheetObj } from './meshes';
import {
  commandLineBytes,
  drop,
  goTo,
  keepFaces,
  keptFaces,
  openPage,
  readout,
  saveGlb,
  writeScratch,
} from './page';

const sheet = writeScratch('painted.obj', sheetObj(24));
const button = (page: Page, name: string) => page.getByRole('button', { name, exact: true });
const brush = (page: Page, name: string) =>
  page.getByRole('group', { name: 'Brush' }).getByRole('button', { name });

async function openSheet(page: Page): Promise<void> {
  await openPage(page);
  await drop(page, sheet);
  await expect(page.locator('.filename')).toHaveText('painted.obj');
  await goTo(page, 'Reduce');
  await expect(keptFaces(page)).toBeEnabled();
}

/** A stroke over the middle of the original, the left one of two; `across`: another horizontal position, as a fraction of the width of both. */
async function stroke(page: Page, height = 30, across = 1 / 4): Promise<void> {
  const box = (await page.locator('.viewport canvas').boundingBox())!;
  const [x, y] = [box.x + across * box.width, box.y + box.height / 2];
  await page.mouse.move(x, y - height);
  await page.mouse.down();
  await page.mouse.move(x, y + height, { steps: 8 });
  await page.mouse.up();
}

const flag = async (page: Page, name: string): Promise<string> => {
  const line = await page.locator('code.command').innerText();
  return new RegExp(`--${name} '?([^ ']+)`).exec(line)?.[1] ?? '';
};

test('paint keeps triangles, locks vertices, is erased, and undone stroke by stroke', async ({ page }) => {
  await openSheet(page);
  await brush(page, 'Keep').click();
  await stroke(page);
  await expect(page.getByText(/^\d+ kept$/)).toBeVisible();
  await brush(page, 'Lock').click();
  await stroke(page, 10);
  await expect(page.getByText(/^\d+ locked$/)).toBeVisible();
  await page.keyboard.press('Control+z');
  await expect(page.getByText(/^\d+ locked$/)).toHaveCount(0);
  await expect(page.getByText(/^\d+ kept$/)).toBeVisible();
  await page.keyboard.press('Control+Shift+Z');
  await expect(page.getByText(/^\d+ locked$/)).toBeVisible();
  await brush(page, 'Erase').click();
  // The brush is wider than the painted region, wherever the view has come to rest meanwhile.
  for (let i = 0; i < 4; ++i) await page.keyboard.press(']');
  await stroke(page, 60);
  await expect(page.getByText(/^\d+ (kept|locked)$/)).toHaveCount(0);
  await button(page, 'Undo').click();
  await button(page, 'Undo').click();
  await button(page, 'Undo').click();
  await expect(button(page, 'Undo')).toBeDisabled();
  await expect(button(page, 'Redo')).toBeEnabled();
});

test('a stroke over the optimized mesh paints the original at the same place', async ({ page }) => {
  await openSheet(page);
  await brush(page, 'Keep').click();
  await stroke(page, 30, 3 / 4);
  await expect(page.getByText(/^\d+ kept$/)).toBeVisible();
  await brush(page, 'Erase').click();
  // As wide as the stroke, wherever the view has come to rest meanwhile.
  for (let i = 0; i < 4; ++i) await page.keyboard.press(']');
  await stroke(page, 60);
  await expect(page.getByText(/^\d+ kept$/)).toHaveCount(0);
});

test('a painted sheet is written with the same bytes by the command line', async ({ page }) => {
  await openSheet(page);
  await brush(page, 'Keep').click();
  await stroke(page);
  await brush(page, 'Lock').click();
  await stroke(page, 5);
  await keepFaces(page, 400);
  const bytes = await saveGlb(page);
  const paint = await flag(page, 'paint');
  expect(paint).toMatch(/^0:/);
  expect(Buffer.from(bytes).equals(commandLineBytes(sheet, ['--faces', '400', '--paint', paint]))).toBe(true);
});

test('vertices are locked with the keyboard alone, and a text with an error says why', async ({ page }) => {
  await openSheet(page);
  await page.locator('.right summary').first().focus();
  await page.keyboard.press('Enter');
  const lock = page.getByLabel('Locked vertices');
  await lock.fill('left:3');
  await lock.press('Enter');
  await expect(page.getByRole('alert')).toContainText('This has "left:3": give low:PCT');
  await lock.fill('low:6');
  await lock.press('Enter');
  await expect(page.getByRole('alert')).toHaveCount(0);
  await button(page, 'Unlock').focus();
  await page.keyboard.press('Space');
  await expect(lock).toHaveValue('');
});

test('Escape puts the brush down, and brackets size it', { tag: '@full' }, async ({ page }) => {
  await openSheet(page);
  await brush(page, 'Keep').click();
  await page.keyboard.press(']');
  await expect(page.getByRole('slider', { name: 'Radius' })).toHaveValue('7.5');
  await page.keyboard.press('Escape');
  await expect(brush(page, 'Turn')).toHaveAttribute('aria-pressed', 'true');
  await stroke(page);
  await expect(page.getByText(/^\d+ kept$/)).toHaveCount(0);
});

test('a slider is undone as a whole, and the kept faces too', { tag: '@full' }, async ({ page }) => {
  await openSheet(page);
  const even = page.getByLabel('Even triangles', { exact: true });
  const before = await even.inputValue();
  await even.focus();
  for (let i = 0; i < 6; i++) await page.keyboard.press('ArrowRight');
  await keepFaces(page, 300);
  await button(page, 'Undo').click();
  await expect(readout(page, 'Faces')).toContainText('→ 57');
  await button(page, 'Undo').click();
  await expect(even).toHaveValue(before);
  await expect(button(page, 'Undo')).toBeDisabled();
});

const view = (page: Page, name: string) =>
  page.getByRole('group', { name: 'Compare' }).getByRole('button', { name });
const labels = (page: Page) => page.locator('.pane-labels');

test(
  'original and optimized are shown side by side, on both sides of a divider, or in turn',
  { tag: '@full' },
  async ({ page }) => {
    await openSheet(page);
    await expect(labels(page)).toContainText(/Original.*Optimized/s);
    await page.keyboard.press('v');
    await expect(view(page, 'Slider')).toHaveAttribute('aria-pressed', 'true');
    const divider = page.getByRole('slider', { name: 'Divider between original and optimized' });
    await divider.focus();
    await page.keyboard.press('ArrowRight');
    await expect(divider).toHaveValue('0.51');
    await page.keyboard.press('b');
    await expect(labels(page)).not.toContainText('Optimized');
    await page.keyboard.press('b');
    await expect(labels(page)).not.toContainText('Original');
    await view(page, 'Side by side').click();
    await expect(labels(page)).toContainText(/Original.*Optimized/s);
  },
);

test('marks on the slider show where the deviation is crossed, and a click on one sets its number of faces', async ({
  page,
}) => {
  await openSheet(page);
  const mark = page.getByRole('button', { name: /^Deviation of at most 1 %:/ });
  await expect(mark).toBeVisible();
  await mark.click();
  const faces = Number(
    /: ([\d,]+) faces/.exec((await mark.getAttribute('aria-label'))!)![1].replace(',', ''),
  );
  await expect(page.getByLabel('Kept faces, exact')).toHaveValue(String(faces));
  await expect(readout(page, 'Deviation')).toContainText(/\d\.\d+ %/);
});

test('a card says why a vertex is kept, by pointer and by its number', { tag: '@full' }, async ({ page }) => {
  await openSheet(page);
  await keepFaces(page, 100);
  await view(page, 'Optimized alone').click();
  await page.locator('.right summary').first().click();
  await page.getByLabel('Why is vertex').fill('7');
  const card = page.locator('.why');
  await expect(card).toContainText('Vertex 7');
  await expect(card).toContainText(/\d+ % of the vertices are removed before it|It cannot be removed/);
  await expect(card.locator('li').first()).toContainText('%');
  await page.keyboard.press('Escape');
  await expect(card).toHaveCount(0);
  const box = (await page.locator('.viewport canvas').boundingBox())!;
  // Rows are closer than the hover distance, so that the pointer meets every vertex in the middle of the picture.
  const sweep = async () => {
    for (let y = -80; y <= 80; y += 20)
      for (let x = -120; x <= 120; x += 10) {
        await page.mouse.move(box.x + box.width / 2 + x, box.y + box.height / 2 + y);
        if ((await card.count()) > 0) return;
      }
  };
  await expect(async () => {
    await sweep();
    await expect(card).toContainText(/Vertex \d+/, { timeout: 1000 });
  }).toPass();
});

/** Records every pair of faces and deviation that the readouts show together from now on. */
const recordPairs = (page: Page) =>
  page.evaluate(() => {
    const pairs: [string, string][] = [];
    const readouts = document.querySelector('.readouts')!;
    const valueOf = (name: string) =>
      [...readouts.querySelectorAll(':scope > div')]
        .find((one) => one.querySelector('dt')?.textContent === name)
        ?.querySelector('dd')?.textContent ?? '';
    new MutationObserver(() => pairs.push([valueOf('Faces'), valueOf('Deviation')])).observe(readouts, {
      subtree: true,
      childList: true,
      characterData: true,
    });
    Object.assign(window, { pairs });
  });

test('the numbers below the view are those of the mesh that is shown', async ({ page }) => {
  await openSheet(page);
  await expect(readout(page, 'Deviation')).toContainText('%');
  await recordPairs(page);
  for (const faces of [500, 300, 400, 200]) {
    await keepFaces(page, faces);
    await expect(readout(page, 'Deviation')).toContainText('%');
  }
  const pairs = await page.evaluate(() => (window as unknown as { pairs: [string, string][] }).pairs);
  const measured = new Map<string, Set<string>>();
  for (const [faces, deviation] of pairs)
    if (deviation.includes('%')) measured.set(faces, (measured.get(faces) ?? new Set()).add(deviation));
  expect(measured.size).toBeGreaterThanOrEqual(4);
  // Each of these meshes has a deviation of its own.
  expect(new Set([...measured.values()].flatMap((all) => [...all])).size).toBe(measured.size);
  for (const [faces, deviations] of measured) expect([...deviations], faces).toHaveLength(1);
});

test('a slider at its left end says beside it why there are no fewer faces', async ({ page }) => {
  await page.goto('/');
  const tetrahedron = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n';
  await drop(page, writeScratch('tetrahedron.obj', tetrahedron));
  await goTo(page, 'Reduce');
  await expect(page.locator('.scrubber .stopped')).toHaveText('fewest: parts or holes would change');
});

test('a limit that stops the slider is named and can be switched off, and so is a missing symmetry', async ({
  page,
}) => {
  await openSheet(page);
  const deviation = page.getByLabel('Largest deviation, exact');
  await deviation.fill('0.5');
  await deviation.press('Enter');
  // Typed text is kept while the result of the limit arrives.
  await page.getByLabel('Kept faces, exact').fill('2');
  await expect(readout(page, 'Deviation')).toContainText(/\d %/);
  await expect(page.getByLabel('Kept faces, exact')).toHaveValue('2');
  await page.keyboard.press('Enter');
  await expect(
    page.getByText(/Stopped at [\d,]+ faces: the next collapses would take the surface/),
  ).toBeVisible();
  // One limit binds, and box and share say where: those of the history end elsewhere.
  await expect(page.getByText(/^Stopped at/)).toHaveCount(1);
  const stopped = (await page.getByText(/^stopped at [\d,]+: deviation limit$/).innerText()).split(
    /[ :]+/,
  )[2];
  await expect(readout(page, 'Faces')).toContainText(`→ ${stopped}`);
  const [all, kept] = [2 * 24 * 24, Number(stopped.replaceAll(',', ''))];
  await expect(page.locator('.scrubber .ratio')).toHaveText(`${((100 * kept) / all).toFixed(1)} %`);
  await page.getByRole('button', { name: 'Lift the limit' }).click();
  await expect(deviation).toHaveValue('');
  await expect(deviation).toHaveAttribute('placeholder', 'off');
  await expect(page.getByText(/the next collapses would take the surface/)).toHaveCount(0);
  await page.locator('.right summary').first().click();
  await page.getByLabel('Keep the mirror symmetry').check();
  await expect(page.getByText(/has no mirror symmetry to keep/)).toBeVisible();
});

test(
  'seams that keep every face are named, and are crossed on request, as on the command line',
  { tag: '@full' },
  async ({ page }) => {
    // Every triangle has its own part of the texture.
    const [vertices, faces] = ['v', 'f'].map((kind) =>
      sheetObj(24)
        .split('\n')
        .filter((line) => line.startsWith(kind)),
    );
    const textured = faces.map((line, t) => {
      const uv = (k: number) => `${t / faces.length + (k % 2) * 0.001} ${k > 1 ? 1 : 0}`;
      const corners = line.split(' ').slice(1);
      const written = corners.map((corner, k) => `${corner}/${k - corners.length}`);
      return [...corners.map((_, k) => `vt ${uv(k)}`), `f ${written.join(' ')}`].join('\n');
    });
    const quilt = writeScratch('quilt.obj', [...vertices, ...textured].join('\n'));
    await openPage(page);
    await drop(page, quilt);
    await expect(page.locator('.filename')).toHaveText('quilt.obj');
    await goTo(page, 'Reduce');
    await expect(keptFaces(page)).toBeEnabled();
    await page.getByLabel('Kept faces, exact').fill('200');
    await page.keyboard.press('Enter');
    const hint = page.getByText(/Turn on “Collapse across texture seams” under More to go on\./);
    await expect(hint).toBeVisible();
    await page.locator('.right summary').first().click();
    await page.getByLabel('Collapse across texture seams').check();
    await expect.poll(async () => Number(await keptFaces(page).getAttribute('min'))).toBeLessThan(200);
    await expect(hint).toHaveCount(0);
    await keepFaces(page, 200);
    const bytes = await saveGlb(page);
    expect(Buffer.from(bytes).equals(commandLineBytes(quilt, ['--faces', '200', '--seams', 'cross']))).toBe(
      true,
    );
  },
);

test(
  'a limit on frequency errors is respected, by the command line too',
  { tag: '@full' },
  async ({ page }) => {
    await openSheet(page);
    await page.locator('.right summary').first().click();
    const limit = page.getByLabel('Largest frequency error, exact');
    await limit.fill('2');
    await limit.press('Enter');
    await page.getByLabel('Kept faces, exact').fill('40');
    await page.keyboard.press('Enter');
    await expect(page.getByText(/Stopped at [\d,]+ faces, where the first six frequencies/)).toBeVisible();
    const bytes = await saveGlb(page);
    const line = ['--faces', '40', '--max-frequency-error', '2'];
    expect(Buffer.from(bytes).equals(commandLineBytes(sheet, line))).toBe(true);
  },
);
