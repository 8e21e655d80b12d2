/** Vertices of a swinging body as they are seen: no tree, for they move every frame. */

import { Matrix4 } from 'three';
import type { PerspectiveCamera } from 'three';

/** From an upper left corner, in CSS pixels. */
export interface ScreenPlace {
  x: number;
  y: number;
}

/** positions[3 * v + c] + amplitude * shape[3 * v + c] */
export interface SeenBody {
  positions: Float32Array;
  /** null: at rest */
  shape: Float32Array | null;
  amplitude: number;
}

interface PaneSize {
  width: number;
  height: number;
}

interface SeenVertex extends ScreenPlace {
  /** from the eye, along the line of sight */
  depth: number;
}

/** Vertices farther behind the nearest one than this, over its depth, are taken as hidden. */
const HIDDEN = 0.03;

/** The vertex nearest to a place among those that seem not hidden; null where none is within `pixels`. */
export function nearestSeen(
  body: SeenBody,
  camera: PerspectiveCamera,
  { x, y, pixels, ...size }: ScreenPlace & PaneSize & { pixels: number },
): number | null {
  const project = projection(camera, size);
  const near: { vertex: number; distance: number; depth: number }[] = [];
  for (let vertex = 0; vertex < body.positions.length / 3; vertex++) {
    const seen = project(body, vertex);
    const distance = Math.hypot(seen.x - x, seen.y - y);
    if (distance <= pixels && seen.depth > 0) near.push({ vertex, distance, depth: seen.depth });
  }
  const front = near.reduce((least, { depth }) => Math.min(least, depth), Infinity);
  const visible = near.filter(({ depth }) => depth <= (1 + HIDDEN) * front);
  return visible.sort((a, b) => a.distance - b.distance || a.vertex - b.vertex)[0]?.vertex ?? null;
}

export const seenAt = (
  body: SeenBody,
  camera: PerspectiveCamera,
  vertex: number,
  size: PaneSize,
): ScreenPlace => projection(camera, size)(body, vertex);

/** By hand, for a million vertices at once. The object that it returns is the same each time. */
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
