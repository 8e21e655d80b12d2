/** Bodies that do not come from a file. */

import type { TriangleMesh } from '../../../web/engine/core/core';
import type { Body } from '../../../web/engine/document/open';

export function bodyOf(mesh: TriangleMesh, name = 'body'): Body {
  const { positions, triangles } = mesh;
  return {
    name,
    positions,
    indices: triangles,
    notes: [],
    mesh: 0,
    spans: [{ primitive: 0, first: 0, firstVertex: 0, vertexCount: positions.length / 3 }],
    scale: 1,
  };
}

/** Both meshes as one, with the second translated by 10 along x. */
export function together(first: TriangleMesh, second: TriangleMesh): TriangleMesh {
  const moved = second.positions.map((value, i) => (i % 3 === 0 ? value + 10 : value));
  const offset = first.positions.length / 3;
  return {
    positions: Float32Array.from([...first.positions, ...moved]),
    triangles: Uint32Array.from([...first.triangles, ...second.triangles.map((v) => v + offset)]),
  };
}
