/** What the keys do, away from text fields. */

import { pickFiles } from './files';
import { stageHandle } from './panels/stage_view';
import { cancelRunning } from './state/runner';
import { reset, stepOnce, twin } from './state/simulation';
import { isPicking, results, view, wantedFaces, wants } from './state/store';
import type { Layout } from './state/store';

const LAYOUTS: Layout[] = ['both', 'original', 'optimized'];

const PLAIN: Record<string, () => void> = {
  ' ': () => (view.playing.value = !view.playing.value),
  f: () => stageHandle.current?.fit(),
  w: () => (view.wire.value = !view.wire.value),
  '1': () => (view.field.value = 'none'),
  '2': () => (view.field.value = 'strain'),
  '3': () => (view.field.value = 'curvature'),
  b: () => (view.layout.value = view.layout.value === 'original' ? 'optimized' : 'original'),
  v: () => (view.layout.value = LAYOUTS[(LAYOUTS.indexOf(view.layout.value) + 1) % LAYOUTS.length]),
  arrowleft: () => stepFaces(-1),
  arrowright: () => stepFaces(1),
  escape: () => {
    if (isPicking.value) view.picking.value = false;
    else cancelRunning();
  },
  '?': () => (view.helpOpen.value = !view.helpOpen.value),
};

/** What differs while both bodies move. */
const TEST: Record<string, () => void> = {
  ' ': () => (twin.playing.value = !twin.playing.value),
  '1': () => (twin.heat.value = false),
  '2': () => (twin.heat.value = true),
  v: () => (twin.layout.value = twin.layout.value === 'beside' ? 'over' : 'beside'),
  d: () => (twin.driven.value = !twin.driven.value),
  arrowright: stepOnce,
  home: reset,
};

const plainAction = (key: string): (() => void) | undefined =>
  (view.step.value === 'test' ? TEST[key] : undefined) ?? PLAIN[key];

const WITH_CONTROL: Record<string, () => void> = {
  o: () => void pickFiles(),
  e: () => {
    if (results.mesh.value) wants.exportOpen.value = !wants.exportOpen.value;
  },
};

/** One collapse takes one face at a border and two inside: a step of two faces always shows. */
function stepFaces(direction: number): void {
  const history = results.history.value;
  if (!history || view.step.value !== 'reduce') return;
  const shown = (results.mesh.value?.mesh.triangles.length ?? 0) / 3 || wantedFaces.value;
  wants.faces.value = Math.min(history.faces, Math.max(history.floorFaces, shown + 2 * direction));
}

function isTyping(target: EventTarget | null): boolean {
  if (target instanceof HTMLSelectElement) return true;
  return target instanceof HTMLInputElement && target.type !== 'checkbox';
}

export function listenToKeys(): void {
  addEventListener('keydown', (event) => {
    const key = event.key.toLowerCase();
    const hasControl = event.ctrlKey || event.metaKey;
    const action = hasControl ? WITH_CONTROL[key] : plainAction(key);
    if (!action || event.altKey) return;
    if (!hasControl && isTyping(event.target) && key !== 'escape') return;
    // Space and Enter on a button press it; that of the step which is shown has nothing to do.
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
