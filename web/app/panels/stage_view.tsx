/** The stage in the page: hands meshes, fields and looks from the state to the viewer. */

import { computed, effect, useSignalEffect } from '@preact/signals';
import { useEffect, useRef, useState } from 'preact/hooks';
import type { MeshAt } from '../../engine/core/core';
import { isDark } from '../scheme';
import { twin } from '../state/simulation';
import { isBrushing, isPicking, results, shownMesh, view } from '../state/store';
import type { Field } from '../viewer/body_geometry';
import type { MapName } from '../viewer/colours';
import { Stage } from '../viewer/stage';
import type { PaneName } from '../viewer/stage';
import { count } from './controls';
import { curvatureScale } from './curvature_scale';
import { Compare, comparedPanes, isSplit, labelsBesideChoice } from './reduce/compare';
import { Legend } from './legend';
import { guidingModes } from './motion/mode_choice';
import { showPaint } from './reduce/brushing';
import { connectPicking, showPins } from './motion/picking';
import { connectProbe, WhyCard } from './reduce/why_card';
import {
  connectDragging,
  isDriven,
  isOverlaid,
  showProps,
  showTwin,
  TwinAlert,
  TwinLabels,
  veilColour,
} from './simulate/simulate_view';

export const stageHandle: { current: Stage | null } = { current: null };

const getStage = (): Stage | null => stageHandle.current;

export function StageView() {
  const canvas = useRef<HTMLCanvasElement>(null);
  const [failed, setFailed] = useState(false);
  useEffect(() => {
    try {
      stageHandle.current = new Stage(canvas.current!);
      const hand = connectPicking(canvas.current!, stageHandle.current);
      connectDragging(canvas.current!, stageHandle.current);
      connectProbe(canvas.current!, getStage);
      effect(() => {
        if (isBrushing.value || isPicking.value) hand.prepare();
      });
      showAll();
    } catch {
      setFailed(true);
    }
  }, []);
  useSignalEffect(showOriginal);
  useSignalEffect(showOptimized);
  useSignalEffect(showArrangement);
  useSignalEffect(showFields);
  useSignalEffect(showShapes);
  useSignalEffect(showLook);
  useSignalEffect(showSwing);
  useSignalEffect(() => showPins(stageHandle.current));
  useSignalEffect(() => showPaint(stageHandle.current));
  useSignalEffect(() => showProps(stageHandle.current));
  useSignalEffect(() => showTwin(stageHandle.current));
  return (
    <div class={isPicking.value || isBrushing.value ? 'stage picking' : 'stage'}>
      <canvas ref={canvas} aria-label={describeStage()} role="img" />
      {failed && (
        <p class="empty">
          This browser has no WebGL2, so there is no picture; files, numbers and export work.
        </p>
      )}
      <PaneLabels />
      <Compare />
      <WhyCard getStage={getStage} />
      <TwinAlert />
      <Legend />
    </div>
  );
}

function describeStage(): string {
  if (isBrushing.value) return 'The mesh at rest. Drag over the original to paint it; Shift erases.';
  if (isPicking.value)
    return 'The mesh at rest. Click a vertex or drag over the surface to hold it in place; Shift lets go.';
  if (view.step.value === 'test')
    return 'Both meshes in motion. Drag a body to pull at it, drag beside it to turn, scroll to zoom.';
  return 'The mesh. Drag to turn, scroll to zoom, right-drag to move.';
}

function showAll(): void {
  for (const show of [
    showOriginal,
    showOptimized,
    showArrangement,
    showFields,
    showShapes,
    showLook,
    showSwing,
    () => showPins(stageHandle.current),
    () => showPaint(stageHandle.current),
    () => showProps(stageHandle.current),
    () => showTwin(stageHandle.current),
  ])
    show();
}

function shownPanes(): PaneName[] {
  if (view.step.value === 'test' && shownMesh.value) return ['original', 'optimized'];
  if (view.step.value !== 'reduce' || !shownMesh.value) return ['original'];
  return comparedPanes();
}

function showOriginal(): void {
  const mesh = results.body.value?.mesh ?? null;
  stageHandle.current?.show('original', mesh);
  stageHandle.current?.fit(false);
}

function showOptimized(): void {
  const mesh = isDriven.value ? results.body.value?.mesh : shownMesh.value?.mesh;
  stageHandle.current?.show('optimized', mesh ?? null);
}

