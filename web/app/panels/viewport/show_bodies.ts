/** Shows the state of the page in the viewport: meshes, fields, mode shapes and colours. */

import { computed } from '@preact/signals';
import type { MeshAt } from '../../../engine/core/core';
import { sum } from '../../../engine/core/mesh';
import { viewportColours } from '../../state/scheme';
import { twin } from '../../state/twin';
import { shownResultFile } from '../../state/drawn_file';
import {
  isBrushing,
  isFileDrawn,
  isPicking,
  results,
  shownField,
  shownMesh,
  view,
  wants,
} from '../../state/store';
import type { Field } from '../../viewer/body_geometry';
import type { MapName } from '../../viewer/colours';
import type { SceneLook } from '../../viewer/file/scene_model';
import type { PaneName } from '../../viewer/pane_layout';
import type { Viewport } from '../../viewer/viewport';
import { guidingModes } from '../motion/mode_choice';
import { comparedPanes, isSplit } from '../reduce/compare';
import { isDriven, isOverlaid } from '../simulate/simulate_view';
import { curvatureScale } from './curvature_scale';

/** How strongly edges are drawn over a plain surface, and over the colours of a field. */
const WIRE_STRENGTH = { plain: 0.55, field: 0.42, file: 0.35 };
/** Edges of a mesh with more faces cannot be told apart in the picture of a whole mesh. */
const MAX_FACES_WITH_EDGES = 12_000;

/** Whether the edges of a whole mesh with `faces` faces can be distinguished. */
export const hasClearEdges = (faces: number): boolean => faces <= MAX_FACES_WITH_EDGES;

/** Whether edges are drawn: as the user has chosen, otherwise if they can be distinguished and no material is shown. */
export const isWireShown = (): boolean =>
  view.wire.value ?? (!isFileDrawn.value && hasClearEdges(results.body.value?.inspection.faces ?? 0));

export function shownPanes(): PaneName[] {
  if (view.step.value === 'test' && shownMesh.value) return ['original', 'optimized'];
  if (view.step.value !== 'reduce' || !shownMesh.value) return ['original'];
  return comparedPanes();
}

export function showOriginal(viewport: Viewport | null): void {
  const mesh = results.body.value?.mesh ?? null;
  const nodeMatrix = results.file.value?.bodies[wants.body.value]?.nodeMatrix;
  if (nodeMatrix) viewport?.standAt(nodeMatrix);
  viewport?.show('original', mesh);
  if (mesh) viewport?.fit('front');
}

/** The indices of the file's meshes that are drawn; null: all of them. */
const drawnMeshes = computed((): ReadonlySet<number> | null => {
  const bodies = results.file.value?.bodies ?? [];
  const isShown = (i: number) =>
    view.isWhole.value && bodies.length > 1 ? !view.hidden.value.has(i) : i === wants.body.value;
  const shown = bodies.filter((_, i) => isShown(i));
  return shown.length === bodies.length ? null : new Set(shown.map(({ mesh }) => mesh));
});

/** Faces of all bodies of the scene, as counted by the slider, even before they are drawn; null if a pane shows one body. */
export function sceneFaces(name: PaneName): number | null {
  const bodies = results.file.value?.bodies ?? [];
  const isScene = isFileDrawn.value && view.isWhole.value && bodies.length > 1;
  if (!isScene || !results.originalFile.value) return null;
  const after = shownResultFile.value?.faces ?? results.shares.value?.expected;
  if (name === 'optimized' && !after) return wants.faces.value ?? halfOf(bodies);
  // A body that cannot be used is not changed.
  const facesOf = bodies.map(({ faces, health }, i) =>
    name === 'original' || health === null ? faces : after![i],
  );
  return sum(facesOf.filter((_, i) => !view.hidden.value.has(i)));
}

/** The faces that a scene keeps without a requested number. */
const halfOf = (bodies: readonly { faces: number }[]): number =>
  Math.floor(sum(bodies.map(({ faces }) => faces)) / 2);

/** Draws the original and the result with the materials of their files, unless something else is chosen. */
export function showFiles(viewport: Viewport | null): void {
  const [original, result] = [results.originalFile.value, shownResultFile.value];
  const { clay, wire } = viewportColours.value;
  const look: SceneLook = {
    name: view.look.value,
    isFlat: view.isFlat.value,
    clay,
    wire,
    wireStrength: view.wire.value ? WIRE_STRENGTH.file : 0,
    shown: drawnMeshes.value,
  };
  const isDrawn = isFileDrawn.value && original !== null;
  const isPlaying = isDrawn && view.animated.value;
  const hasFloor = isFileDrawn.value;
  if (!viewport) return;
  viewport.setFloor(hasFloor);
  viewport.lookAtFile('original', isDrawn ? look : null);
  viewport.lookAtFile('optimized', isDrawn && result ? look : null);
  viewport.playFile(isPlaying);
  lookAgain(viewport, isDrawn && view.isWhole.value && results.file.value!.bodies.length > 1);
  // A file that the loader cannot read is drawn as a plain body.
  void viewport.showFile('original', original).catch(() => null);
  void viewport.showFile('optimized', result?.bytes ?? null).catch(() => null);
}

