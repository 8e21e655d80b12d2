/** Shows the state of the page in the viewport: meshes, fields, mode shapes and colours. */

import { computed } from '@preact/signals';
import type { MeshAt } from '../../../engine/core/core';
import { viewportColours } from '../../state/scheme';
import { twin } from '../../state/twin';
import { isBrushing, isPicking, results, shownMesh, view } from '../../state/store';
import type { Field } from '../../viewer/body_geometry';
import type { MapName } from '../../viewer/colours';
import type { PaneName } from '../../viewer/pane_layout';
import type { Viewport } from '../../viewer/viewport';
import { guidingModes } from '../motion/mode_choice';
import { comparedPanes, isSplit } from '../reduce/compare';
import { isDriven, isOverlaid } from '../simulate/simulate_view';
import { curvatureScale } from './curvature_scale';

/** How strongly edges are drawn over a plain surface, and over the colours of a field. */
const WIRE_STRENGTH = { plain: 0.55, field: 0.42 };

export function shownPanes(): PaneName[] {
  if (view.step.value === 'test' && shownMesh.value) return ['original', 'optimized'];
  if (view.step.value !== 'reduce' || !shownMesh.value) return ['original'];
  return comparedPanes();
}

export function showOriginal(viewport: Viewport | null): void {
  const mesh = results.body.value?.mesh ?? null;
  viewport?.show('original', mesh);
  viewport?.fit(false);
}

export function showOptimized(viewport: Viewport | null): void {
  const mesh = isDriven.value ? results.body.value?.mesh : shownMesh.value?.mesh;
  viewport?.show('optimized', mesh ?? null);
}

export function showArrangement(viewport: Viewport | null): void {
  viewport?.arrange(shownPanes(), {
    overlay: isOverlaid.value ? viewportColours.value.overlay : null,
    split: isSplit() ? view.split.value : null,
  });
}

const scaledCurvature = computed(() => {
  const curvature = results.curvature.value?.vertex;
  if (!curvature) return null;
  const scale = curvatureScale(curvature);
  return curvature.map((value) => value / scale);
});

interface BodyFields {
  original: Field | null;
  optimized: Field | null;
}

/** The chosen field of the original, and the same field on the triangles and vertices that are left of it. */
function shownFields(mesh: MeshAt | null): BodyFields {
  const rank = results.guidance.value?.rank;
  const curvature = scaledCurvature.value;
  // Moving bodies have colours of their own.
  if (view.step.value === 'test') return { original: null, optimized: null };
  if (view.field.value === 'strain' && rank)
    return {
      original: { on: 'triangles', values: rank },
      optimized: mesh && { on: 'triangles', values: Float32Array.from(mesh.inputOfTriangle, (t) => rank[t]) },
    };
  if (view.field.value === 'curvature' && curvature)
    return {
      original: { on: 'vertices', values: curvature },
      optimized: mesh && {
        on: 'vertices',
        values: Float32Array.from(mesh.inputOfVertex, (v) => curvature[v]),
      },
    };
  return { original: null, optimized: null };
}

const shownMap = (): MapName =>
  view.field.value === 'curvature' && view.step.value !== 'test' ? 'cividis' : 'viridis';

export function showFields(viewport: Viewport | null): void {
  if (!results.body.value) return;
  const { original, optimized } = shownFields(shownMesh.value);
  const map = shownMap();
  viewport?.colour('original', original, map);
  viewport?.colour('optimized', optimized, map);
}

/** The mean of the shapes of the guiding modes; the largest displacement of each shape is 1 per component. */
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

export function showShapes(viewport: Viewport | null): void {
  const isSwinging = view.step.value === 'motion' || view.step.value === 'reduce';
  const shape = isSwinging ? blendedShape.value : null;
  const mesh = shownMesh.value;
  viewport?.displace('original', shape);
  if (!mesh) return;
  const carried = new Float32Array(3 * mesh.inputOfVertex.length);
  if (shape)
    mesh.inputOfVertex.forEach((v, i) => {
      for (let c = 0; c < 3; c++) carried[3 * i + c] = shape[3 * v + c];
    });
  viewport?.displace('optimized', shape && carried);
}

export function showLook(viewport: Viewport | null): void {
  const isPlain = view.step.value === 'test' ? !twin.heat.value : view.field.value === 'none';
  const wireStrength = view.wire.value ? WIRE_STRENGTH[isPlain ? 'plain' : 'field'] : 0;
  const { clay, wire } = viewportColours.value;
  // The look of a pane depends on how the panes are arranged.
  showArrangement(viewport);
  viewport?.look({ clay, wire, wireStrength, map: shownMap() });
}

export function showSwing(viewport: Viewport | null): void {
  const body = results.body.value;
  // Vertices are picked and painted on the shape at rest.
  const isStill = isPicking.value || isBrushing.value;
  const isMoving = ['motion', 'reduce'].includes(view.step.value) && !isStill;
  const isPlaying = isMoving && view.playing.value;
  const amplitude = body && isMoving ? (view.amplitude.value / 100) * body.diagonal : 0;
  viewport?.animate(isPlaying, amplitude, view.speed.value);
}
