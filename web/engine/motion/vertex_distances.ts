/**
 * The distance of each vertex of the original from its bound point on the optimized body: only for the colours of the viewport.
 * The deviation that is reported is measured in the core, see wasm/compare/motion_deviation.h.
 */

import type { Binding, TriangleMesh } from '../core/core';
import { NONE } from '../core/core';
import { length3 } from '../core/exact_math';

/**
 * The original's vertices on the optimized body, out[3 * v + c], while its vertices are at `positions`: the bound points,
 * and with `offsets` raised above their triangles by the heights of the binding, as in a game that draws the original and
 * simulates the optimized mesh. A vertex that is not bound stays at `rest`.
 */
export function boundPositions(
  { triangle, barycentric, offset }: Binding,
  { triangles }: TriangleMesh,
  positions: Float32Array,
  { rest, offsets }: { rest: Float32Array; offsets: boolean },
): Float32Array {
  const out = rest.slice();
  triangle.forEach((t, v) => {
    if (t === NONE) return;
    for (let c = 0; c < 3; ++c) {
      let sum = 0;
      for (let k = 0; k < 3; ++k) sum += barycentric[3 * v + k] * positions[3 * triangles[3 * t + k] + c];
      out[3 * v + c] = sum;
    }
    if (!offsets || offset[v] === 0) return;
    const normal = crossOf(positions, triangles, 3 * t);
    const length = length3(...normal);
    if (length > 0) for (let c = 0; c < 3; ++c) out[3 * v + c] += (offset[v] * normal[c]) / length;
  });
  return out;
}

/** Twice the area times the normal of the triangle whose first corner is `first`. */
function crossOf(positions: Float32Array, triangles: Uint32Array, first: number): [number, number, number] {
  const [a, b, c] = [3 * triangles[first], 3 * triangles[first + 1], 3 * triangles[first + 2]];
  const [ux, uy, uz] = [
    positions[b] - positions[a],
    positions[b + 1] - positions[a + 1],
    positions[b + 2] - positions[a + 2],
  ];
  const [vx, vy, vz] = [
    positions[c] - positions[a],
    positions[c + 1] - positions[a + 1],
    positions[c + 2] - positions[a + 2],
  ];
  return [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
}

/** Compares the displacements of the original's vertices in two bodies that move. */
export class VertexDistances {
  /** `rest` and `restOther`: where the original's vertices are at rest, by themselves and on the other body. */
  constructor(
    private readonly rest: Float32Array,
    private readonly restOther: Float32Array,
    private readonly diagonal: number,
  ) {}

  /** Per vertex, in % of the diagonal. `now` and `other` are the present positions, as at rest. */
  between(now: Float32Array, other: Float32Array): Float32Array {
    const { rest, restOther } = this;
    const values = new Float32Array(rest.length / 3);
    for (let v = 0; v < values.length; ++v) {
      const apart = (c: number): number =>
        now[3 * v + c] - rest[3 * v + c] - (other[3 * v + c] - restOther[3 * v + c]);
      values[v] = (100 * length3(apart(0), apart(1), apart(2))) / this.diagonal;
    }
    return values;
  }
}
