/** The painted levels of the shown body, and strokes of the brush that change them. */

import { vertexCount } from '../../engine/core/mesh';
import { computed } from '@preact/signals';
import { painted, unweldLevels, weldLevels } from '../../engine/body/paint';
import { parsePaint, withPaint } from '../../engine/settings/paint_text';
import type { Levels } from '../../engine/settings/paint_text';
import type { Stroke } from '../stroke';
import { changeSettings, results, view, wants } from './store';

/** Levels per vertex of the shown body; null if it is unpainted. */
export const shownLevels = computed((): Levels | null => {
  const body = results.body.value;
  const levels = body && parsePaint(wants.settings.value.paint).get(meshNumber());
  // For a text of another file, the stage of the history reports the error.
  if (!levels || levels.length !== body.vertexOfSource.length) return null;
  return weldLevels(levels, body.vertexOfSource, vertexCount(body.mesh));
});

/** The index of the shown body's mesh among the meshes of the file. */
const meshNumber = (): number => results.file.value!.bodies[wants.body.value].mesh;

/** The levels after a stroke of the tool in use; with Shift every tool erases. */
export function levelsAfter({ vertices, isErasing }: Stroke): Levels {
  const { value: before } = shownLevels;
  const levels = before ? before.slice() : new Uint8Array(vertexCount(results.body.value!.mesh));
  const { tool, softness } = view.brush.value;
  for (const [vertex, distance] of vertices)
    levels[vertex] = painted(
      levels[vertex],
      isErasing ? 'erase' : (tool ?? 'keep'),
      nearness(distance, softness),
    );
  return levels;
}

/** 1 in the middle, falling to 0 over the outer fraction `softness` (0 to 1) of the brush; `distance` is relative to its radius. */
const nearness = (distance: number, softness: number): number =>
  softness > 0 ? Math.min(1, (1 - distance) / softness) : 1;

export function keepStroke(stroke: Stroke): void {
  const body = results.body.value;
  if (body) setLevels(unweldLevels(levelsAfter(stroke), body.vertexOfSource));
}

/** Removes all paint from the shown body. */
export function clearPaint(): void {
  const body = results.body.value;
  if (body) setLevels(new Uint8Array(body.vertexOfSource.length));
}

function setLevels(levels: Levels): void {
  changeSettings({ paint: withPaint(wants.settings.value.paint, meshNumber(), levels) });
}
