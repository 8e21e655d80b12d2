/** What is carried from an original to its result. */

import type { Charts, MeshInput, SurfacePoint } from './mesh';
import type { MeshAt } from './simplify';

/** Where on the input the attributes of corner 3 * t + k of a result come from; see wasm/transfer/corner_sources.h. */
export interface CornerSources {
  /** a triangle of the input */
  triangle: Uint32Array;
  /** barycentric[3 * corner + c] on it */
  barycentric: Float32Array;
}

/** Where each vertex of the input lies on a result. */
export interface Binding {
  /** of the result, per input vertex; NONE where no triangle used it */
  triangle: Uint32Array;
  /** barycentric[3 * v + c] */
  barycentric: Float32Array;
  /** height above the triangle's plane, outwards, in units of the mesh */
  offset: Float32Array;
}

/** The functions of the core on this topic. */
export interface TransferFunctions {
  /** where the attributes of a result's corners come from, without crossing a seam */
  sourceOfCorners(mesh: MeshInput, charts: Charts, result: MeshAt): CornerSources;
  /** every vertex of `mesh` on `result`, whose vertices may have moved since the history made it */
  bindToResult(mesh: MeshInput, result: MeshAt): Binding;
  /** the point closest to `point` on the triangles of the list; an empty list stands for all of them */
  closestPoint(mesh: MeshInput, triangles: Uint32Array, point: [number, number, number]): SurfacePoint;
}
