/** Maps between an original and its result. */

import type { Charts, MeshInput, SurfacePoint } from './mesh';
import type { MeshAt } from './simplify';

/** The points of the input that the attributes of a result's corners come from; see wasm/transfer/corner_sources.h. */
export interface CornerSources {
  /** per corner 3 * t + k: a triangle of the input */
  triangle: Uint32Array;
  /** barycentric[3 * corner + c] on that triangle */
  barycentric: Float32Array;
}

/** The point of a result that each vertex of the input is bound to. */
export interface Binding {
  /** per input vertex: a triangle of the result, or NONE if no input triangle uses the vertex */
  triangle: Uint32Array;
  /** barycentric[3 * v + c] */
  barycentric: Float32Array;
  /** height above the triangle's plane, outwards, in units of the mesh */
  offset: Float32Array;
}

/** The functions of the core on this topic. */
export interface TransferFunctions {
  /** finds the sources of the attributes of a result's corners without crossing a seam */
  sourceOfCorners(mesh: MeshInput, charts: Charts, result: MeshAt): CornerSources;
  /** binds every vertex of `mesh` to `result`, whose vertices may have moved since the history created it */
  bindToResult(mesh: MeshInput, result: MeshAt): Binding;
  /**
   * The vertices of `result` that pins of the original stand for, ascending, by closest points at rest; a pin inside a triangle
   * becomes the vertex with the largest share of it. See wasm/transfer/carry_pins.h.
   */
  carryPins(original: MeshInput, pinned: Uint32Array, result: MeshInput): Uint32Array;
  /** the point closest to `point` on the triangles of the list; an empty list stands for all of them */
  closestPoint(mesh: MeshInput, triangles: Uint32Array, point: [number, number, number]): SurfacePoint;
}
