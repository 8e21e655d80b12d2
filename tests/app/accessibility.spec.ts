import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import { goTo, openPage } from './page';

for (const colorScheme of ['light', 'dark'] as const)
  test(`every step passes axe in the ${colorScheme} scheme`, async ({ browser, baseURL }) => {
    // With reduced motion the pictures stand still, so that axe sees colours that do not change.
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
