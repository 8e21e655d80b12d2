/** The stored state of a tab apart from its files, as a text. It is checked when read, because it may be damaged or from another version. */

import { readLink } from './link';
import type { FieldName, Layout, Step } from './store';
import type { UndoText } from './undo';

export interface Saved {
  link: string;
  step: Step;
  layout: Layout;
  field: FieldName;
  undo: UndoText;
  /** whether several models are queued */
  hasQueue: boolean;
  /** The record of the files has the same value, so that they are never restored with the settings of other files; '' in earlier versions. */
  open: string;
}

const STEPS: readonly Step[] = ['model', 'motion', 'reduce', 'test'];
const LAYOUTS: readonly Layout[] = ['both', 'slider', 'original', 'optimized'];
const FIELDS: readonly FieldName[] = ['none', 'strain', 'curvature'];

/** Stores the text; a storage that is too full keeps fewer steps of undo, and at worst no text at all. */
export function storeSaved(
  storage: Pick<Storage, 'setItem' | 'removeItem'>,
  key: string,
  saved: Saved,
): void {
  const { past, future } = saved.undo;
  try {
    storage.setItem(key, JSON.stringify(saved));
  } catch {
    if (past.length + future.length === 0) storage.removeItem(key);
    else storeSaved(storage, key, { ...saved, undo: { past: newerHalf(past), future: newerHalf(future) } });
  }
}

const newerHalf = (steps: string[]): string[] => steps.slice(Math.ceil(steps.length / 2));

/** Removes the texts, whose keys are `prefix` and the name of a tab, of all tabs but these. */
export function forgetTexts(
  storage: Pick<Storage, 'length' | 'key' | 'removeItem'>,
  prefix: string,
  kept: ReadonlySet<string>,
): void {
  const keys = Array.from({ length: storage.length }, (_, i) => storage.key(i) ?? '');
  for (const key of keys)
    if (key.startsWith(prefix) && !kept.has(key.slice(prefix.length))) storage.removeItem(key);
}

/** Unknown values become the first of their kind; steps of undo that cannot be read are dropped. Throws an Error. */
export function readSaved(text: string): Saved {
  const { link, step, layout, field, undo, hasQueue, open } = objectOf(JSON.parse(text));
  if (typeof link !== 'string') throw new Error('The saved text has no settings.');
  const { past, future } = objectOf(undo ?? {});
  return {
    link,
    step: oneOf(STEPS, step),
    layout: oneOf(LAYOUTS, layout),
    field: oneOf(FIELDS, field),
    undo: { past: linksOf(past), future: linksOf(future) },
    hasQueue: hasQueue === true,
    open: typeof open === 'string' ? open : '',
  };
}

const oneOf = <Word extends string>(known: readonly Word[], value: unknown): Word =>
  known.find((word) => word === value) ?? known[0];

function linksOf(value: unknown): string[] {
  return Array.isArray(value) ? value.filter((text): text is string => isLink(text)) : [];
}

function isLink(text: unknown): boolean {
  if (typeof text !== 'string') return false;
  try {
    readLink(text);
    return true;
  } catch {
    return false;
  }
}

function objectOf(value: unknown): Record<string, unknown> {
  if (typeof value === 'object' && value !== null) return value as Record<string, unknown>;
  throw new Error('The saved text is no object.');
}
