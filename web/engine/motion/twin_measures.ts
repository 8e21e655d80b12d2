/** How alike two bodies in motion are: deviation through the binding, stretch, and whether one has flown apart. */

import type { Binding, TriangleMesh } from '../core/core';
import { NONE } from '../core/core';
import { length3 } from '../core/exact_math';

/** A body that has grown to this many times its size is no body any more. */
export const EXPLODED_EXTENT = 10;

/** The diagonal of the bounding box; NaN where a coordinate is not finite. */
export function extentOf(positions: Float32Array): number {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let at = 0; at < positions.length; at += 3)
    for (let c = 0; c < 3; ++c) {
      const value = positions[at + c];
      if (!Number.isFinite(value)) return NaN;
      if (value < low[c]) low[c] = value;
      if (value > high[c]) high[c] = value;
    }
  return positions.length > 0 ? length3(high[0] - low[0], high[1] - low[1], high[2] - low[2]) : 0;
}

/** Whether a body of this diagonal at rest has flown apart. */
export const hasExploded = (positions: Float32Array, diagonal: number): boolean =>
  !(extentOf(positions) <= EXPLODED_EXTENT * diagonal);

/** Edges of a mesh, each once: vertices edges[2 * e], edges[2 * e + 1], the lower first. */
export function edgesOf({ positions, triangles }: TriangleMesh): Uint32Array {
  const count = positions.length / 3;
  const keys = new Float64Array(triangles.length);
  triangles.forEach((a, corner) => {
    const b = triangles[corner % 3 === 2 ? corner - 2 : corner + 1];
    keys[corner] = Math.min(a, b) * count + Math.max(a, b);
  });
  keys.sort();
  const unique = keys.filter((key, i) => i === 0 || key !== keys[i - 1]);
  const edges = new Uint32Array(2 * unique.length);
  unique.forEach((key, e) => edges.set([Math.floor(key / count), key % count], 2 * e));
  return edges;
}

const lengthOf = (positions: Float32Array, edges: Uint32Array, e: number): number => {
  const [a, b] = [3 * edges[2 * e], 3 * edges[2 * e + 1]];
  return length3(
    positions[a] - positions[b],
    positions[a + 1] - positions[b + 1],
    positions[a + 2] - positions[b + 2],
  );
};

/** How far the edges of a body are from their lengths at rest. */
export class Stretch {
  private readonly edges: Uint32Array;
  private readonly rest: Float64Array;

  constructor(mesh: TriangleMesh) {
    this.edges = edgesOf(mesh);
    this.rest = Float64Array.from({ length: this.edges.length / 2 }, (_, e) =>
      lengthOf(mesh.positions, this.edges, e),
    );
  }

  /** Mean over the edges of | length / length at rest - 1 |, in %. */
  mean(positions: Float32Array): number {
    let [sum, counted] = [0, 0];
    this.rest.forEach((rest, e) => {
      if (!(rest > 0)) return;
      sum += Math.abs(lengthOf(positions, this.edges, e) / rest - 1);
      counted += 1;
    });
    return counted > 0 ? (100 * sum) / counted : 0;
  }
}

/** A third of the area of its triangles for every vertex, in units of the mesh, squared. */
export function vertexAreas({ positions, triangles }: TriangleMesh): Float64Array {
  const areas = new Float64Array(positions.length / 3);
  for (let t = 0; t < triangles.length; t += 3) {
    const third = length3(...crossOf(positions, triangles, t)) / 6;
    for (let k = 0; k < 3; ++k) areas[triangles[t + k]] += third;
  }
  return areas;
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

/**
 * The original's vertices on the optimized body, out[3 * v + c]: the bound points, and with `offsets` lifted off their
 * triangles by the heights that the binding knows, as a game does that draws the one mesh and simulates the other.
 * A vertex that is not bound stays at `rest`.
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
      let place = 0;
      for (let k = 0; k < 3; ++k) place += barycentric[3 * v + k] * positions[3 * triangles[3 * t + k] + c];
      out[3 * v + c] = place;
    }
    if (!offsets || offset[v] === 0) return;
    const normal = crossOf(positions, triangles, 3 * t);
    const length = length3(...normal);
    if (length > 0) for (let c = 0; c < 3; ++c) out[3 * v + c] += (offset[v] * normal[c]) / length;
  });
  return out;
}

/** Means are over the surface of the original. All in % of its diagonal. */
export interface DeviationNow {
  mean: number;
  max: number;
  /** per vertex */
  values: Float32Array;
}

/** How differently the original's surface is displaced in two bodies that move. */
export class Deviation {
  private readonly areas: Float64Array;
  private readonly total: number;

  /** `restOther`: where the original's vertices lie on the other body at rest. */
  constructor(
    private readonly original: TriangleMesh,
    private readonly restOther: Float32Array,
    private readonly diagonal: number,
  ) {
    this.areas = vertexAreas(original);
    this.total = this.areas.reduce((sum, area) => sum + area, 0);
  }

  /** `now`: the original's vertices; `other`: the same on the other body. */
  between(now: Float32Array, other: Float32Array): DeviationNow {
    const { positions: rest } = this.original;
    const values = new Float32Array(this.areas.length);
    let [mean, max] = [0, 0];
    for (let v = 0; v < values.length; ++v) {
      const apart = (c: number): number =>
        now[3 * v + c] - rest[3 * v + c] - (other[3 * v + c] - this.restOther[3 * v + c]);
      values[v] = (100 * length3(apart(0), apart(1), apart(2))) / this.diagonal;
      mean += (this.areas[v] / this.total) * values[v];
      max = Math.max(max, values[v]);
    }
    return { mean, max, values };
  }
}
