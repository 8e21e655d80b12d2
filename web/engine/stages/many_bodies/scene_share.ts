/** How large the bodies of a scene are in it, and which of them are too small for their motion to be seen. */

import type { Document, Mesh, Node } from '@gltf-transform/core';
import type { Body } from '../../document/model';

/**
 * Modes guide collapses as if the body swung by 5 % of its own diagonal (GuidanceOptions in wasm/fields/guidance.h). Where that is less
 * than a thousandth of the scene's diagonal, a pixel of a picture that shows the whole scene, nothing of its motion can be seen.
 */
const AMPLITUDE = 0.05;
const VISIBLE = 0.001;

/** Those of the bodies that take part whose motion is too small for their modes to matter. */
export function tooSmallToMove(document: Document, bodies: readonly Body[]): Set<Body> {
  const shares = sharesOfScene(document, bodies);
  return new Set(bodies.filter((_, i) => AMPLITUDE * shares[i] < VISIBLE));
}

/** A box by its low and its high corner. */
interface Box {
  low: number[];
  high: number[];
}

/**
 * Per body its diagonal where it stands, at its largest, over that of all bodies; 1 for bodies whose place is not known: those that joints
 * place, and those that no node shows.
 */
export function sharesOfScene(document: Document, bodies: readonly Body[]): number[] {
  const meshes = document.getRoot().listMeshes();
  const all = emptyBox();
  const nodesOf = nodesByMesh(document);
  const largest = bodies.map((body) => {
    const local = boxOf(body.positions);
    const own = nodesOf.get(meshes[body.mesh]) ?? [];
    const inScene = own.map((node) => boxInScene(local, node));
    inScene.forEach((box) => corners(box).forEach((corner) => include(all, corner)));
    const isShown = own.length > 0 && own.every((node) => node.getSkin() === null);
    return isShown ? inScene.reduce((most, box) => Math.max(most, diagonal(box)), 0) : Infinity;
  });
  const scene = diagonal(all);
  return largest.map((own) => (own < scene ? own / scene : 1));
}

function nodesByMesh(document: Document): Map<Mesh, Node[]> {
  const nodesOf = new Map<Mesh, Node[]>();
  for (const node of document.getRoot().listNodes()) {
    const mesh = node.getMesh();
    if (!mesh) continue;
    const own = nodesOf.get(mesh);
    if (own) own.push(node);
    else nodesOf.set(mesh, [node]);
  }
  return nodesOf;
}

const emptyBox = (): Box => ({
  low: [Infinity, Infinity, Infinity],
  high: [-Infinity, -Infinity, -Infinity],
});

function include({ low, high }: Box, point: ArrayLike<number>, first = 0): void {
  for (let axis = 0; axis < 3; ++axis) {
    low[axis] = Math.min(low[axis], point[first + axis]);
    high[axis] = Math.max(high[axis], point[first + axis]);
  }
}

function boxOf(positions: Float32Array): Box {
  const box = emptyBox();
  for (let i = 0; i < positions.length; i += 3) include(box, positions, i);
  return box;
}

const corners = ({ low, high }: Box): number[][] =>
  Array.from({ length: 8 }, (_, k) => [0, 1, 2].map((axis) => ((k >> axis) & 1 ? high : low)[axis]));

function boxInScene(local: Box, node: Node): Box {
  const m = node.getWorldMatrix();
  const box = emptyBox();
  for (const [x, y, z] of corners(local))
    include(
      box,
      [0, 1, 2].map((row) => m[row] * x + m[4 + row] * y + m[8 + row] * z + m[12 + row]),
    );
  return box;
}

const diagonal = ({ low, high }: Box): number =>
  Math.sqrt([0, 1, 2].reduce((sum, axis) => sum + (high[axis] - low[axis]) ** 2, 0));
