/** What the pick tool does to the pins, and the dots that show them; on the Reduce step the same hand paints. */

import { batch } from '@preact/signals';
import { editPins } from '../../../engine/settings/pin_edits';
import { isDark } from '../../scheme';
import { setPins } from '../../state/pins';
import { isBrushing, isPicking, results, view, wants } from '../../state/store';
import { PickTool } from '../../viewer/pick_tool';
import type { PickHost } from '../../viewer/pick_tool';
import type { Stage } from '../../viewer/stage';
import { brushHand } from '../reduce/brushing';

/** Of the brush, over the diagonal of the body. */
const BRUSH = 0.02;

const shownPins = (): Uint32Array => results.pins.value?.vertices ?? new Uint32Array();

export function connectPicking(canvas: HTMLCanvasElement, stage: Stage): PickTool {
  const [pins, brush] = [pinHand(stage), brushHand(stage)];
  const hand = () => (isBrushing.value ? brush : pins);
  return new PickTool(canvas, {
    mesh: () => (isPicking.value || isBrushing.value ? (results.body.value?.mesh ?? null) : null),
    rayAt: (x, y) => (stage.paneAt(x) === 'original' ? stage.rayAt(x, y) : null),
    isBroad: () => isBrushing.value,
    hover: (picked) => hand().hover(picked),
    brush: () => hand().brush(),
    paint: (stroke) => hand().paint(stroke),
    finish: (stroke) => hand().finish(stroke),
  });
}

function pinHand(stage: Stage): Pick<PickHost, 'brush' | 'hover' | 'paint' | 'finish'> {
  return {
    hover: (picked) => stage.offer(picked?.vertex ?? null),
    brush: () => BRUSH * results.body.value!.diagonal,
    paint: ({ vertices, isErasing }) => {
      stage.pin(afterEdit([...vertices.keys()], !isErasing));
    },
    finish: ({ vertices, isErasing, isClick }) => {
      const touched = [...vertices.keys()];
      const isHeld = isClick && shownPins().includes(touched[0]);
      pinByHand(touched, !isErasing && !isHeld);
    },
  };
}

function afterEdit(vertices: number[], isPinning: boolean): Set<number> {
  const pinned = new Set(shownPins());
  for (const vertex of vertices)
    if (isPinning) pinned.add(vertex);
    else pinned.delete(vertex);
  return pinned;
}

function pinByHand(vertices: number[], isPinning: boolean): void {
  const body = results.body.value;
  if (!body) return;
  const pinned = shownPins();
  const { pins } = wants.settings.value;
  const text = editPins(pins, pinned, { isPinning, vertices }, body.vertexOfSource);
  const after = afterEdit(vertices, isPinning);
  batch(() => {
    setPins(text);
    // The worker will find the same: until then the next stroke goes on from here.
    results.pins.value = { text, vertices: Uint32Array.from(after).sort() };
  });
}

/** Pins belong to the motion: they are shown where something moves. */
export function showPins(stage: Stage | null): void {
  const isShown = view.step.value !== 'model' && results.body.value !== null;
  // Bodies that move carry their own.
  if (view.step.value !== 'test') stage?.pin(isShown ? shownPins() : []);
  if (!isPicking.value) stage?.offer(null);
  stage?.colourPins(isDark.value ? { fill: '#ff9d5c', rim: '#1a0d04' } : { fill: '#e8590c', rim: '#ffffff' });
}