let wasWhole = false;

/** Frames the camera when the whole scene replaces one of its bodies, or the other way round. */
function lookAgain(viewport: Viewport, isWhole: boolean): void {
  if (isWhole === wasWhole) return;
  wasWhole = isWhole;
  viewport.fit('here');
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
  const scaled = new Float32Array(curvature.length);
  for (let i = 0; i < scaled.length; i++) scaled[i] = curvature[i] / scale;
  return scaled;
});

interface BodyFields {
  original: Field | null;
  optimized: Field | null;
}

/** values[numbers[i]]; a loop, because a million function calls would take longer than a frame. */
function gather(values: Float32Array, numbers: Uint32Array): Float32Array {
  const out = new Float32Array(numbers.length);
  for (let i = 0; i < numbers.length; i++) out[i] = values[numbers[i]];
  return out;
}

/** The chosen field of the original, and the same field on its remaining triangles and vertices. */
function shownFields(mesh: MeshAt | null): BodyFields {
  const rank = results.guidance.value?.rank;
  const curvature = shownField.value === 'curvature' ? scaledCurvature.value : null;
  // Moving bodies have colours of their own.
  if (view.step.value === 'test') return { original: null, optimized: null };
  if (shownField.value === 'strain' && rank)
    return {
      original: { on: 'triangles', values: rank },
      optimized: mesh && { on: 'triangles', values: gather(rank, mesh.inputOfTriangle) },
    };
  if (curvature)
    return {
      original: { on: 'vertices', values: curvature },
      optimized: mesh && {
        on: 'vertices',
        values: gather(curvature, mesh.inputOfVertex),
      },
    };
  return { original: null, optimized: null };
}

const shownMap = (): MapName =>
  shownField.value === 'curvature' && view.step.value !== 'test' ? 'cividis' : 'viridis';

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
  // Modes of a mesh that was welded differently are kept until new ones are found.
  if (modes.shapes.length !== modes.modesPerComponent * size) return null;
  const chosen = guidingModes().filter((mode) => mode <= modes.modesPerComponent);
  const shape = new Float32Array(size);
  for (const mode of chosen)
    for (let i = 0; i < size; i++) shape[i] += modes.shapes[(mode - 1) * size + i] / chosen.length;
  return chosen.length > 0 ? shape : null;
});

/** Whether the step shows the chosen modes in motion. */
const isSwinging = (): boolean =>
  view.step.value === 'motion' || (view.step.value === 'reduce' && view.swings.value);

export function showShapes(viewport: Viewport | null): void {
  const shape = isSwinging() ? blendedShape.value : null;
  const mesh = shownMesh.value;
  viewport?.displace('original', shape);
  if (!mesh || !shape) return viewport?.displace('optimized', null);
  const carried = new Float32Array(3 * mesh.inputOfVertex.length);
  for (let i = 0; i < mesh.inputOfVertex.length; i++)
    for (let c = 0; c < 3; c++) carried[3 * i + c] = shape[3 * mesh.inputOfVertex[i] + c];
  viewport?.displace('optimized', carried);
}

export function showLook(viewport: Viewport | null): void {
  const isPlain = view.step.value === 'test' ? !twin.heat.value : shownField.value === 'none';
  const wireStrength = isWireShown() ? WIRE_STRENGTH[isPlain ? 'plain' : 'field'] : 0;
  const { clay, wire } = viewportColours.value;
  // The look of a pane depends on how the panes are arranged.
  showArrangement(viewport);
  viewport?.look({ clay, wire, wireStrength, map: shownMap(), isFlat: view.isFlat.value });
}

export function showSwing(viewport: Viewport | null): void {
  const body = results.body.value;
  // Vertices are picked and painted on the shape at rest.
  const isStill = isPicking.value || isBrushing.value;
  const isMoving = isSwinging() && !isStill;
  const isPlaying = isMoving && (view.playing.value || view.step.value === 'reduce');
  const amplitude = body && isMoving ? (view.amplitude.value / 100) * body.diagonal : 0;
  viewport?.animate(isPlaying, amplitude, view.speed.value);
}
