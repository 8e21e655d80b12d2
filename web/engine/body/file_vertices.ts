/** The vertices of a body in the order of its file: all of one primitive after all of another. */

import { NONE } from '../core/core';
import type { Body } from '../document/model';
import type { PreparedBody } from './prepared_body';

/** Vertices of the body. A list that several primitives share is repeated for each of them. */
export const verticesInFile = ({ spans }: Pick<Body, 'spans'>): number[] =>
  spans.flatMap(({ firstVertex, vertexCount }) =>
    Array.from({ length: vertexCount }, (_, v) => firstVertex + v),
  );

/** The same vertices by their numbers in the welded mesh; -1 for vertices of no usable face. */
export const weldedVerticesInFile = ({ weld, body }: PreparedBody): number[] =>
  verticesInFile(body).map((v) => (weld.vertexOfSource[v] === NONE ? -1 : weld.vertexOfSource[v]));

/** positions[3 v + c] of the welded mesh, in the local space of its mesh in the file. */
export function positionsInFile({ weld, body, mesh }: PreparedBody): Float32Array {
  if (!body.own) return mesh.positions;
  const { positions } = body.own;
  const found = new Float32Array(mesh.positions.length);
  weld.vertexOfSource.forEach((vertex, source) => {
    if (vertex !== NONE) found.set(positions.subarray(3 * source, 3 * source + 3), 3 * vertex);
  });
  return found;
}
