/** Projects the vertices of a swinging body. A search tree would be out of date in every frame, so there is none. */

import { vertexCount } from '../../engine/core/mesh';
import { Matrix4 } from 'three';
import type { PerspectiveCamera } from 'three';

/** In CSS pixels from an upper left corner. */
export interface ScreenPoint {
  x: number;
  y: number;
}

/** Vertices at `positions[3 v + c] + amplitude shape[3 v + c]`. */
export interface SeenBody {
  positions: Float32Array;
  /** null: at rest */
  shape: Float32Array | null;
  amplitude: number;
}

/** In CSS pixels. */
export interface PaneSize {
  width: number;
  height: number;
}

interface SeenVertex extends ScreenPoint {
  /** distance from the eye along the axis of view */
  depth: number;
}

/** Vertices farther behind the nearest one than this fraction of its depth are assumed to be hidden. */
const HIDDEN = 0.03;

/** The nearest vertex to a point among those assumed to be visible; null if none is within `pixels`. O(vertices). */
export function nearestSeen(
  body: SeenBody,
  camera: PerspectiveCamera,
  { x, y, pixels, ...size }: ScreenPoint & PaneSize & { pixels: number },
): number | null {
  const project = projection(camera, size);
  const near: { vertex: number; distance: number; depth: number }[] = [];
  for (let vertex = 0; vertex < vertexCount(body); vertex++) {
    const seen = project(body, vertex);
    const distance = Math.hypot(seen.x - x, seen.y - y);
    if (distance <= pixels && seen.depth > 0) near.push({ vertex, distance, depth: seen.depth });
  }
  const front = near.reduce((least, { depth }) => Math.min(least, depth), Infinity);
  const visible = near.filter(({ depth }) => depth <= (1 + HIDDEN) * front);
  return visible.sort((a, b) => a.distance - b.distance || a.vertex - b.vertex)[0]?.vertex ?? null;
}

/** The position of a vertex in a pane. */
export const seenAt = (
  body: SeenBody,
  camera: PerspectiveCamera,
  vertex: number,
  size: PaneSize,
): ScreenPoint => projection(camera, size)(body, vertex);

/** Unrolled for speed with a million vertices. Every call of the returned function returns the same object. */
function projection(camera: PerspectiveCamera, { width, height }: PaneSize) {
  const m = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
  const seen: SeenVertex = { x: 0, y: 0, depth: 0 };
  return ({ positions, shape, amplitude }: SeenBody, vertex: number): SeenVertex => {
    const at = (c: number) => positions[3 * vertex + c] + (shape ? amplitude * shape[3 * vertex + c] : 0);
    const [px, py, pz] = [at(0), at(1), at(2)];
    const row = (i: number) => m[i] * px + m[i + 4] * py + m[i + 8] * pz + m[i + 12];
    seen.depth = row(3);
    seen.x = (0.5 + (0.5 * row(0)) / seen.depth) * width;
    seen.y = (0.5 - (0.5 * row(1)) / seen.depth) * height;
    return seen;
  };
}
