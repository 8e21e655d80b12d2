/** Lists of vertices as masks. */

import type { TriangleMesh } from '../core/core';
import { vertexCount } from '../core/mesh';

/** Per vertex of the mesh: 1 for those in any of the lists; undefined where the lists are all empty or absent. */
export function maskOf(mesh: TriangleMesh, ...lists: (Uint32Array | undefined)[]): Uint8Array | undefined {
  if (lists.every((vertices) => !vertices?.length)) return undefined;
  const mask = new Uint8Array(vertexCount(mesh));
  for (const vertices of lists) vertices?.forEach((vertex) => (mask[vertex] = 1));
  return mask;
}
