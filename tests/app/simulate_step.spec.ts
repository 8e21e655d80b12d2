import { readFileSync } from 'node:fs';
import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import { unzipSync } from 'fflate';
import { PLAIN } from '../../playwright.config';
import { goTo, keepFaces, openPage, readout, SPEED_UP } from './page';
import { compare, picture, stillCapture } from './pictures';

/** Opens the Test step and waits until both bodies are shown. */
async function openTest(page: Page, address?: string): Promise<void> {
  await openPage(page, address);
  await goTo(page, 'Test');
  await expect(readout(page, 'Time')).toContainText(/\d s/);
}

const button = (page: Page, name: string) => page.getByRole('button', { name, exact: true });
const scenario = (page: Page) => page.getByLabel('Scenario', { exact: true });
/** Pictures of a body at rest are identical, see the test of Pause. */
const MOVED_PIXELS = 100;

const curve = (page: Page) => page.getByRole('img', { name: /^Deviation/ });

async function numberIn(page: Page, name: string): Promise<number> {
  return Number(/[\d.]+/.exec(await readout(page, name).innerText())![0]);
}

/** Waits until the simulated time is above `seconds`. */
const untilTime = (page: Page, seconds: number) =>
  expect(async () => expect(await numberIn(page, 'Time')).toBeGreaterThan(seconds)).toPass();

/** Changes a setting of the paused simulation and waits until it is at its start again, with the camera at rest. */
async function restart(page: Page, change: () => Promise<unknown>): Promise<Buffer> {
  // Only a simulation that has left its start can show that it returns there.
  await expect(readout(page, 'Time')).not.toContainText('0.00 s');
  await change();
  await expect(readout(page, 'Time')).toContainText('0.00 s');
  return stillCapture(page);
}

/** Plays the paused simulation until `seconds`, pauses it, and returns its picture. */
async function playUntil(page: Page, seconds: number): Promise<Buffer> {
  await button(page, 'Play').click();
  await untilTime(page, seconds);
  await button(page, 'Pause').click();
  return stillCapture(page);
}

test('both bodies move, and the numbers say how fast and how close they are', async ({ page }) => {
  await openTest(page);
  // Solids of both bodies have the same lattice, so that they take equally long.
  await page.getByLabel('Solver', { exact: true }).selectOption({ label: "Limber's shell" });
  const before = await picture(page);
  await untilTime(page, 0.5);
  expect(await picture(page)).not.toEqual(before);
  await expect(readout(page, 'Original, per step')).toContainText(/ms\s*[\d.]+\u00a0µs\/substep/);
  expect(await numberIn(page, 'Original, per step')).toBeGreaterThan(
    await numberIn(page, 'Optimized, per step'),
  );
  await expect(readout(page, 'Speed-up')).toContainText(/^x[1-9]/);
  await expect(readout(page, 'Deviation')).toContainText(/[\d.]+ %/);
  await expect(curve(page)).toHaveAccessibleName(
    /now [\d.]+ % of the diagonal.* at most [\d.]+ % at \d\.\d s/,
  );
});

test(
  'Pause freezes the picture, Step takes a sixtieth of a second, Reset goes back to the start',
  { tag: '@full' },
  async ({ page }) => {
    await openTest(page);
    await untilTime(page, 0.2);
    await button(page, 'Pause').click();
    await expect(readout(page, 'Time')).toContainText('paused');
    const time = await numberIn(page, 'Time');
    const still = await stillCapture(page);
    await page.waitForTimeout(300);
    expect(await numberIn(page, 'Time')).toBe(time);
    expect((await stillCapture(page)).equals(still)).toBe(true);
    for (let i = 0; i < 6; i++) await button(page, 'Step').click();
    await expect(readout(page, 'Time')).toContainText(`${(Math.round(60 * time + 6) / 60).toFixed(2)} s`);
    await button(page, 'Reset').click();
    await expect(readout(page, 'Time')).toContainText('0.00 s');
  },
);

