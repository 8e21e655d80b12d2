/** Shows both moving bodies in the viewport: their positions, their colours and everything that they can touch. */

import { computed } from '@preact/signals';
import type { CollisionScene } from '../../../engine/core/core';
import { scenarioWords } from '../../../engine/core/scenarios';
import { boundsOf } from '../../../engine/core/mesh';
import { rotated } from '../../../engine/motion/scene_rotation';
import { shownRotation } from '../../state/simulation';
import { viewportColours } from '../../state/scheme';
import { twin } from '../../state/twin';
import { results, shownMesh, view, wants } from '../../state/store';
import type { ShownCollisionScene } from '../../viewer/collision_scene_view';
import type { Viewport } from '../../viewer/viewport';
import { heatScale } from './simulate_scale';

export const isSimulating = (): boolean => view.step.value === 'test';

/** Whether the right side shows the original driven by the optimized body. */
export const isDriven = computed(() => isSimulating() && twin.driven.value);
export const isOverlaid = computed(
  () => isSimulating() && twin.layout.value === 'over' && shownMesh.value !== null,
);

export function showTwin(viewport: Viewport | null): void {
  const frame = isSimulating() ? twin.frame.value : null;
  if (!viewport) return;
  if (!frame) {
    viewport.setPositions('original', null);
    viewport.setPositions('optimized', null);
    if (isSimulating()) viewport.pin([]);
    else viewport.followMotion(null);
    return;
  }
  const { original, optimized } = frame.bodies;
  const scale = heatScale.value;
  const values = twin.heat.value ? (frame.vertexDistances?.map((value) => value / scale) ?? null) : null;
  viewport.setPositions('original', original.positions, { values, dots: original.pins });
  const dots = isOverlaid.value ? new Float32Array() : optimized.pins;
  if (!isDriven.value) viewport.setPositions('optimized', optimized.positions, { dots });
  else if (frame.driven) viewport.setPositions('optimized', frame.driven, { values, dots });
  viewport.followMotion([original.positions, optimized.positions]);
}

/** The last scene on which the camera was framed, as text. */
let fittedScene = '';

/** Shows the floor and the colliders, and frames the camera so that they are in view. */
export function showCollisionScene(viewport: Viewport | null): void {
  const body = results.body.value;
  const collisionScene = isSimulating() ? twin.collisionScene.value : null;
  const shown =
    body &&
    collisionScene &&
    sceneAround(rotated(body.mesh.positions, shownRotation()), body.diagonal, collisionScene);
  viewport?.setCollisionScene(shown, viewportColours.value.collisionScene);
  const hasPoints = shown && (shown.ground !== null || shown.lowest !== null || shown.colliders.length > 0);
  const key = hasPoints ? JSON.stringify(shown) : '';
  if (key === fittedScene) return;
  fittedScene = key;
  viewport?.fit('here');
}

function sceneAround(
  positions: Float32Array,
  diagonal: number,
  collisionScene: CollisionScene,
): ShownCollisionScene {
  const { low, high } = boundsOf(positions);
  const centre = low.map((value, c) => (value + high[c]) / 2);
  const size = high.map((value, c) => value - low[c]);
  // A body may be pinned at one end of its longest side, and then hangs down from there.
  const isHanging = scenarioWords(wants.settings.value.scenario).hangs;
  return { ...collisionScene, centre, diagonal, lowest: isHanging ? high[1] - Math.max(...size) : null };
}
