/** The shares of bodies in a scene: which are too small for their motion to be visible, and which have few of its faces. */

import type { Document, Mesh, Node } from '@gltf-transform/core';
import { boundsOf, diagonalOf, sum } from '../../core/mesh';
import type { Bounds } from '../../core/mesh';
import type { Body } from '../../document/model';

/**
 * Modes guide collapses as if the body swung by 5 % of its own diagonal (GuidanceOptions in wasm/fields/guidance.h). Where that is less
 * than a thousandth of the scene's diagonal, about a pixel in a view of the whole scene, its motion is invisible.
 */
const AMPLITUDE = 0.05;
const VISIBLE = 0.001;

/** Those of the bodies that take part whose motion is too small for their modes to matter. */
export function tooSmallToMove(document: Document, bodies: readonly Body[]): Set<Body> {
  const shares = sharesOfScene(document, bodies);
  return new Set(bodies.filter((_, i) => AMPLITUDE * shares[i] < VISIBLE));
}

/**
 * The share of the faces of all bodies below which a body has few: what a search saves there is not worth its time, and at
 * most fifty have more.
 */
const FEW_FACES = 0.02;

/** Those of the bodies that take part whose faces are few beside those of all. */
export function withFewFaces(bodies: readonly Body[]): Set<Body> {
  const all = sum(bodies.map(({ indices }) => indices.length));
  return new Set(bodies.filter(({ indices }) => indices.length < FEW_FACES * all));
}

/**
 * Per body the largest diagonal of its instances over that of all bodies; 1 for bodies of unknown position: those that joints
 * place, and those that no node shows.
 */
export function sharesOfScene(document: Document, bodies: readonly Body[]): number[] {
  const meshes = document.getRoot().listMeshes();
  const nodesOf = nodesByMesh(document);
  const copies = bodies.map(({ mesh, positions }) => {
    const corners = cornersOf(boundsOf(positions));
    return (nodesOf.get(meshes[mesh]) ?? []).map((node) => ({ node, corners: inScene(corners, node) }));
  });
  const scene = diagonalOf(copies.flatMap((own) => own.flatMap(({ corners }) => corners)));
  return copies.map((own) => {
    const isKnown = own.length > 0 && own.every(({ node }) => node.getSkin() === null);
    const largest = own.reduce((most, { corners }) => Math.max(most, diagonalOf(corners)), 0);
    return isKnown && largest < scene ? largest / scene : 1;
  });
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

const cornersOf = ({ low, high }: Bounds): number[][] =>
  Array.from({ length: 8 }, (_, k) => [0, 1, 2].map((axis) => ((k >> axis) & 1 ? high : low)[axis]));

/** The coordinates of points of the node's mesh in the scene, point by point. */
function inScene(points: number[][], node: Node): number[] {
  const m = node.getWorldMatrix();
  return points.flatMap(([x, y, z]) =>
    [0, 1, 2].map((row) => m[row] * x + m[4 + row] * y + m[8 + row] * z + m[12 + row]),
  );
}
