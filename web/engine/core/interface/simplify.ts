/** Simplification: the history of collapses, and the mesh at any point of it. */

import type { Method } from '../methods';
import type { MeshInput, TriangleMesh } from './mesh';

export const BORDERS = ['free', 'fixed'] as const;

/** The most values a wedge can have in SimplifyConstraints.attributes. */
export const ATTRIBUTE_LIMIT = 8;

/** What a simplification has to respect besides the surface; see wasm/simplify/constraints.h. Every list may be left out. */
export interface SimplifyConstraints {
  /** wedges[3 * t + corner]: equal at a vertex where all attributes are */
  wedges?: Uint32Array;
  /** per triangle: its primitive or material */
  groups?: Uint32Array;
  /** per vertex: not 0 where it may be neither moved nor removed */
  locked?: Uint8Array;
  /** per vertex, in [0, 1]: costs are multiplied by 1 + 99 keep */
  keep?: Float32Array;
  /** per vertex: bit k is set in the members of set k; survivors carry the sets, see MeshAt.inputOfVertex */
  pinnedSets?: Uint32Array;
  /** attributes[wedge * attributeDimension + i] (per vertex without wedges); 1 weighs as much as the bounding diagonal */
  attributes?: Float32Array;
  /** 1 to ATTRIBUTE_LIMIT */
  attributeDimension?: number;
  /** per vertex: its mirror image, itself on the plane of symmetry; both sides then collapse together */
  mirror?: Uint32Array;
  /** degrees; edges that bend more are creases; 0: none */
  creaseAngle?: number;
  borders?: (typeof BORDERS)[number];
}

export interface SimplifyOptions {
  method: Method;
  /** alpha of Eq. 11; w of limber */
  strainWeight: number;
  /** beta */
  curvatureWeight: number;
  /** gamma; g of limber */
  qualityWeight: number;
  /** s of limber; of an edge's squared length for qem */
  sizeWeight?: number;
  /** ends the history as soon as no more are left */
  stopFaces?: number;
  /** refuses collapses that take the surface farther from the input: a length in units of the mesh; 0: none */
  maxDeviation?: number;
  /** refuses collapses that make an angle smaller than this (degrees) where there was none; 0: none */
  minAngle?: number;
  constraints?: SimplifyConstraints;
}

/** Why the edges left at the end cannot collapse, each under its first reason; all 0 where the history ended at stopFaces. */
export interface Refused {
  topology: number;
  flip: number;
  lock: number;
  /** an angle below `minAngle` would come into being */
  angle: number;
  /** the surface would be farther than `maxDeviation` from the input */
  deviation: number;
}

/** Why a history ends, in the order of `enum class StopReason` in wasm/simplify/history.h. */
export const STOP_REASONS = ['target', 'deviation', 'angle', 'exhausted'] as const;

/** Every collapse down to its end. Collapse i moves vertex kept[i] to positions[3 * i + c] and takes in removed[i]. */
export interface History {
  vertexCount: number;
  triangleCount: number;
  kept: Uint32Array;
  removed: Uint32Array;
  positions: Float32Array;
  /** triangles left after collapse i, descending */
  trianglesAfter: Uint32Array;
  refused: Refused;
  /** why it ends */
  stop: (typeof STOP_REASONS)[number];
  /** SimplifyConstraints.mirror, where it was among the constraints: collapses then come in pairs */
  mirror?: Uint32Array;
}

/** In the order of `enum class Verdict` in wasm/simplify/legality.h. */
export const VERDICTS = ['legal', 'lock', 'topology', 'flip', 'angle', 'deviation'] as const;

/**
 * What speaks for each vertex of a MeshAt: the terms of the cheapest collapse among its edges, legal ones first. The cost is
 * (error + size + strain + curvature + quality) * keep; see `struct CostTerms` in wasm/simplify/cost.h.
 */
export interface WhyKept {
  error: Float32Array;
  size: Float32Array;
  strain: Float32Array;
  curvature: Float32Array;
  quality: Float32Array;
  keep: Float32Array;
  /** the vertex at the other end, or 0xffffffff */
  neighbour: Uint32Array;
  /** an index of VERDICTS */
  verdict: Uint8Array;
}

/** Edges flipped after the history; both empty where there are none. */
export interface Flips {
  /** the triangles as the history left them */
  triangles: Uint32Array;
  /** per corner now: the corner (3 * t + c) of those that it has been */
  corners: Uint32Array;
}

export interface MeshAt {
  mesh: TriangleMesh;
  /** per input vertex: the vertex of `mesh` that it has become */
  vertexOfInput: Uint32Array;
  /** per vertex of `mesh`: the input vertex that has survived as it */
  inputOfVertex: Uint32Array;
  /** per triangle of `mesh`: which input triangle it is */
  inputOfTriangle: Uint32Array;
  flips: Flips;
}

/** A history that the core keeps; see `keepHistory`. */
export interface HistoryHandle {
  readonly handle: number;
}

/** A history as plain data, or one that the core keeps. */
export type HistoryInput = History | HistoryHandle;

/** A history with everything that it was made from. */
export interface Reduction {
  mesh: MeshInput;
  strain: Float32Array;
  curvature: Float32Array;
  options: SimplifyOptions;
  history: HistoryInput;
}

/** The functions of the core on this topic. */
export interface SimplifyFunctions {
  /** strain: rank per triangle; curvature: per vertex, over its maximum; empty arrays count as 0 */
  simplify(mesh: MeshInput, strain: Float32Array, curvature: Float32Array, options: SimplifyOptions): History;
  /** the largest mesh of the history with at most `faces` triangles */
  meshAt(mesh: MeshInput, history: HistoryInput, faces: number): MeshAt;
  /** for every vertex of meshAt(mesh, history, faces) of the reduction */
  whyKept(reduction: Reduction, faces: number): WhyKept;
  /** copies a history into the core, which keeps it until `releaseHistory` */
  keepHistory(history: History): HistoryHandle;
  releaseHistory(handle: HistoryHandle): null;
}
