/** The camera and the pick tool by keyboard, while the picture has the focus. */

import { isBrushing, isPicking } from '../../state/store';
import type { PickTool } from '../../viewer/pick_tool';
import type { Viewport } from '../../viewer/viewport';

/** Radians per press. */
const ROTATION = Math.PI / 24;
/** The fraction of the distance to the body per press. */
const STEP = 0.1;
const ZOOM = 1.15;

/** Arrows rotate, with Shift they move; + and - zoom. Enter picks or paints at the centre, with Shift it removes. */
export function connectViewportKeys(canvas: HTMLCanvasElement, viewport: Viewport, tool: PickTool): void {
  const { orbit } = viewport;
  const moves: Record<string, () => void> = {
    ArrowLeft: () => orbit.rotate(-ROTATION, 0),
    ArrowRight: () => orbit.rotate(ROTATION, 0),
    ArrowUp: () => orbit.rotate(0, -ROTATION),
    ArrowDown: () => orbit.rotate(0, ROTATION),
    'Shift ArrowLeft': () => orbit.slide(-STEP, 0),
    'Shift ArrowRight': () => orbit.slide(STEP, 0),
    'Shift ArrowUp': () => orbit.slide(0, -STEP),
    'Shift ArrowDown': () => orbit.slide(0, STEP),
    '+': () => orbit.zoom(ZOOM),
    '=': () => orbit.zoom(ZOOM),
    '-': () => orbit.zoom(1 / ZOOM),
  };
  const canPick = (): boolean => isPicking.value || isBrushing.value;
  const preview = (): void => {
    if (canPick()) tool.aim(middle(canvas, viewport));
  };
  canvas.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { key, shiftKey } = event;
    const move = moves[shiftKey && key.startsWith('Arrow') ? `Shift ${key}` : key];
    const isPick = key === 'Enter' && canPick();
    if (!move && !isPick) return;
    // Elsewhere the arrows step through the collapses.
    event.preventDefault();
    event.stopPropagation();
    if (move) move();
    else tool.click(middle(canvas, viewport), shiftKey);
    preview();
  });
  canvas.addEventListener('focus', preview);
}

/** The centre of the picture, of the left one if there are two. */
function middle(canvas: HTMLCanvasElement, viewport: Viewport): { clientX: number; clientY: number } {
  const { left, top, width, height } = canvas.getBoundingClientRect();
  const at = (share: number): number => left + share * width;
  const share = viewport.paneAt(at(0.25)) === viewport.paneAt(at(0.75)) ? 0.5 : 0.25;
  return { clientX: at(share), clientY: top + height / 2 };
}