test('the same steps give the same motion', { tag: '@full' }, async ({ page }) => {
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

test('with reduced motion the simulation starts paused', { tag: '@full' }, async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await openTest(page);
  await page.waitForTimeout(500);
  await expect(readout(page, 'Time')).toContainText('0.00 s');
  await expect(button(page, 'Play')).toBeVisible();
});

test('every scenario starts at rest and moves both bodies', { tag: '@full' }, async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await openTest(page);
  // The page opens with the twist, so that comes last.
  for (const name of ['Sway', 'Hang', 'Drape', 'Drop', 'Pull', 'Wind', 'Twist']) {
    await button(page, 'Step').click();
    const start = await restart(page, () => scenario(page).selectOption({ label: name }));
    const { changed } = await compare(page, start, await playUntil(page, 0.3));
    for (const pixels of changed) expect(pixels, name).toBeGreaterThan(MOVED_PIXELS);
    await expect(page.getByRole('alert')).toHaveCount(0);
  }
});

test('both bodies move in the solver that is chosen', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await openTest(page);
  await button(page, 'Step').click();
  const solver = page.getByLabel('Solver', { exact: true });
  const tuning = page.getByRole('group', { name: 'Optimized mesh' });
  await expect(tuning).toHaveCount(0);
  const start = await restart(page, () => solver.selectOption('springs'));
  await expect(tuning.getByRole('button', { name: 'Untuned' })).toHaveAttribute('aria-pressed', 'true');
  const springs = await deviationAfterSteps(page);
  const { changed } = await compare(page, start, await playUntil(page, 0.3));
  for (const pixels of changed) expect(pixels).toBeGreaterThan(MOVED_PIXELS);
  await restart(page, () => solver.selectOption({ label: "Limber's shell" }));
  expect(await deviationAfterSteps(page)).not.toBe(springs);
});

/** At the same time in every motion, although playing ends at a different frame each time. */
async function deviationAfterSteps(page: Page): Promise<number> {
  for (let step = 1; step <= 12; ++step) {
    await button(page, 'Step').click();
    await expect(readout(page, 'Time')).toContainText(`${(step / 60).toFixed(2)} s`);
  }
  return numberIn(page, 'Deviation');
}

test('who does not know the solver gets the plain result, words to choose by, and settings for all', async ({
  page,
}) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await openTest(page);
  const solver = page.getByLabel('Solver', { exact: true });
  await solver.selectOption({ label: "Don't know" });
  await expect(page.getByText('Any engine can use it')).toBeVisible();
  const { violations } = await new AxeBuilder({ page }).include('.panel.right').analyze();
  expect(violations).toEqual([]);
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    button(page, 'Save all four as .zip').click(),
  ]);
  expect(download.suggestedFilename()).toBe('bar-limber-any-engine.zip');
  const files = unzipSync(readFileSync(await download.path()));
  const families = {
    shell: 'shell',
    'hinge-shell': 'discrete-shells',
    dihedral: 'edges-and-hinges',
    springs: 'springs',
  };
  expect(Object.keys(files).sort()).toEqual(
    ['bar-limber.glb', ...Object.values(families).map((name) => `bar-limber.${name}.settings.json`)].sort(),
  );
  const read = (name: string) =>
    JSON.parse(new TextDecoder().decode(files[`bar-limber.${name}.settings.json`])) as {
      solver: string;
      bodies: { mesh: { triangles: number[] } }[];
    };
  const meshes = Object.entries(families).map(([solverName, name]) => {
    expect(read(name).solver).toBe(solverName);
    return read(name).bodies[0].mesh.triangles;
  });
  // All of them belong to the mesh in the same archive.
  for (const mesh of meshes) expect(mesh).toEqual(meshes[0]);

  // A user who chooses a solver during the tuning, for example for another number of faces, is told what was stopped
  // and can go back.
  await goTo(page, 'Reduce');
  await keepFaces(page, 400);
  await goTo(page, 'Test');
  await button(page, 'Save all four as .zip').click();
  await solver.selectOption({ label: 'Springs' });
  const stopped = page
    .getByRole('status')
    .filter({ hasText: 'was stopped because another solver was chosen' });
  await expect(stopped).toBeVisible();
  const [again] = await Promise.all([
    page.waitForEvent('download'),
    stopped.getByRole('button', { name: 'Go back and save all four' }).click(),
  ]);
  expect(again.suggestedFilename()).toBe('bar-limber-any-engine.zip');
  await expect(stopped).toHaveCount(0);

  const table = page.getByRole('row', { name: /Springs only/ });
  await table.getByRole('button', { name: 'Springs' }).click();
  await expect(solver).toHaveValue('springs');
  await expect(table).toHaveCount(0);
});

