/** Undo and Redo of what the user wants: the settings, with pins and paint among them, and the kept faces. */

import { batch, effect, signal, untracked } from '@preact/signals';
import type { Settings } from '../../engine/settings/options';
import { wants } from './store';

interface Wanted {
  settings: Settings;
  faces: number | null;
}

/** Changes of one control that follow each other within this time are one, so that a slider is undone as a whole. */
const TOGETHER_MILLISECONDS = 700;
const MOST_STEPS = 200;
/** Changes of these settings are never joined: each stroke and each pin is undone alone. */
const SINGLE = new Set(['pins', 'paint', 'lock']);

const past = signal<Wanted[]>([]);
const future = signal<Wanted[]>([]);
let present: Wanted = currentWants();
let last = { what: '', at: 0 };
let isIgnoring = false;

export const canUndo = () => past.value.length > 0;
export const canRedo = () => future.value.length > 0;

/** Starts to record changes. */
export function startUndo(): void {
  effect(() => {
    const next = { settings: wants.settings.value, faces: wants.faces.value };
    untracked(() => remember(next));
  });
}

/** Forgets all changes, as they do not fit another file or body. */
export function forgetUndo(): void {
  batch(() => {
    past.value = [];
    future.value = [];
  });
  present = currentWants();
  last = { what: '', at: 0 };
}

export const undo = (): void => step(past, future);
export const redo = (): void => step(future, past);

function step(from: typeof past, to: typeof past): void {
  const target = from.value.at(-1);
  if (!target) return;
  batch(() => {
    from.value = from.value.slice(0, -1);
    to.value = [...to.value, present];
    present = target;
    last = { what: '', at: 0 };
    wants.settings.value = target.settings;
    wants.faces.value = target.faces;
  });
}

/** Changes within `make` are not the user's: they become part of the change before them. */
export function withoutUndo(make: () => void): void {
  isIgnoring = true;
  make();
  isIgnoring = false;
}

function remember(next: Wanted): void {
  const what = differing(present, next).join(' ');
  if (what === '') return;
  const before = present;
  present = next;
  if (isIgnoring) return;
  const now = performance.now();
  const isGoingOn = what === last.what && !SINGLE.has(what) && now - last.at < TOGETHER_MILLISECONDS;
  last = { what, at: now };
  if (isGoingOn && past.value.length > 0) return;
  batch(() => {
    past.value = [...past.value, before].slice(-MOST_STEPS);
    future.value = [];
  });
}

/** The names of the settings that differ, and 'faces'. */
function differing(a: Wanted, b: Wanted): string[] {
  const keys = Object.keys(b.settings) as (keyof Settings)[];
  const changed: string[] = keys.filter((key) => String(a.settings[key]) !== String(b.settings[key]));
  return a.faces === b.faces ? changed : [...changed, 'faces'];
}

function currentWants(): Wanted {
  return { settings: wants.settings.peek(), faces: wants.faces.peek() };
}
