import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import type { Page } from '@playwright/test';

/** Names, symbols, keys, units and file formats are the same in every language. */
const SAME = new Set(
  'Limber limber EN QEM meshoptimizer Hausdorff Green Lagrange alpha gamma omega phi pi Home Tab Enter KHR EXT mesh quantization compression draco like input none quantized GLB glTF OBJ STL PLY OFF ZIP UV MatCap LOD Hz kB MB ms Pa kg km mm Esc Shift Space Ctrl XPBD Khronos glb zip JSON CSV Markdown meshopt Draco Jolt MuJoCo Newton Blender Discrete Shells bar low high box attribute vertices COOP COEP'.split(
    ' ',
  ),
);

/** Words in Latin letters in visible or spoken text. The command line and messages of the validator are English. */
async function latinWords(page: Page): Promise<string[]> {
  const texts = await page.evaluate(() => {
    const shown = [...document.querySelectorAll<HTMLElement>('body *')].filter(
      (element) => !element.closest('code, .hidden') && element.checkVisibility(),
    );
    const own = shown.flatMap((element) =>
      [...element.childNodes]
        .filter((node) => node.nodeType === Node.TEXT_NODE)
        .map((node) => node.textContent ?? ''),
    );
    const names = shown.flatMap((element) =>
      ['aria-label', 'aria-valuetext', 'title'].map((name) => element.getAttribute(name) ?? ''),
    );
    return [...own, ...names];
  });
  const words = texts.flatMap((text) => text.match(/[A-Za-z]{2,}/g) ?? []);
  return [...new Set(words)].filter((word) => !SAME.has(word));
}

/** Elements whose text is cut off, and the page where it is wider than its window. */
const cutOff = (page: Page): Promise<string[]> =>
  page.evaluate(() => {
    const isCut = (element: Element) => element.scrollWidth > element.clientWidth + 1;
    const shown = [
      ...document.querySelectorAll<HTMLElement>('button, label, h1, h2, h3, dt, summary, .hint'),
    ];
    const cut = shown.filter(
      (element) => element.checkVisibility() && element.clientWidth > 0 && isCut(element),
    );
    const wide = document.documentElement.scrollWidth > innerWidth ? ['the page'] : [];
    return [...wide, ...cut.map((element) => element.innerText)];
  });

async function expectJapanese(page: Page, name: string): Promise<void> {
  await expect(page.locator('.notice.busy')).toHaveCount(0, { timeout: 60_000 });
  if (process.env.PICTURES) await page.screenshot({ path: `${process.env.PICTURES}/${name}.png` });
  expect.soft(await latinWords(page)).toEqual([]);
  expect.soft(await cutOff(page)).toEqual([]);
  const { violations } = await new AxeBuilder({ page }).analyze();
  expect
    .soft(violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(' ')}`))
    .toEqual([]);
}

for (const [width, height] of [
  [1440, 900],
  [390, 844],
])
  test(
    `the four steps are in Japanese at ${width} px`,
    { tag: width === 390 ? [] : '@full' },
    async ({ browser, baseURL }) => {
      test.setTimeout(120_000);
      const context = await browser.newContext({
        baseURL,
        locale: 'ja-JP',
        viewport: { width, height },
        reducedMotion: 'reduce',
      });
      const page = await context.newPage();
      await page.goto('/');
      await expect(page.locator('html')).toHaveAttribute('lang', 'ja');
      await expect(page.getByRole('heading', { name: '三角形を減らしても、動きはそのまま' })).toBeVisible();
      await expectJapanese(page, `${width}-start`);
      await page.goto('/?sample=bar');
      await expect(page.locator('.readouts')).toContainText('1,792');
      for (const step of ['モデル', 'モーション', '削減', 'テスト']) {
        await page.getByRole('navigation', { name: 'ステップ' }).getByRole('button', { name: step }).click();
        if (step === 'モーション') await expect(page.locator('.mode-card').first()).toBeVisible();
        if (step === '削減') await expect(page.locator('.readouts')).toContainText('トポロジー');
        await expectJapanese(page, `${width}-${step}`);
      }
      await page.getByRole('button', { name: '書き出し', exact: true }).click();
      await expect(page.getByRole('button', { name: '.glb を保存' })).toBeEnabled();
      await expectJapanese(page, `${width}-export`);
      await page.getByRole('button', { name: 'ヘルプ' }).click();
      await expectJapanese(page, `${width}-help`);
      await context.close();
    },
  );

test('the language changes by keyboard without a reload, and is remembered', async ({ page }) => {
  await page.goto('/');
  const choice = page.locator('.start').getByRole('button', { name: '日本語' });
  await choice.focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('html')).toHaveAttribute('lang', 'ja');
  await expect(page.getByRole('heading', { name: '三角形を減らしても、動きはそのまま' })).toBeVisible();
  await page.reload();
  await expect(page.getByRole('heading', { name: '三角形を減らしても、動きはそのまま' })).toBeVisible();
  await page.locator('.start').getByRole('button', { name: 'EN' }).click();
  await expect(page.getByRole('heading', { name: 'Fewer triangles that still move right' })).toBeVisible();
  await expect(page.locator('html')).toHaveAttribute('lang', 'en');
});