test('nothing is said of the noise floor before the motion starts', async ({ page }) => {
  await openPage(page);
  await page.evaluate(() => {
    const notes: string[] = ((window as unknown as { notes: string[] }).notes = []);
    const look = () => {
      const text = document.querySelector('.readouts.of-test')?.textContent ?? '';
      if (text.includes('about to start')) notes.push(text);
      requestAnimationFrame(look);
    };
    look();
  });
  await goTo(page, 'Test');
  await expect(readout(page, 'Time')).toContainText(/\d s/);
  const notes = await page.evaluate(() => (window as unknown as { notes: string[] }).notes);
  expect(notes.length).toBeGreaterThan(0);
  expect(notes.filter((text) => text.includes('noise'))).toEqual([]);
});

test('a check says whether the substeps are enough, and what to take where they are not', async ({
  page,
}) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await openTest(page);
  const field = page.getByLabel('Substeps, exact');
  const substeps = async (count: number) => {
    await field.fill(String(count));
    await field.press('Enter');
  };
  await substeps(2000); // takes minutes
  await button(page, 'Check substeps').click();
  await expect(page.getByText('Checking ...')).toBeVisible();
  await button(page, 'Cancel the check').click();
  await expect(page.getByText('Checking ...')).toHaveCount(0);
  await substeps(1);
  await button(page, 'Check substeps').click();
  await expect(
    page.getByText(
      /^At 1 substep the deviation of [\d.]+ % is not reliable, because 2 would move the original itself/,
    ),
  ).toBeVisible({
    timeout: 60_000,
  });
  const take = page.getByRole('button', { name: /^Take / });
  const wanted = /[\d,]+/.exec(await take.innerText())![0].replaceAll(',', '');
  await take.click();
  await expect(field).toHaveValue(wanted);
  await expect(page.getByText(/is not reliable/)).toHaveCount(0);
});

