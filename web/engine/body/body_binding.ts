/** Where the vertices of a body lie on its result. */

import type { Binding } from '../core/core';
import { NONE } from '../core/core';
import type { PreparedBody } from './prepared_body';

/** The vertices of one body, numbered as in the original file, on the triangles of its result. */
export interface BodyBinding {
  name: string;
  /** the mesh's number in both files */
  mesh: number;
  /** triangles of the result */
  faces: number;
  /** per vertex of the body; triangle NONE where no usable face uses the vertex */
  binding: Binding;
}

/** Translates a binding of the welded vertices to the vertices of the body. `faces`: those of the result. */
export function bindingOfBody(
  { body, weld }: PreparedBody,
  faces: number,
  { triangle, barycentric, offset }: Binding,
): BodyBinding {
  const { vertexOfSource } = weld;
  const binding: Binding = {
    triangle: vertexOfSource.map((v) => (v === NONE ? NONE : triangle[v])),
    barycentric: new Float32Array(3 * vertexOfSource.length),
    offset: new Float32Array(vertexOfSource.length),
  };
  vertexOfSource.forEach((v, source) => {
    if (v === NONE) return;
    binding.barycentric.set(barycentric.subarray(3 * v, 3 * v + 3), 3 * source);
    binding.offset[source] = offset[v];
  });
  return { name: body.name, mesh: body.mesh, faces, binding };
}
