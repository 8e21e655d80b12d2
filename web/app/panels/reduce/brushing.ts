/** What the brush does on the stage: a live picture of the stroke, and the ring that shows its size. */

import { isBrushing, results, shownMesh, view } from '../../state/store';
import { keepStroke, levelsAfter, shownLevels } from '../../state/paint';
import type { Levels } from '../../../engine/settings/paint_text';
import type { PickHost } from '../../viewer/pick_tool';
import type { Stage } from '../../viewer/stage';
import { PAINT } from '../../viewer/surface_material';

const RING = { keep: PAINT.keep, lock: PAINT.lock, erase: '#808080' };

type Hand = Pick<PickHost, 'brush' | 'hover' | 'paint' | 'finish'>;

export const brushRadius = (): number => (view.brush.value.radius / 100) * results.body.value!.diagonal;

export function brushHand(stage: Stage): Hand {
  return {
    brush: brushRadius,
    hover: (picked) => {
      const { tool } = view.brush.value;
      stage.markBrush(picked && tool ? { ...picked, radius: brushRadius(), colour: RING[tool] } : null);
    },
    paint: (stroke) => paintStage(stage, levelsAfter(stroke)),
    finish: keepStroke,
  };
}

/** Paint belongs to the reduction: it is shown there alone. */
export function showPaint(stage: Stage | null): void {
  const isShown = view.step.value === 'reduce';
  if (stage) paintStage(stage, isShown ? shownLevels.value : null);
  if (!isBrushing.value) stage?.markBrush(null);
}

/** What is left carries what was painted on it. */
function paintStage(stage: Stage, levels: Levels | null): void {
  const optimized = shownMesh.value;
  stage.paint('original', levels);
  const carried =
    levels && optimized?.inputOfVertex && Uint8Array.from(optimized.inputOfVertex, (v) => levels[v]);
  stage.paint('optimized', carried ?? null);
}
