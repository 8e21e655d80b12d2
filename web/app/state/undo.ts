/**
 * Undo and Redo of the user's settings, including pins and paint, and the kept faces, also of single bodies. The whole
 * file has one undo history: a step shows the body again that was shown when the change was made.
 */

import { batch, effect, signal, untracked } from '@preact/signals';
import { defaultSettings } from '../../engine/settings/options';
import type { Settings } from '../../engine/settings/options';
import { readLink, writeLink } from './link';
import { refusedLock } from './locks';
import { ownFacesText } from './own_faces';
import type { OwnFaces } from './own_faces';
import { status, wants } from './store';

interface Wanted {
  settings: Settings;
  faces: number | null;
  own: OwnFaces;
}

interface UndoStep extends Wanted {
  /** the body that was shown when this was changed to the following state, or back */
  body: number;
}

/** Consecutive changes of one control within this time are merged, so that a slider motion is undone as a whole. */
const TOGETHER_MILLISECONDS = 700;
const MAX_STEPS = 200;
/** Changes of these settings are never joined: each stroke and each pin is undone alone. */
const SINGLE = new Set(['pins', 'paint', 'lock']);

const past = signal<UndoStep[]>([]);
const future = signal<UndoStep[]>([]);
let present: Wanted = currentWants();
const NO_CHANGE = { what: '', at: 0, body: 0 };
let last = NO_CHANGE;
let show: (body: number) => void = () => {};

/** The undo and redo steps as texts of links, the newest last. */
export interface UndoText {
  past: string[];
  future: string[];
}

/** Only so many steps survive a reload. */
const MAX_SAVED = 40;

/** Depends on the signals of everything that can be undone. */
export function readUndo(): UndoText {
  const texts = (steps: UndoStep[]): string[] => steps.slice(-MAX_SAVED).map(textOf);
  return { past: texts(past.value), future: texts(future.value) };
}

/** The texts are kept with the steps, because paint makes them long and every change saves all of them. */
const textOfStep = new WeakMap<UndoStep, string>();

function textOf(step: UndoStep): string {
  const text = textOfStep.get(step) ?? writeLink({ ...step, file: null });
  textOfStep.set(step, text);
  return text;
}

/** Must be called once the files of the steps are open. */
export function restoreUndo(saved: UndoText): void {
  const none = { settings: defaultSettings(), faces: null, own: new Map(), body: 0 };
  const steps = (texts: string[]): UndoStep[] => texts.map((text) => readLink(text) ?? none);
  batch(() => {
    past.value = steps(saved.past);
    future.value = steps(saved.future);
  });
}

export const canUndo = () => past.value.length > 0;
export const canRedo = () => future.value.length > 0;

/** Starts to record changes. `showBody` shows the body of a step that is undone or redone. */
export function startUndo(showBody: (body: number) => void): void {
  show = showBody;
  effect(() => {
    const next = { settings: wants.settings.value, faces: wants.faces.value, own: wants.own.value };
    untracked(() => remember(next));
  });
}

/** Forgets all changes, because they do not fit another file. */
export function forgetUndo(): void {
  batch(() => {
    past.value = [];
    future.value = [];
  });
  present = currentWants();
  last = NO_CHANGE;
}

export const undo = (): void => step(past, future);
export const redo = (): void => step(future, past);

function step(from: typeof past, to: typeof past): void {
  const target = from.value.at(-1);
  if (!target) return;
  batch(() => {
    from.value = from.value.slice(0, -1);
    to.value = [...to.value, { ...present, body: target.body }];
    present = target;
    last = NO_CHANGE;
    wants.settings.value = target.settings;
    wants.faces.value = target.faces;
    wants.own.value = target.own;
    forgetRefusals(target.settings);
    show(target.body);
  });
}

/** A refused text is not part of the current state, unless the pins are that text: then nothing else shows that it was refused. */
function forgetRefusals({ pins }: Settings): void {
  if (status.refusedPins.value?.text !== pins) status.refusedPins.value = null;
  refusedLock.value = null;
}

/** Changes within `make` are not the user's: they become part of the previous change, which is dropped if they revert it. */
export function withoutUndo(make: () => void): void {
  batch(() => {
    make();
    // The state recorded at the end of the batch then does not count as a change.
    present = currentWants();
    const before = past.value.at(-1);
    if (!before || differing(before, present).length > 0) return;
    past.value = past.value.slice(0, -1);
    last = NO_CHANGE;
  });
}

function remember(next: Wanted): void {
  const what = differing(present, next).join(' ');
  if (what === '') return;
  const body = wants.body.peek();
  const before = { ...present, body };
  present = next;
  const change = { what, at: performance.now(), body };
  const isGoingOn = !SINGLE.has(what) && follows(change, last);
  last = change;
  if (isGoingOn && past.value.length > 0) return;
  batch(() => {
    past.value = [...past.value, before].slice(-MAX_STEPS);
    future.value = [];
  });
}

const follows = (next: typeof last, before: typeof last): boolean =>
  next.what === before.what && next.body === before.body && next.at - before.at < TOGETHER_MILLISECONDS;

/** The names of the settings that differ, 'faces' and 'own'. */
function differing(a: Wanted, b: Wanted): string[] {
  const keys = Object.keys(b.settings) as (keyof Settings)[];
  const changed: string[] = keys.filter((key) => String(a.settings[key]) !== String(b.settings[key]));
  if (a.faces !== b.faces) changed.push('faces');
  if (ownFacesText(a.own) !== ownFacesText(b.own)) changed.push('own');
  return changed;
}

function currentWants(): Wanted {
  return { settings: wants.settings.peek(), faces: wants.faces.peek(), own: wants.own.peek() };
}
