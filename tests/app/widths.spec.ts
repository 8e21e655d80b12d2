import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';
import { drop, goTo, keptFaces, openPage, readout, SPEED_UP, writeScratch } from './page';
import { standingTubes } from './scenes';

const WINDOWS = [
  { width: 1440, height: 900, colorScheme: 'light' },
  { width: 1024, height: 700, colorScheme: 'dark' },
  { width: 820, height: 1180, colorScheme: 'light' },
  { width: 390, height: 844, colorScheme: 'dark' },
  // 1024 x 700 at 150 %
  { width: 683, height: 467, colorScheme: 'light' },
] as const;

async function expectInside(page: Page): Promise<void> {
  const { width, height } = page.viewportSize()!;
  const box = (await page.getByRole('button', { name: 'Export', exact: true }).boundingBox())!;
  expect(box.x).toBeGreaterThanOrEqual(0);
  expect(box.y).toBeGreaterThanOrEqual(0);
  expect(box.x + box.width).toBeLessThanOrEqual(width);
  expect(box.y + box.height).toBeLessThanOrEqual(height);
  const canvas = (await page.locator('.viewport canvas').boundingBox())!;
  expect(canvas.height).toBeGreaterThan(60);
  const size = await page.evaluate(() => {
    const { scrollWidth, scrollHeight } = document.documentElement;
    return { scrollWidth, scrollHeight };
  });
  expect(size.scrollWidth).toBeLessThanOrEqual(width);
  expect(size.scrollHeight).toBeLessThanOrEqual(height);
}

