/** Applies the pick tool to the pins, and shows them as dots. On the Reduce step the same tool paints. */

import { batch } from '@preact/signals';
import { editPins } from '../../../engine/settings/pin_edits';
import { isMissingFile } from '../../state/offline';
import { setPins } from '../../state/pins';
import { complain } from '../../state/running';
import { viewportColours } from '../../state/scheme';
import { isBrushing, isPicking, results, view, wants } from '../../state/store';
import { PickTool } from '../../viewer/pick_tool';
import type { StrokeTool } from '../../viewer/pick_tool';
import type { Viewport } from '../../viewer/viewport';
import { say } from '../../language/say';
import { brushTool } from '../reduce/brushing';

/** The radius of a stroke that pins, over the diagonal of the body. */
const RADIUS = 0.02;

const shownPins = (): Uint32Array => results.pins.value?.vertices ?? new Uint32Array();

export function connectPicking(canvas: HTMLCanvasElement, viewport: Viewport): PickTool {
  const [pins, brush] = [pinTool(viewport), brushTool(viewport)];
  return new PickTool(canvas, {
    tool: () => (isBrushing.value ? brush : isPicking.value ? pins : null),
    mesh: () => (isPicking.value || isBrushing.value ? (results.body.value?.mesh ?? null) : null),
    // Both meshes are at the same position, so that a stroke over either paints the original; pins apply to the visible
    // mesh.
    rayAt: (x, y, fromX) =>
      isBrushing.value || viewport.paneAt(x) === 'original' ? viewport.rayAt(x, y, fromX) : null,
    isBroad: () => isBrushing.value,
    fail: (error) => complain(isMissingFile(error) ? error : new Error(describeFailure(error))),
  });
}

const describeFailure = (error: unknown): string =>
  say('Nothing can be picked on this mesh: {why}. Switch the tool off and on to try again.', {
    why: error instanceof Error ? error.message : String(error),
  });

function pinTool(viewport: Viewport): StrokeTool {
  return {
    hover: (picked) => viewport.previewPick(picked?.vertex ?? null),
    radius: () => RADIUS * results.body.value!.diagonal,
    paint: ({ vertices, isErasing }) => {
      viewport.pin(afterEdit([...vertices.keys()], !isErasing));
    },
    finish: ({ vertices, isErasing, isClick }) => {
      const touched = [...vertices.keys()];
      const isPinned = isClick && shownPins().includes(touched[0]);
      pinVertices(touched, !isErasing && !isPinned);
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

function pinVertices(vertices: number[], isPinning: boolean): void {
  const body = results.body.value;
  if (!body) return;
  const pinned = shownPins();
  const { pins } = wants.settings.value;
  const text = editPins(pins, pinned, { isPinning, vertices }, body.vertexOfSource);
  const after = afterEdit(vertices, isPinning);
  batch(() => {
    setPins(text);
    // The worker will find the same pins. Until then the next stroke continues from these.
    results.pins.value = { text, vertices: Uint32Array.from(after).sort() };
  });
}

/** Shows the pins on every step with moving bodies. */
export function showPins(viewport: Viewport | null): void {
  const isShown = view.step.value !== 'model' && results.body.value !== null;
  // On the Test step the moving bodies show their own pins.
  if (view.step.value !== 'test') viewport?.pin(isShown ? shownPins() : []);
  if (!isPicking.value) viewport?.previewPick(null);
  viewport?.colourPins(viewportColours.value.pin);
}
