/** Where the vertices of a body lie on its result. */

import type { Binding, TriangleMesh } from '../core/core';
import { NONE } from '../core/core';
import { faceCount } from '../core/mesh';
import type { Body } from '../document/model';
import { spanOf } from '../document/facts/spans';
import type { PreparedBody } from './prepared_body';

/** The vertices of one body, numbered as in the original file, on the triangles of its result, numbered as in the written file. */
export interface BodyBinding {
  name: string;
  /** the mesh's number in both files */
  mesh: number;
  /** triangles of the written file */
  faces: number;
  /** per vertex of the body; triangle NONE where no usable face uses the vertex */
  binding: Binding;
}

/** A result as it is written: its first triangles are those of the result, further layers follow. */
export interface WrittenResult {
  mesh: TriangleMesh;
  /** per triangle: the triangle of the body that it comes from */
  inputOfTriangle: Uint32Array;
}

/** Translates a binding of the welded vertices on `result` to the vertices of the body on the written triangles. */
export function bindingOfBody(
  { body, weld }: PreparedBody,
  result: TriangleMesh,
  written: WrittenResult,
  { triangle, barycentric, offset }: Binding,
): BodyBinding {
  const { vertexOfSource } = weld;
  const numbers = numbersInFile(body, written.inputOfTriangle);
  const binding: Binding = {
    triangle: vertexOfSource.map((v) => (v === NONE ? NONE : numbers[triangle[v]])),
    barycentric: new Float32Array(3 * vertexOfSource.length),
    offset: new Float32Array(vertexOfSource.length),
  };
  vertexOfSource.forEach((v, source) => {
    if (v === NONE) return;
    const corners = cornersOf(result.triangles, written.mesh.triangles, triangle[v]);
    corners.forEach((from, k) => (binding.barycentric[3 * source + k] = barycentric[3 * v + from]));
    // A triangle with reversed winding in the file has its normal on the other side.
    const isTurned = (corners[1] - corners[0] + 3) % 3 !== 1;
    binding.offset[source] = isTurned ? -offset[v] : offset[v];
  });
  return { name: body.name, mesh: body.mesh, faces: faceCount(written.mesh), binding };
}

/** Per written triangle: its number in the file, which lists one primitive after the other. */
function numbersInFile(body: Body, inputOfTriangle: Uint32Array): Uint32Array {
  const spans = inputOfTriangle.map((input) => spanOf(body, input));
  const next = new Uint32Array(body.spans.length + 1);
  for (const span of spans) next[span + 1] += 1;
  for (let span = 0; span < body.spans.length; ++span) next[span + 1] += next[span];
  return spans.map((span) => next[span]++);
}

/** Which corner of triangle t of the result is at each corner of the written one. */
const cornersOf = (result: Uint32Array, written: Uint32Array, t: number): number[] =>
  [0, 1, 2].map((k) => [0, 1, 2].find((c) => result[3 * t + c] === written[3 * t + k]) ?? k);