for (const { width, height, colorScheme } of WINDOWS)
  test(
    `at ${width} x ${height} everything stays within reach in the ${colorScheme} scheme`,
    { tag: width === 390 || width === 1024 ? [] : '@full' },
    async ({ browser, baseURL }) => {
      const context = await browser.newContext({
        baseURL,
        colorScheme,
        viewport: { width, height },
        reducedMotion: 'reduce',
      });
      const page = await context.newPage();
      await openPage(page);
      for (const step of ['Model', 'Motion', 'Reduce', 'Test'] as const) {
        await goTo(page, step);
        await expectInside(page);
        const { violations } = await new AxeBuilder({ page }).analyze();
        expect(
          violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(' ')}`),
        ).toEqual([]);
      }
      await page.getByRole('button', { name: 'Export', exact: true }).click();
      await expect(page.getByRole('button', { name: 'Save .glb' })).toBeEnabled();
      await expectInside(page);
      await context.close();
    },
  );

test('on a phone no label of a mesh lies under the choice of the view', async ({ browser, baseURL }) => {
  const context = await browser.newContext({
    baseURL,
    viewport: { width: 390, height: 844 },
    reducedMotion: 'reduce',
  });
  const page = await context.newPage();
  await openPage(page);
  await goTo(page, 'Reduce');
  await expect(readout(page, 'Faces')).toContainText('→ 896');
  const choice = (await page.locator('.compare').boundingBox())!;
  const canvas = (await page.locator('.viewport canvas').boundingBox())!;
  const views = page.getByRole('group', { name: 'Compare' }).getByRole('button');
  for (const view of await views.all()) {
    await view.click();
    for (const label of await page.locator('.pane-labels > span').all()) {
      const box = (await label.boundingBox())!;
      expect(box.y).toBeGreaterThanOrEqual(choice.y + choice.height);
      // A framed body leaves a tenth of the picture free at the top.
      expect(box.y + box.height).toBeLessThanOrEqual(canvas.y + 0.1 * canvas.height + 1);
    }
  }
  await context.close();
});

test('on a phone the picture has room in every step, and the marks of the slider are whole', async ({
  page,
}) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.setViewportSize({ width: 390, height: 844 });
  await openPage(page);
  for (const step of ['Motion', 'Reduce', 'Test'] as const) {
    await goTo(page, step);
    await expect(page.getByText('Finding modes')).toHaveCount(0);
    await expect(async () => {
      expect((await page.locator('.viewport canvas').boundingBox())!.height).toBeGreaterThan(120);
    }).toPass();
    if (step !== 'Reduce') continue;
    // The only mark of the bar is at the left end.
    const mark = (await page.getByText('deviation 0.1 %').boundingBox())!;
    expect(mark.x).toBeGreaterThan(8);
    for (const name of ['Faces', 'Deviation', 'Topology'])
      await expect(readout(page, name).locator('strong')).toBeInViewport({ ratio: 1 });
  }
});

test('on a phone the look stands in the View menu, and the picture has its row', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.setViewportSize({ width: 1280, height: 844 });
  await openPage(page);
  await goTo(page, 'Reduce');
  await expect(page.getByLabel('Look')).toBeVisible();
  await page.setViewportSize({ width: 390, height: 844 });
  await expect(page.getByLabel('Look')).not.toBeVisible();
  await expect(async () => {
    const canvas = (await page.locator('.viewport canvas').boundingBox())!;
    expect(canvas.height).toBeGreaterThan(155);
    const legend = (await page.locator('.legend').boundingBox())!;
    expect(legend.y).toBeGreaterThanOrEqual(canvas.y + canvas.height - 1);
  }).toPass();
  await page.locator('.view-menu summary').click();
  await page.getByLabel('Look').selectOption({ label: 'Clay' });
  await expect(page.getByLabel('Look')).toHaveValue('clay');
});

test('a page at 200 % scrolls rather than cover the picture', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.setViewportSize({ width: 683, height: 384 });
  await openPage(page);
  for (const step of ['Motion', 'Reduce', 'Test'] as const) {
    await goTo(page, step);
    await expect(page.getByText('Finding modes')).toHaveCount(0);
    await expect(async () => {
      const canvas = (await page.locator('.viewport canvas').boundingBox())!;
      expect(canvas.height).toBeGreaterThan(100);
      const legend = (await page.locator('.legend').boundingBox())!;
      expect(legend.y).toBeGreaterThanOrEqual(canvas.y + canvas.height - 1);
    }).toPass({ timeout: 20_000 });
  }
  await page.locator('.readouts').scrollIntoViewIfNeeded();
  await expect(page.locator('.readouts')).toBeInViewport({ ratio: 0.9 });
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(683);
});

/** The texts of readouts that are truncated or covered by the progress box, and by how much the box moves the content above it. */
const hiddenByBusy = (page: Page): Promise<(string | number | null)[]> =>
  page.evaluate(() => {
    const line = document.querySelector('.foot-line')!;
    const before = line.getBoundingClientRect().height;
    line.querySelector('.busy')?.remove();
    const busy = document.createElement('div');
    busy.className = 'notice busy';
    busy.innerHTML =
      '<span class="what">Dressing the result</span><progress></progress><span>fitting 50 %</span><button>Cancel</button>';
    line.append(busy);
    const box = busy.getBoundingClientRect();
    const words = [...line.querySelectorAll('.readouts :is(dt, strong, span)')].filter((word) => {
      const { left, right, top, bottom } = word.getBoundingClientRect();
      const isUnder = right > box.left && left < box.right && bottom > box.top && top < box.bottom;
      return isUnder || right > innerWidth || word.scrollWidth > word.clientWidth + 1;
    });
    return [...words.map((word) => word.textContent), line.getBoundingClientRect().height - before];
  });

for (const { width, height } of [
  { width: 1440, height: 900 },
  { width: 820, height: 1100 },
])
  test(`at ${width} x ${height} all read-outs of a scene are seen whole, and what is running lies on none`, async ({
    page,
  }) => {
    await page.setViewportSize({ width, height });
    await openPage(page);
    await drop(page, writeScratch('tubes.glb', await standingTubes()));
    await goTo(page, 'Reduce');
    await expect(readout(page, 'Topology')).toContainText('handles');
    expect(await hiddenByBusy(page)).toEqual([0]);
  });

test('read-outs of the Test step are seen whole in one row, and what is running lies on none', async ({
  page,
}) => {
  await openPage(page);
  await goTo(page, 'Test');
  await expect(readout(page, 'Speed-up')).toContainText(SPEED_UP);
  await expect(readout(page, 'Stretch')).toContainText('optimized');
  await page.getByRole('button', { name: 'Pause', exact: true }).click();
  await expect(readout(page, 'Time')).toContainText('paused');
  // Texts have their maximum length here.
  const longest = [
    ['126.70 s', 'slow motion x0.35'],
    ['38.2 ms', '1.91\u00a0ms/substep'],
    ['0.510 ms', '25.5\u00a0µs/substep'],
    ['x0.982', 'too few faces'],
    ['0.0071 %', 'noise 0.0083 %'],
    ['< 0.001 %', 'optimized < 0.001 %'],
  ];
  await page.locator('.readouts dd').evaluateAll((numbers, words) => {
    numbers.forEach((number, i) =>
      [...number.children].forEach((part, k) => (part.textContent = words[i][k])),
    );
  }, longest);
  for (const width of [1280, 1366, 1440, 1920]) {
    await page.setViewportSize({ width, height: 768 });
    expect(await hiddenByBusy(page)).toEqual([0]);
    const rows = await page
      .locator('.readouts > div')
      .evaluateAll((all) => all.map((each) => each.getBoundingClientRect().top));
    expect(new Set(rows).size).toBe(1);
    const line = (await page.locator('.foot-line').boundingBox())!;
    expect(line.height).toBeLessThan(72);
    const busy = (await page.locator('.foot-line .busy').boundingBox())!;
    const legend = await page
      .locator('.chart figcaption > span')
      .evaluateAll((all) => Math.max(...all.map((each) => each.getBoundingClientRect().right)));
    expect(busy.x).toBeGreaterThanOrEqual(legend);
    const plot = (await page.locator('.plot svg').boundingBox())!;
    expect(busy.y + busy.height).toBeLessThanOrEqual(plot.y + 1);
    const stage = (await page.locator('.viewport canvas').boundingBox())!;
    expect(busy.y).toBeGreaterThanOrEqual(stage.y + stage.height);
  }
});

test('the settings of a step are shown from their top', async ({ page }) => {
  await page.setViewportSize({ width: 1366, height: 600 });
  await openPage(page);
  await goTo(page, 'Reduce');
  const panel = page.locator('.panel.right');
  await expect(keptFaces(page)).toBeEnabled();
  await panel.evaluate((box) => box.scrollTo(0, 9999));
  expect(await panel.evaluate((box) => box.scrollTop)).toBeGreaterThan(0);
  await goTo(page, 'Test');
  await expect(panel).toContainText('Scenario');
  expect(await panel.evaluate((box) => box.scrollTop)).toBe(0);
});

test('the gallery fades where it goes on, and not over its last card', async ({ page }) => {
  await page.setViewportSize({ width: 1366, height: 768 });
  await openPage(page);
  await goTo(page, 'Motion');
  const gallery = page.locator('.gallery');
  await expect(gallery.locator('.mode-card')).toHaveCount(12);
  const fade = () =>
    gallery.evaluate((list) => {
      const { width } = getComputedStyle(list, '::after');
      const right = Math.min(innerWidth, list.getBoundingClientRect().right);
      const last = list.querySelector('.mode-card:last-of-type')!.getBoundingClientRect();
      return { free: right - last.right, width: Number.parseFloat(width) };
    });
  expect((await fade()).free).toBeLessThan(0);
  await gallery.evaluate((list) => list.scrollTo(9999, 0));
  const { free, width } = await fade();
  expect(width).toBeGreaterThan(0);
  expect(free).toBeGreaterThanOrEqual(width);
});

test('the legend lies below the picture where it takes two rows', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.setViewportSize({ width: 930, height: 700 });
  await openPage(page);
  await goTo(page, 'Motion');
  await expect(page.getByText('Strain rank')).toBeVisible();
  for (const [width, height] of [
    [930, 700],
    [768, 1024],
    [390, 844],
  ]) {
    await page.setViewportSize({ width, height });
    await expect(async () => {
      const canvas = (await page.locator('.viewport canvas').boundingBox())!;
      const legend = (await page.locator('.legend').boundingBox())!;
      expect(canvas.y + canvas.height).toBeLessThanOrEqual(legend.y + 1);
      expect(legend.width).toBeLessThanOrEqual(canvas.width);
    }).toPass({ timeout: 10_000 });
  }
});

test('a finger turns the picture, and two zoom', { tag: '@full' }, async ({ browser, baseURL }) => {
  const context = await browser.newContext({
    baseURL,
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    isMobile: true,
    reducedMotion: 'reduce',
  });
  const page = await context.newPage();
  await openPage(page);
  const canvas = page.locator('.viewport canvas');
  await page.waitForTimeout(500);
  const box = (await canvas.boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const client = await context.newCDPSession(page);
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', points: [number, number][]) =>
    client.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: points.map(([px, py], id) => ({ x: px, y: py, id })),
    });
  const picture = async () => {
    await page.waitForTimeout(700);
    return (await canvas.screenshot()).toString('base64');
  };
  const before = await picture();
  await touch('touchStart', [[x - 60, y]]);
  for (const dx of [-30, 0, 30, 60]) await touch('touchMove', [[x + dx, y]]);
  await touch('touchEnd', []);
  const turned = await picture();
  expect(turned).not.toBe(before);
  const pair = (spread: number): [number, number][] => [
    [x - spread, y],
    [x + spread, y],
  ];
  await touch('touchStart', pair(20));
  for (const spread of [35, 50, 70]) await touch('touchMove', pair(spread));
  await touch('touchEnd', []);
  expect(await picture()).not.toBe(turned);
  await context.close();
});

test('the picture turns and pins by keyboard alone', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await openPage(page);
  await goTo(page, 'Motion');
  const canvas = page.locator('.viewport canvas');
  await canvas.focus();
  await page.waitForTimeout(700);
  const before = await canvas.screenshot();
  for (let i = 0; i < 4; i++) await page.keyboard.press('ArrowRight');
  await page.waitForTimeout(700);
  expect((await canvas.screenshot()).equals(before)).toBe(false);
  await page.getByRole('button', { name: /pick/i }).first().press('Enter');
  await canvas.focus();
  const mark = page.locator('.middle-mark');
  await expect(mark).toBeVisible();
  const [marked, seen] = [(await mark.boundingBox())!, (await canvas.boundingBox())!];
  expect(Math.abs(marked.x + marked.width / 2 - seen.x - seen.width / 2)).toBeLessThan(2);
  expect(Math.abs(marked.y + marked.height / 2 - seen.y - seen.height / 2)).toBeLessThan(2);
  await page.keyboard.press('Enter');
  await expect(page.getByText(/^[1-9]\d* of [\d,]+ vertices\.$/)).toBeVisible();
});

test('a result is spoken once it has settled', async ({ page }) => {
  await openPage(page);
  await goTo(page, 'Reduce');
  await expect(readout(page, 'Deviation')).not.toContainText('...');
  await expect(page.locator('p.spoken').filter({ hasText: 'Topology' })).toHaveText(
    /^[\d,]+ of 1,792 faces, deviation [\d.]+ %, smallest angle [\d.]+ degrees\. Topology kept\.$/,
  );
});
