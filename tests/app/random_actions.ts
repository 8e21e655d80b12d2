/** Seeded random actions of a user, one after the other. */

import type { Page } from '@playwright/test';
import { combObj, sheetObj } from './meshes';
import { drop, goTo, keptFaces, writeScratch } from './page';

export type Random = () => number;

/** Numbers in [0, 1) (Mulberry32). */
export function seeded(seed: number): Random {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

const pick = <T>(random: Random, from: readonly T[]): T => from[Math.floor(random() * from.length)];

/** Returns whether the action was possible on the page. */
type Action = (page: Page, random: Random) => Promise<boolean>;

const STEPS = ['Model', 'Motion', 'Reduce', 'Test'] as const;
const KEYS = ['w', 'b', 'v', 'f', ' ', '1', '2', '3', '[', ']', 'ArrowLeft', 'ArrowRight', 'Escape'];
const files = () => [
  writeScratch('sheet-8.obj', sheetObj(8)),
  writeScratch('sheet-24.obj', sheetObj(24)),
  writeScratch('comb.obj', combObj()),
  writeScratch('nothing.obj', 'v 0 0 0\n'),
];

async function slide(page: Page, random: Random): Promise<boolean> {
  await goTo(page, 'Reduce');
  const slider = keptFaces(page).or(page.getByRole('slider', { name: 'Kept faces of the scene' }));
  await slider.and(page.locator(':enabled')).waitFor({ timeout: 2000 });
  const [low, high] = [await slider.getAttribute('min'), await slider.getAttribute('max')].map(Number);
  for (let move = 0; move < 5; move++)
    await slider.fill(String(Math.round(low + random() * (high - low))), { timeout: 1000 });
  return true;
}

async function chooseMode(page: Page, random: Random): Promise<boolean> {
  await goTo(page, 'Motion');
  return clickOne(page, '.mode-card button.mode', random);
}

/** Clicks one of the visible elements; false if there is none. */
async function clickOne(page: Page, selector: string, random: Random): Promise<boolean> {
  const shown = await page.locator(selector).filter({ visible: true }).all();
  if (shown.length === 0) return false;
  await pick(random, shown).click({ timeout: 1000 });
  return true;
}

async function pinText(page: Page, random: Random): Promise<boolean> {
  await goTo(page, 'Motion');
  const field = page.getByRole('textbox', { name: 'Held in place, as text' });
  if (!(await field.isVisible())) return false;
  await field.fill(pick(random, ['low:6', 'high:3', '', 'low:2 + high:2']), { timeout: 1000 });
  await field.press('Enter');
  return true;
}

async function turn(page: Page, random: Random): Promise<boolean> {
  const box = await page.locator('.viewport canvas').boundingBox();
  if (!box) return false;
  const place = () =>
    [box.x + box.width * (0.2 + 0.6 * random()), box.y + box.height * (0.2 + 0.6 * random())] as const;
  await page.mouse.move(...place());
  await page.mouse.down();
  await page.mouse.move(...place(), { steps: 3 });
  await page.mouse.up();
  await page.mouse.wheel(0, 200 * (random() - 0.5));
  return true;
}

/** Opens the export, saves if it is soon ready, and closes it. */
async function exportFile(page: Page): Promise<boolean> {
  await page.keyboard.press('Control+e');
  const save = page.locator('button').filter({ hasText: 'Save .glb' });
  try {
    await save.and(page.locator(':enabled')).click({ timeout: 4000 });
    return true;
  } catch {
    return false;
  } finally {
    await page.keyboard.press('Control+e');
  }
}

const press =
  (key: string): Action =>
  async (page) => {
    await page.keyboard.press(key);
    return true;
  };

/** Each action with its relative frequency. */
export const ACTIONS: Record<string, { weight: number; act: Action }> = {
  step: { weight: 5, act: (page, random) => goTo(page, pick(random, STEPS)).then(() => true) },
  slider: { weight: 8, act: slide },
  mode: { weight: 4, act: chooseMode },
  look: { weight: 4, act: (page, random) => clickOne(page, '.legend .choice button', random) },
  option: { weight: 3, act: (page, random) => clickOne(page, '.panel.right .choice button', random) },
  pins: { weight: 2, act: pinText },
  key: { weight: 5, act: (page, random) => press(pick(random, KEYS))(page, random) },
  undo: { weight: 3, act: press('Control+z') },
  redo: { weight: 2, act: press('Control+y') },
  camera: { weight: 4, act: turn },
  drop: { weight: 1, act: (page, random) => drop(page, pick(random, files())).then(() => true) },
  export: { weight: 1, act: exportFile },
};

/** Takes one action, which may be impossible on the page; returns its name and whether it was taken. */
export async function takeAction(page: Page, random: Random): Promise<{ name: string; isTaken: boolean }> {
  const all = Object.entries(ACTIONS);
  let left = random() * all.reduce((sum, [, { weight }]) => sum + weight, 0);
  const [name, { act }] = all.find(([, { weight }]) => (left -= weight) < 0) ?? all[0];
  // The target of a click may vanish, because the page continues to work.
  const isTaken = await act(page, random).catch((error: unknown) => {
    if (page.isClosed() || !(error instanceof Error) || error.name !== 'TimeoutError') throw error;
    return false;
  });
  await page.waitForTimeout(30 + 120 * random());
  return { name, isTaken };
}
