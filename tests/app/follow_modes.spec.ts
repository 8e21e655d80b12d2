import { expect, test } from '@playwright/test';
import { goTo, openPage } from './page';

test('a chosen motion stays chosen under the number that pins give it', async ({ page }) => {
  await openPage(page);
  await goTo(page, 'Motion');
  const cards = page.getByRole('list', { name: 'Modes' }).locator('.mode');
  await expect(cards.first()).toContainText('Hz');
  const names = (await cards.allInnerTexts()).map((text) => text.replace(/\s+/g, ' '));
  const twist = names.findIndex((text) => text.includes('twist'));
  await cards.nth(twist).click();
  await expect(cards.nth(twist)).toHaveAttribute('aria-pressed', 'true');
  const text = page.getByRole('textbox', { name: 'Held in place, as text' });
  if (!(await text.isVisible())) await page.getByText('As text').click();
  await text.fill('low:6');
  await text.press('Enter');
  // Whatever its number, the pressed mode is a twist, or the page says that no mode moves like it any more.
  const pressed = page.locator('.gallery:not(.stale) .mode[aria-pressed="true"]');
  const notice = page.getByText(/With these pins/);
  await expect(async () => {
    const isTold = await notice.isVisible();
    const words = (await pressed.allInnerTexts()).join(' ');
    expect(isTold || (words.includes('twist') && (await pressed.count()) === 1)).toBe(true);
  }).toPass();
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(pressed).toHaveCount(1);
  await expect(cards.nth(twist)).toHaveAttribute('aria-pressed', 'true');
});
