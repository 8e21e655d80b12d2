/** The triangles of a model as they stand in its scene. */

import type { Node } from '@gltf-transform/core';
import type { Body, OpenModel } from '../../../engine/document/open';

/** What a picture of a model is drawn from; more would take longer than a small picture is good for. */
const MAX_NUMBERS = 9 * 4_000_000;

/** Corners in the scene, `positions[9 t + 3 corner + c]`. Of bodies that no node shows, as they are. */
export function sceneTriangles({ document, bodies }: OpenModel): Float32Array {
  const meshes = document.getRoot().listMeshes();
  const shown = document
    .getRoot()
    .listNodes()
    .flatMap((node) => {
      const mesh = node.getMesh();
      const body = mesh && bodies.find((one) => meshes[one.mesh] === mesh);
      return body ? [{ node, body }] : [];
    });
  const all: { node: Node | null; body: Body }[] =
    shown.length > 0 ? shown : bodies.map((body) => ({ node: null, body }));
  const numbers = all.reduce((sum, { body }) => sum + 3 * body.indices.length, 0);
  const positions = new Float32Array(Math.min(numbers, MAX_NUMBERS));
  let at = 0;
  for (const { node, body } of all) at = write(body, node?.getWorldMatrix() ?? null, { positions, at });
  return positions;
}

/** Writes from `at`, as far as there is room; returns where it ended. `m`: column by column, null: as it is. */
function write(
  { positions: own, indices }: Body,
  m: ArrayLike<number> | null,
  { positions, at }: { positions: Float32Array; at: number },
): number {
  for (const vertex of indices) {
    if (at >= positions.length) break;
    const [x, y, z] = [own[3 * vertex], own[3 * vertex + 1], own[3 * vertex + 2]];
    for (let c = 0; c < 3; ++c)
      positions[at++] = m ? m[c] * x + m[4 + c] * y + m[8 + c] * z + m[12 + c] : [x, y, z][c];
  }
  return at;
}
