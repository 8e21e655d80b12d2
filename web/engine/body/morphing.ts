/** Where the morph targets of a file take the vertices of a body. */

import type { Document } from '@gltf-transform/core';
import type { Body } from '../document/model';
import type { PosedPositions } from './skinning';

/** Limits on the morph targets that are used, those that move vertices the most: their number, and their coordinates in all. */
const MAX_TARGETS = 64;
const MAX_COORDINATES = 2 ** 24;

/** The body with each of its morph targets alone, at its full weight; none where it has no targets. Deterministic. */
export function posesOfTargets(document: Document, body: Body): PosedPositions[] {
  const primitives = document.getRoot().listMeshes()[body.mesh].listPrimitives();
  const counts = body.spans.map(({ primitive }) => primitives[primitive].listTargets().length);
  const targets = Array.from({ length: Math.max(0, ...counts) }, (_, target) => target);
  const moves = targets.map((target) => ({ target, move: moveOf(document, body, target) }));
  const most = Math.min(MAX_TARGETS, Math.max(1, Math.floor(MAX_COORDINATES / body.positions.length)));
  return moves
    .filter(({ move }) => move > 0)
    .sort((a, b) => b.move - a.move || a.target - b.target)
    .slice(0, most)
    .map(({ target }) => morphed(document, body, target));
}

/** The sum of the squared displacements of a target, in squared units of the mesh. */
function moveOf(document: Document, body: Body, target: number): number {
  let sum = 0;
  forEachDisplacement(document, body, target, (_vertex, [x, y, z]) => (sum += x * x + y * y + z * z));
  return sum;
}

function morphed(document: Document, body: Body, target: number): PosedPositions {
  const posed = Float64Array.from(body.positions);
  forEachDisplacement(document, body, target, (vertex, displacement) =>
    displacement.forEach((value, c) => (posed[3 * vertex + c] += value)),
  );
  return posed;
}

function forEachDisplacement(
  document: Document,
  body: Body,
  target: number,
  use: (vertex: number, displacement: number[]) => void,
): void {
  const primitives = document.getRoot().listMeshes()[body.mesh].listPrimitives();
  for (const { primitive, firstVertex } of body.spans) {
    const positions = primitives[primitive].listTargets()[target]?.getAttribute('POSITION');
    if (!positions) continue;
    const element: number[] = [];
    for (let v = 0; v < positions.getCount(); ++v) use(firstVertex + v, positions.getElement(v, element));
  }
}
