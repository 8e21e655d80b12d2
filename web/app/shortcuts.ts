/** The keyboard shortcuts outside text fields. */

import { scrolls } from './controls/scroll_keys';
import { pickFiles } from './files/files';
import { pictures } from './panels/pictures/pictures_state';
import { FIELD_NAMES } from './panels/viewport/legend';
import { isWireShown } from './panels/viewport/show_bodies';
import { viewportHandle } from './panels/viewport/viewport_view';
import { cancelRunning } from './state/runner';
import { reset, stepOnce } from './state/simulation';
import { twin } from './state/twin';
import { redo, undo } from './state/undo';
import {
  chooseField,
  isBrushing,
  isPicking,
  isSharing,
  keepFaces,
  results,
  shownField,
  slider,
  view,
  wants,
} from './state/store';
import type { Step } from './state/store';
import { goToStep, STEP_NAMES } from './state/steps/steps';
import { blink, LAYOUT_NAMES } from './panels/reduce/compare';
import { BRUSH_RADIUS } from './panels/reduce/brush_section';

const PLAIN: Record<string, () => void> = {
  ' ': playOrPause,
  f: () => viewportHandle.current?.fit('here'),
  w: () => (view.wire.value = !isWireShown()),
  ...Object.fromEntries(STEP_NAMES.map((step, i) => [`${i + 1}`, () => toStep(step)])),
  c: () => chooseField(FIELD_NAMES[(FIELD_NAMES.indexOf(shownField.value) + 1) % FIELD_NAMES.length]),
  b: blink,
  v: () =>
    (view.layout.value = LAYOUT_NAMES[(LAYOUT_NAMES.indexOf(view.layout.value) + 1) % LAYOUT_NAMES.length]),
  arrowleft: () => stepFaces(-1),
  arrowright: () => stepFaces(1),
  escape: () => {
    if (view.helpOpen.value) view.helpOpen.value = false;
    else if (pictures.isOpen.value) pictures.isOpen.value = false;
    else if (wants.exportOpen.value) wants.exportOpen.value = false;
    else if (isPicking.value) view.picking.value = false;
    else if (view.hover.value) view.hover.value = null;
    else if (isBrushing.value) view.brush.value = { ...view.brush.value, tool: null };
    else cancelRunning();
  },
  '[': () => sizeBrush(1 / 1.25),
  ']': () => sizeBrush(1.25),
  '?': () => (view.helpOpen.value = !view.helpOpen.value),
};

function toStep(step: Step): void {
  if (results.file.value) goToStep(step);
}

/** Meshes rest on the Reduce step unless they are asked to swing. */
function playOrPause(): void {
  const { playing, swings, step } = view;
  if (step.value === 'reduce') swings.value = !swings.value;
  else playing.value = !playing.value;
}

/** The keys that differ on the Test step. */
const SIMULATE: Record<string, () => void> = {
  ' ': () => (twin.playing.value = !twin.playing.value),
  c: () => (twin.heat.value = !twin.heat.value),
  v: () => (twin.layout.value = twin.layout.value === 'beside' ? 'over' : 'beside'),
  d: () => (twin.driven.value = !twin.driven.value),
  arrowright: stepOnce,
  home: reset,
};

const plainAction = (key: string): (() => void) | undefined =>
  (view.step.value === 'test' ? SIMULATE[key] : undefined) ?? PLAIN[key];

const WITH_CONTROL: Record<string, () => void> = {
  z: undo,
  y: redo,
  o: () => void pickFiles(),
  e: () => {
    if (results.mesh.value) wants.exportOpen.value = !wants.exportOpen.value;
  },
};

/** A collapse removes one face at a border and two elsewhere, so a step of two faces always has an effect. */
function stepFaces(direction: number): void {
  const { isReady, fewest, faces, wanted } = slider.value;
  if (!isReady || view.step.value !== 'reduce') return;
  const ofBody = (results.mesh.value?.mesh.triangles.length ?? 0) / 3 || wanted;
  const shown = isSharing.value ? wanted : ofBody;
  keepFaces(Math.min(faces, Math.max(fewest, shown + 2 * direction)));
}

function sizeBrush(factor: number): void {
  const { value: brush } = view.brush;
  if (isBrushing.value)
    view.brush.value = {
      ...brush,
      radius: Math.min(BRUSH_RADIUS.max, Math.max(BRUSH_RADIUS.min, brush.radius * factor)),
    };
}

function isTyping(target: EventTarget | null): boolean {
  if (target instanceof HTMLSelectElement) return true;
  return target instanceof HTMLInputElement && !['checkbox', 'range'].includes(target.type);
}

/** Whether a slider handles this key itself. */
const isSliderKey = ({ target, key }: KeyboardEvent): boolean =>
  target instanceof HTMLInputElement && target.type === 'range' && /^(Arrow|Home|End|Page)/.test(key);

/** Whether a focused region scrolls by this key. */
const isScrollKey = ({ target, key }: KeyboardEvent): boolean =>
  target instanceof HTMLElement && target.matches('[tabindex="0"]') && scrolls(target, key);

/** Whether the target has an undo of its own. */
const hasOwnUndo = (target: EventTarget | null): boolean =>
  target instanceof HTMLInputElement && target.type === 'text';

export function listenToKeys(): void {
  addEventListener('keydown', (event) => {
    const key = event.key.toLowerCase();
    const hasControl = event.ctrlKey || event.metaKey;
    const withControl = event.shiftKey && key === 'z' ? redo : WITH_CONTROL[key];
    const action = hasControl ? withControl : plainAction(key);
    if (!action || event.altKey) return;
    if (isSliderKey(event) || isScrollKey(event)) return;
    const isOwn = hasControl ? hasOwnUndo(event.target) && 'zy'.includes(key) : isTyping(event.target);
    if (isOwn && key !== 'escape') return;
    // Space presses a focused button, except the one of the current step, which does nothing.
    if (
      key === ' ' &&
      event.target instanceof HTMLElement &&
      event.target.closest('button:not([aria-current]), summary, input, select')
    )
      return;
    event.preventDefault();
    action();
  });
}
