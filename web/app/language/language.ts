/** The language of the page: that of the browser unless the user has chosen one. English needs no table, because its sentences are the keys. */

import { effect, signal } from '@preact/signals';
import type { MessageTable } from './message_table';

export type Language = 'en' | 'ja';

const STORE = 'limber-language';
const NO_TABLE: MessageTable = {};

/** Each table is a chunk of its own, loaded when it is first needed and cached for use offline. */
const LOADERS: Record<Language, () => Promise<MessageTable>> = {
  en: () => Promise.resolve(NO_TABLE),
  ja: () => import('./japanese/table').then(({ JAPANESE }) => JAPANESE),
};

/** The language in which the page is shown. It changes once the table of a chosen language is loaded. */
export const shown = signal<{ language: Language; table: MessageTable }>({ language: 'en', table: NO_TABLE });

const isLanguage = (word: string | null): word is Language => word === 'en' || word === 'ja';

/** The first of the preferred languages, as BCP 47 tags, that the page supports; English if it supports none. */
export function preferredLanguage(tags: readonly string[]): Language {
  const known = tags.map((tag) => tag.split('-')[0].toLowerCase()).find(isLanguage);
  return known ?? 'en';
}

/** A browser may refuse access to its storage; then every visit counts as the first one. */
function remembered(): Language | null {
  try {
    const word = localStorage.getItem(STORE);
    return isLanguage(word) ? word : null;
  } catch {
    return null;
  }
}

let wanted: Language = 'en';

async function show(language: Language): Promise<void> {
  wanted = language;
  const table = await LOADERS[language]();
  if (wanted === language) shown.value = { language, table };
}

/** Shows the page in another language, without a reload, and on later visits. A table that cannot be loaded changes nothing. */
export async function chooseLanguage(language: Language): Promise<void> {
  await show(language);
  try {
    localStorage.setItem(STORE, language);
  } catch {
    // see `remembered`
  }
}

/** Starts with the remembered language, or with the browser's. */
export async function startLanguage(): Promise<void> {
  effect(() => {
    document.documentElement.lang = shown.value.language;
  });
  // Without its table the page is in English.
  await show(remembered() ?? preferredLanguage(navigator.languages)).catch(() => {});
}
