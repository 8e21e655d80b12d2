/** The brush in the viewport: shows the stroke while painting, and a ring of the brush's size. */

import { isBrushing, results, shownMesh, view } from '../../state/store';
import { keepStroke, levelsAfter, shownLevels } from '../../state/paint';
import type { Levels } from '../../../engine/settings/paint_text';
import type { StrokeTool } from '../../viewer/pick_tool';
import { PAINT } from '../../viewer/surface_material';
import type { Viewport } from '../../viewer/viewport';

const RING = { keep: PAINT.keep, lock: PAINT.lock, erase: '#808080' };

const brushRadius = (): number => (view.brush.value.radius / 100) * results.body.value!.diagonal;

export function brushTool(viewport: Viewport): StrokeTool {
  return {
    radius: brushRadius,
    hover: (picked) => {
      const { tool } = view.brush.value;
      viewport.markBrush(picked && tool ? { ...picked, radius: brushRadius(), colour: RING[tool] } : null);
    },
    paint: (stroke) => showLevels(viewport, levelsAfter(stroke)),
    finish: keepStroke,
  };
}

/** Shows the paint on the Reduce step, the only one that it affects. */
export function showPaint(viewport: Viewport | null): void {
  const isShown = view.step.value === 'reduce';
  if (viewport) showLevels(viewport, isShown ? shownLevels.value : null);
  if (!isBrushing.value) viewport?.markBrush(null);
}

/** Each vertex of the optimized mesh shows the paint of its own vertex of the original. */
function showLevels(viewport: Viewport, levels: Levels | null): void {
  const optimized = shownMesh.value;
  viewport.paint('original', levels);
  const carried =
    levels && optimized?.inputOfVertex && Uint8Array.from(optimized.inputOfVertex, (v) => levels[v]);
  viewport.paint('optimized', carried ?? null);
}
