/** Both bodies in motion on the stage: where they are, how they are coloured, what they fall on, and the hand. */

import { computed } from '@preact/signals';
import type { Vector3 } from 'three';
import type { CollisionScene } from '../../../engine/core/core';
import { scenarioWords } from '../../../engine/core/scenarios';
import { boundsOf } from '../../../engine/motion/top_corners';
import { isDark } from '../../scheme';
import { dragTo, grab, letGo, twin } from '../../state/simulation';
import { results, shownMesh, view, wants } from '../../state/store';
import type { PaneName, Stage } from '../../viewer/stage';
import { DragTool, gripAt } from '../../viewer/twin_drag';
import type { Grip } from '../../viewer/twin_drag';
import type { Props } from '../../viewer/twin_props';
import { count } from '../controls';
import { heatScale } from './simulate_scale';

const isTesting = (): boolean => view.step.value === 'test';

/** Whether the right side shows the original as the optimized body carries it. */
export const isDriven = computed(() => isTesting() && twin.driven.value);
export const isOverlaid = computed(
  () => isTesting() && twin.layout.value === 'over' && shownMesh.value !== null,
);

export const veilColour = (): string => (isDark.value ? '#ff9d5c' : '#e8590c');

export function showTwin(stage: Stage | null): void {
  const frame = isTesting() ? twin.frame.value : null;
  if (!stage) return;
  if (!frame) {
    stage.place('original', null);
    stage.place('optimized', null);
    if (isTesting()) stage.pin([]);
    return;
  }
  const { original, optimized } = frame.bodies;
  const scale = heatScale.value;
  const values = twin.heat.value ? (frame.vertexDistances?.map((value) => value / scale) ?? null) : null;
  stage.place('original', original.positions, { values, dots: original.pins });
  const dots = isOverlaid.value ? new Float32Array() : optimized.pins;
  if (!isDriven.value) stage.place('optimized', optimized.positions, { dots });
  else if (frame.driven) stage.place('optimized', frame.driven, { values, dots });
}

let furnished = '';

/** Floor and colliders, and a view that has them in it. */
export function showProps(stage: Stage | null): void {
  const body = results.body.value;
  const collisionScene = isTesting() ? twin.collisionScene.value : null;
  const props = body && collisionScene && propsOf(body.mesh.positions, body.diagonal, collisionScene);
  stage?.furnish(props, isDark.value ? DARK_PROPS : LIGHT_PROPS);
  const reaches = props && (props.ground !== null || props.lowest !== null || props.colliders.length > 0);
  const key = reaches ? JSON.stringify(props) : '';
  if (key === furnished) return;
  furnished = key;
  stage?.fit();
}

const LIGHT_PROPS = { floor: '#c3ccd4', line: '#8d9aa6', body: '#d9b98c' };
const DARK_PROPS = { floor: '#2b3541', line: '#4a5866', body: '#a8875b' };

function propsOf(positions: Float32Array, diagonal: number, collisionScene: CollisionScene): Props {
  const [low, high] = boundsOf(positions);
  const centre = low.map((value, c) => (value + high[c]) / 2);
  const size = high.map((value, c) => value - low[c]);
  // By the end of its longest side.
  const isHanging = scenarioWords(wants.settings.value.scenario).hangs;
  return { ...collisionScene, centre, diagonal, lowest: isHanging ? high[1] - Math.max(...size) : null };
}

/** What the ray meets in the pane under the pointer; overlaid, the body that is nearer to the eye. */
function gripOn(stage: Stage, ray: Parameters<typeof gripAt>[0], clientX: number) {
  const frame = twin.frame.value;
  const [body, result] = [results.body.value, shownMesh.value];
  if (!frame || !twin.numbers.value || !body || !result) return null;
  const names: PaneName[] = isOverlaid.value ? ['original', 'optimized'] : [stage.paneAt(clientX)];
  const found = names.flatMap((name): { name: PaneName; grip: Grip }[] => {
    // What is driven has the original's triangles.
    const isOwn = name === 'optimized' && !isDriven.value;
    const positions =
      name === 'original'
        ? frame.bodies.original.positions
        : isOwn
          ? frame.bodies.optimized.positions
          : frame.driven;
    const grip = positions && gripAt(ray, isOwn ? result.mesh : body.mesh, positions);
    return grip ? [{ name: isOwn ? 'optimized' : 'original', grip }] : [];
  });
  const farness = ({ grip }: { grip: Grip }) => grip.place.distanceTo(ray.origin as Vector3);
  return found.sort((a, b) => farness(a) - farness(b))[0] ?? null;
}

export function connectDragging(canvas: HTMLCanvasElement, stage: Stage): DragTool<PaneName> {
  return new DragTool<PaneName>(canvas, {
    rayAt: (x, y, fromX) => (isTesting() ? stage.rayAt(x, y, fromX) : null),
    gripAt: (ray, x) => gripOn(stage, ray, x),
    grab,
    drag: dragTo,
    release: letGo,
  });
}

export function TwinLabels() {
  const faces = (name: PaneName) =>
    count((name === 'original' ? results.body.value!.mesh : shownMesh.value!.mesh).triangles.length / 3);
  return (
    <div class="pane-labels">
      <span>
        Original <span class="muted">{faces('original')} faces</span>
      </span>
      <span>
        {isOverlaid.value && <span class="swatch" style={{ background: veilColour() }} />}
        {isDriven.value ? 'Original, carried by the optimized' : 'Optimized'}{' '}
        <span class="muted">{faces('optimized')} faces</span>
      </span>
    </div>
  );
}

/** Which side has flown apart, and what helps. */
export function TwinAlert() {
  const frame = twin.numbers.value;
  if (!isTesting()) return null;
  if (twin.failure.value)
    return (
      <p class="twin-alert" role="alert">
        {twin.failure.value}
      </p>
    );
  if (!frame || frame.diverged.length === 0) return null;
  const { substeps } = wants.settings.value;
  const who = frame.diverged.length === 2 ? 'Both meshes have' : `The ${frame.diverged[0]} mesh has`;
  return (
    <>
      {!isOverlaid.value && frame.diverged.map((name) => <div key={name} class={`exploded ${name}`} />)}
      <p class="twin-alert" role="alert">
        {who} flown apart at {frame.time.toFixed(2)} s: raise the substeps (now {substeps}) or take a softer
        material, then reset.
      </p>
    </>
  );
}