test(
  'another number of substeps starts again, and fewer of them leave more stretch',
  { tag: '@full' },
  async ({ page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await openTest(page);
    const stretchWith = async (substeps: number) => {
      await button(page, 'Step').click();
      const field = page.getByLabel('Substeps, exact');
      await restart(page, async () => {
        await field.fill(String(substeps));
        await field.press('Enter');
      });
      for (let i = 0; i < 12; i++) await button(page, 'Step').click();
      await expect(readout(page, 'Time')).toContainText('0.20 s');
      return numberIn(page, 'Stretch');
    };
    const most = await stretchWith(1);
    expect(most).toBeGreaterThan(await stretchWith(50));
    expect(await stretchWith(1)).toBe(most);
  },
);

test(
  'pins of the Motion step stay where they are on both bodies, and the rest moves',
  { tag: '@full' },
  async ({ page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce', colorScheme: 'light' });
    await openPage(page);
    await goTo(page, 'Motion');
    await button(page, 'Bottom').click();
    await expect(page.getByText(/\d+ of 898 vertices\./)).toBeVisible();
    await goTo(page, 'Test');
    await expect(readout(page, 'Time')).toContainText('0.00 s');
    const source = page.getByLabel('Held in place');
    await expect(source).toHaveValue('pins');
    await button(page, 'Step').click();
    // By itself this scenario pins the upper end.
    const start = await restart(page, () => scenario(page).selectOption('wind'));
    const low = await compare(page, start, await playUntil(page, 0.5));
    for (const side of [0, 1] as const) {
      expect(low.pins[side]).toBeGreaterThan(MOVED_PIXELS);
      expect(low.pinHeight[side]).toBeGreaterThan(0.5);
      expect(low.keptPins[side]).toBeGreaterThan(0.9);
      expect(low.changed[side]).toBeGreaterThan(MOVED_PIXELS);
    }
    await restart(page, () => source.selectOption('corners'));
    // If the user has framed the view, the camera does not move back from bodies that move out of it.
    await page.locator('.viewport canvas').hover();
    await page.mouse.wheel(0, 300);
    const startAtCorners = await stillCapture(page);
    const corners = await compare(page, startAtCorners, await playUntil(page, 0.5));
    for (const side of [0, 1] as const) {
      expect(corners.pinHeight[side]).toBeLessThan(0.5);
      expect(corners.keptPins[side]).toBeGreaterThan(0.9);
      expect(corners.changed[side]).toBeGreaterThan(MOVED_PIXELS);
    }
  },
);

test(
  'the text of what both bodies can touch is checked, and calibration starts again',
  { tag: '@full' },
  async ({ page }) => {
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
  },
);

test('the pointer pulls at both bodies and releases them', async ({ page }) => {
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

test('a drag beside the bodies turns the view of both', { tag: '@full' }, async ({ page }) => {
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

test(
  'a body that is pulled far away diverges, stops, is outlined, and a sentence says what helps',
  { tag: '@full' },
  async ({ page }) => {
    await openTest(page);
    await scenario(page).selectOption('sway');
    await untilTime(page, 0.1);
    const box = (await page.locator('.viewport canvas').boundingBox())!;
    const [x, y] = [box.x + box.width / 4, box.y + box.height / 2];
    await page.mouse.move(x, y);
    // The view is so far away that the page is many times as wide as the body.
    for (let i = 0; i < 12; i++) await page.mouse.wheel(0, 240);
    await page.waitForTimeout(500);
    await page.mouse.down();
    await page.mouse.move(1270, y, { steps: 4 });
    await expect(page.getByRole('alert')).toContainText(
      /diverged at [\d.]+ s: raise the substeps \(now 20\)/,
    );
    await page.mouse.up();
    await expect(page.locator('.diverged')).not.toHaveCount(0);
    await expect(button(page, 'Play')).toBeDisabled();
    await button(page, 'Reset').click();
    await expect(page.getByRole('alert')).toHaveCount(0);
    await expect(button(page, 'Play')).toBeEnabled();
  },
);

test('the bodies can be overlaid, driven and coloured by deviation', { tag: '@full' }, async ({ page }) => {
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
  await expect(page.locator('.pane-labels')).toContainText('Original, carried by the optimized 1,792 faces');
  await isNew();
  await button(page, 'Deviation').click();
  await expect(page.locator('.legend')).toContainText(/Deviation, % of diagonal/);
  await isNew();
  await button(page, 'Overlaid').click();
  await isNew();
});

test(
  'another step ends the worker and frees its memory, and the way back starts it again',
  { tag: '@full' },
  async ({ page }) => {
    await openTest(page);
    await untilTime(page, 0.1);
    const simulates = () => page.workers().filter((worker) => worker.url().includes('simulation')).length;
    expect(simulates()).toBe(1);
    await goTo(page, 'Reduce');
    await expect.poll(simulates).toBe(0);
    await goTo(page, 'Test');
    await untilTime(page, 0.1);
  },
);

test('the simulation works on one thread, without shared memory', { tag: '@full' }, async ({ page }) => {
  await openTest(page, `${PLAIN}?sample=bar`);
  await untilTime(page, 0.2);
  await expect(readout(page, 'Speed-up')).toContainText(SPEED_UP);
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
  const drawn = page.locator('.pane-labels > span').filter({ hasText: 'Original, carried by the optimized' });
  await expect(drawn).toContainText('1,792 faces');
  await page.keyboard.press('c');
  await expect(button(page, 'Deviation')).toHaveAttribute('aria-pressed', 'true');
  await scenario(page).focus();
  await page.keyboard.press('ArrowDown');
  await expect(scenario(page)).toHaveValue('sway');
  await button(page, 'Play').focus();
  await page.keyboard.press('Enter');
  await untilTime(page, 0.1);
});

test('what is held in place is not said to fall onto a ball', async ({ page }) => {
  await openTest(page);
  await scenario(page).selectOption('drape');
  await expect(page.getByText('Falls onto a ball.')).toBeVisible();
  await page.getByLabel('Held in place').selectOption('corners');
  await expect(page.getByText('Falls as far as its pins allow.')).toBeVisible();
  await expect(page.getByText('Falls onto a ball.')).toHaveCount(0);
});

test('a narrow screen shows the step in one column', { tag: '@full' }, async ({ browser, baseURL }) => {
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
  test(
    `the step passes axe with everything open in the ${colorScheme} scheme`,
    { tag: colorScheme === 'dark' ? '@full' : [] },
    async ({ browser, baseURL }) => {
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
    },
  );