function showArrangement(): void {
  stageHandle.current?.arrange(shownPanes(), {
    veil: isOverlaid.value ? veilColour() : null,
    split: isSplit() ? view.split.value : null,
  });
}

const scaledCurvature = computed(() => {
  const curvature = results.curvature.value?.vertex;
  if (!curvature) return null;
  const scale = curvatureScale(curvature);
  return curvature.map((value) => value / scale);
});

/** A field of the original, and the same seen on what is left of it. */
function fields(mesh: MeshAt | null): { original: Field | null; optimized: Field | null } {
  // Bodies that move bring their own colours.
  if (view.step.value === 'test') return { original: null, optimized: null };
  const rank = results.guidance.value?.rank;
  const curvature = results.curvature.value?.vertex;
  if (view.field.value === 'strain' && rank)
    return {
      original: { on: 'triangles', values: rank },
      optimized: mesh && { on: 'triangles', values: Float32Array.from(mesh.inputOfTriangle, (t) => rank[t]) },
    };
  if (view.field.value === 'curvature' && curvature) {
    const scaled = scaledCurvature.value!;
    return {
      original: { on: 'vertices', values: scaled },
      optimized: mesh && { on: 'vertices', values: Float32Array.from(mesh.inputOfVertex, (v) => scaled[v]) },
    };
  }
  return { original: null, optimized: null };
}

const shownMap = (): MapName =>
  view.field.value === 'curvature' && view.step.value !== 'test' ? 'cividis' : 'viridis';

function showFields(): void {
  if (!results.body.value) return;
  const { original, optimized } = fields(shownMesh.value);
  const map = shownMap();
  stageHandle.current?.colour('original', original, map);
  stageHandle.current?.colour('optimized', optimized, map);
}

/** The sum of the guiding modes' shapes, each of largest displacement 1 per part. */
const blendedShape = computed((): Float32Array | null => {
  const modes = results.modes.value;
  const body = results.body.value;
  if (!modes || !body) return null;
  const size = body.mesh.positions.length;
  const chosen = guidingModes().filter((mode) => mode <= modes.modesPerComponent);
  const shape = new Float32Array(size);
  for (const mode of chosen)
    for (let i = 0; i < size; i++) shape[i] += modes.shapes[(mode - 1) * size + i] / chosen.length;
  return chosen.length > 0 ? shape : null;
});

function showShapes(): void {
  const isSwinging = view.step.value === 'motion' || view.step.value === 'reduce';
  const shape = isSwinging ? blendedShape.value : null;
  const mesh = shownMesh.value;
  stageHandle.current?.displace('original', shape);
  if (!mesh) return;
  const carried = new Float32Array(3 * mesh.inputOfVertex.length);
  if (shape)
    mesh.inputOfVertex.forEach((v, i) => {
      for (let c = 0; c < 3; c++) carried[3 * i + c] = shape[3 * v + c];
    });
  stageHandle.current?.displace('optimized', shape && carried);
}

function showLook(): void {
  const isPlain = view.step.value === 'test' ? !twin.heat.value : view.field.value === 'none';
  const wireStrength = view.wire.value ? (isPlain ? 0.55 : 0.42) : 0;
  const colours = isDark.value ? { clay: '#93a9bb', wire: '#0b1016' } : { clay: '#b9c8d4', wire: '#1c2a36' };
  showArrangement();
  stageHandle.current?.look({ ...colours, wireStrength, map: shownMap() });
}

function showSwing(): void {
  const body = results.body.value;
  // Picking is on the shape at rest.
  const isStill = isPicking.value || isBrushing.value;
  const isMoving = ['motion', 'reduce'].includes(view.step.value) && !isStill;
  const moves = isMoving && view.playing.value;
  const amplitude = body && isMoving ? (view.amplitude.value / 100) * body.diagonal : 0;
  stageHandle.current?.animate(moves, amplitude, view.speed.value);
}

function PaneLabels() {
  const body = results.body.value;
  if (!body) return null;
  if (view.step.value === 'test' && shownMesh.value) return <TwinLabels />;
  const faces = {
    original: body.mesh.triangles.length / 3,
    optimized: (shownMesh.value?.mesh.triangles.length ?? 0) / 3,
  };
  return (
    <div class={`pane-labels ${labelsBesideChoice()}`}>
      {shownPanes().map((name) => (
        <span key={name}>
          {name === 'original' ? 'Original' : 'Optimized'}{' '}
          <span class="muted">{count(faces[name])} faces</span>
        </span>
      ))}
    </div>
  );
}
