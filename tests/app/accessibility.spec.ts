import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import { goTo, keptFaces, openPage } from './page';

test('the help takes the focus, and Escape closes it alone and gives the focus back', async ({ page }) => {
  await openPage(page);
  await goTo(page, 'Motion');
  const pick = page.getByRole('button', { name: 'Pick', exact: true });
  await pick.click();
  await expect(pick).toHaveAttribute('aria-pressed', 'true');
  await page.keyboard.press('?');
  await expect(page.getByRole('heading', { name: 'Keys' })).toBeFocused();
  await page.keyboard.press('Escape');
  await expect(page.locator('.help')).toHaveCount(0);
  await expect(pick).toBeFocused();
  await expect(pick).toHaveAttribute('aria-pressed', 'true');
});

test('Export takes the focus, and gives it back unless it has gone elsewhere', async ({ page }) => {
  await openPage(page);
  await goTo(page, 'Reduce');
  const slider = keptFaces(page);
  const heading = page.getByRole('heading', { name: 'Export', exact: true });
  await expect(slider).toBeEnabled();
  await slider.focus();
  await page.keyboard.press('Control+e');
  await expect(heading).toBeFocused();
  await page.keyboard.press('Tab');
  await expect(page.getByRole('button', { name: 'Close the export panel' })).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(heading).toHaveCount(0);
  await expect(slider).toBeFocused();
  await page.keyboard.press('Control+e');
  await expect(heading).toBeFocused();
  const help = page.getByRole('button', { name: 'Help' });
  await help.focus();
  await page.keyboard.press('Control+e');
  await expect(heading).toHaveCount(0);
  await expect(help).toBeFocused();
  await page.keyboard.press('Control+e');
  await expect(heading).toBeFocused();
  await page.keyboard.press('Escape');
  await expect(heading).toHaveCount(0);
  await expect(help).toBeFocused();
});

test('a picture that is saved by keyboard leaves the focus at its button, and Escape closes the pictures', async ({
  page,
}) => {
  await openPage(page);
  await page.getByRole('button', { name: 'Pictures', exact: true }).click();
  await expect(page.getByRole('heading', { name: 'Pictures' })).toBeFocused();
  const save = page.getByRole('button', { name: 'Save PNG' });
  await Promise.all([page.waitForEvent('download'), save.press('Enter')]);
  await expect(save).toBeFocused();
  await page.locator('body').evaluate(() => (document.activeElement as HTMLElement).blur());
  await page.keyboard.press('Escape');
  await expect(page.locator('.pictures')).toHaveCount(0);
});

for (const [opener, closer] of [
  ['Compare methods', 'Close the comparison'],
  ['Pictures', 'Close the pictures'],
])
  test(`${opener} takes the focus, and gives it back`, async ({ page }) => {
    await openPage(page);
    await goTo(page, 'Reduce');
    const button = page.getByRole('button', { name: opener, exact: true });
    await expect(button).toBeEnabled();
    for (const leave of [
      () => page.getByRole('button', { name: closer }).press('Enter'),
      () => page.keyboard.press('Escape'),
    ]) {
      await button.press('Enter');
      await expect(page.locator('.panel-head h2')).toBeFocused();
      await leave();
      await expect(page.locator('.panel-head h2')).toHaveCount(0);
      await expect(button).toBeFocused();
    }
  });

for (const colorScheme of ['light', 'dark'] as const)
  test(`every step passes axe in the ${colorScheme} scheme`, async ({ browser, baseURL }) => {
    // With reduced motion the pictures are not animated, so that axe sees constant colours.
    const context = await browser.newContext({ baseURL, colorScheme, reducedMotion: 'reduce' });
    const page = await context.newPage();
    await openPage(page);
    const violations = async () => {
      const { violations: found } = await new AxeBuilder({ page }).analyze();
      return found.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(' ')}`);
    };
    for (const step of ['Model', 'Motion', 'Reduce', 'Test'] as const) {
      await goTo(page, step);
      await expect(page.locator('.notice.busy')).toHaveCount(0);
      expect(await violations()).toEqual([]);
    }
    await page.getByRole('button', { name: 'Export', exact: true }).click();
    await expect(page.getByText('No errors')).toBeVisible();
    expect(await violations()).toEqual([]);
    await page.getByRole('button', { name: 'Help' }).click();
    expect(await violations()).toEqual([]);
    await context.close();
  });

test('the number of a step goes to it once a model is open, and C colours what is shown', async ({
  page,
}) => {
  const current = page.getByRole('navigation', { name: 'Steps' }).locator('[aria-current]');
  const colour = page.getByRole('group', { name: 'Colour by' }).locator('[aria-pressed=true]');
  await page.goto('/');
  await expect(page.getByRole('heading', { name: 'Fewer triangles that still move right' })).toBeVisible();
  await page.keyboard.press('4');
  await openPage(page);
  await expect(current).toContainText('Model');
  await page.keyboard.press('2');
  await expect(current).toContainText('Motion');
  await expect(colour).toHaveText('Strain');
  await page.keyboard.press('c');
  await expect(colour).toHaveText('Curvature');
  await page.keyboard.press('4');
  await expect(current).toContainText('Test');
  await page.keyboard.press('c');
  await expect(colour).toHaveText('Deviation');
  await page.keyboard.press('3');
  await expect(current).toContainText('Reduce');
});
