/** What the brush has painted: shown levels, and strokes that change them. */

import { computed } from '@preact/signals';
import { painted, parsePaint, unweldLevels, weldLevels, withPaint } from '../../engine/body/paint';
import type { Levels } from '../../engine/body/paint';
import type { Stroke } from '../stroke';
import { changeSettings, results, view, wants } from './store';

/** Levels per vertex of the shown body; null where it is bare. */
export const shownLevels = computed((): Levels | null => {
  const body = results.body.value;
  const levels = body && parsePaint(wants.settings.value.paint).get(meshNumber());
  // A text for another file is refused in words by the history.
  if (!levels || levels.length !== body.vertexOfSource.length) return null;
  return weldLevels(levels, body.vertexOfSource, body.mesh.positions.length / 3);
});

/** Among the meshes of the file. */
const meshNumber = (): number => results.file.value!.bodies[wants.body.value].mesh;

/** The levels after a stroke of the tool that is in use; Shift makes an eraser of it. */
export function levelsAfter({ vertices, isErasing }: Stroke): Levels {
  const { value: before } = shownLevels;
  const levels = before ? before.slice() : new Uint8Array(results.body.value!.mesh.positions.length / 3);
  const { tool, softness } = view.brush.value;
  for (const [vertex, distance] of vertices)
    levels[vertex] = painted(
      levels[vertex],
      isErasing ? 'erase' : (tool ?? 'keep'),
      nearness(distance, softness),
    );
  return levels;
}

/** 1 in the middle; it falls over the outer `softness` (0 to 1) of the brush. `distance`: over its radius. */
const nearness = (distance: number, softness: number): number =>
  softness > 0 ? Math.min(1, (1 - distance) / softness) : 1;

export function keepStroke(stroke: Stroke): void {
  const body = results.body.value;
  if (body) setLevels(unweldLevels(levelsAfter(stroke), body.vertexOfSource));
}

/** Takes all paint off the shown body. */
export function clearPaint(): void {
  const body = results.body.value;
  if (body) setLevels(new Uint8Array(body.vertexOfSource.length));
}

function setLevels(levels: Levels): void {
  changeSettings({ paint: withPaint(wants.settings.value.paint, meshNumber(), levels) });
}
