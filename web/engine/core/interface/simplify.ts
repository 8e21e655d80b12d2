/** Simplification: the history of collapses, and the mesh at any point in it. */

import type { Method } from '../methods';
import type { MeshInput, TriangleMesh } from './mesh';

export const BORDERS = ['free', 'fixed'] as const;

/** The largest number of values per wedge in SimplifyConstraints.attributes. */
export const ATTRIBUTE_LIMIT = 8;

/** What a simplification respects besides the surface; see wasm/simplify/constraints.h. Every list is optional. */
export interface SimplifyConstraints {
  /** wedges[3 * t + corner]: equal for corners at a vertex that have equal attributes */
  wedges?: Uint32Array;
  /** per triangle: its primitive or material */
  groups?: Uint32Array;
  /** per vertex: not 0 if it must be neither moved nor removed */
  locked?: Uint8Array;
  /** per vertex, in [0, 1]: costs are multiplied by 1 + 99 keep */
  keep?: Float32Array;
  /** per vertex: bit k is set in members of set k; surviving vertices keep the sets, see MeshAt.inputOfVertex */
  pinnedSets?: Uint32Array;
  /** attributes[wedge * attributeDimension + i] (per vertex without wedges); 1 weighs as much as the diagonal */
  attributes?: Float32Array;
  /** per triangle, in [0, 1]: the factor on the error of texture coordinates, the first two attributes, and of seams; absent: 1 */
  textureWeights?: Float32Array;
  /** 1 to ATTRIBUTE_LIMIT */
  attributeDimension?: number;
  /** the last 3 * displacementFields attributes are coordinates of displacements: only their component across the surface counts */
  displacementFields?: number;
  /** per vertex: its mirror image, on the plane of symmetry the vertex itself; both sides collapse together */
  mirror?: Uint32Array;
  /** degrees between face normals above which an edge is a crease; 0: no creases */
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
  /** s of limber; for qem the weight of an edge's squared length */
  sizeWeight?: number;
  /** the history ends once at most this many triangles are left */
  stopFaces?: number;
  /** refuses collapses that take the surface farther from the input; units of the mesh; 0: no limit */
  maxDeviation?: number;
  /** refuses collapses that create an angle below this (degrees) where there was none; 0: no limit */
  minAngle?: number;
  /** whether the history gets `errors` */
  recordErrors?: boolean;
  /** collapses that are estimated to go farther from the input than this are deferred until no other is left, then this limit doubles; units of the mesh; 0: none is deferred */
  deferBeyond?: number;
  constraints?: SimplifyConstraints;
}

/** Counts of the edges left that cannot collapse, by first reason; all 0 if the history ended at stopFaces. */
export interface Refused {
  topology: number;
  flip: number;
  lock: number;
  /** an angle below `minAngle` would result */
  angle: number;
  /** the surface would be farther than `maxDeviation` from the input */
  deviation: number;
}

/** Why a history ends, in the order of `enum class StopReason` in wasm/simplify/history.h. */
export const STOP_REASONS = ['target', 'deviation', 'angle', 'exhausted'] as const;

/** All collapses in order. Collapse i merges vertex removed[i] into kept[i] and moves it to positions[3 * i + c]. */
export interface History {
  vertexCount: number;
  triangleCount: number;
  kept: Uint32Array;
  removed: Uint32Array;
  positions: Float32Array;
  /** triangles left after collapse i, descending */
  trianglesAfter: Uint32Array;
  /** per collapse an estimate of how far it has taken the surface from the input, in units of the mesh; empty unless asked for */
  errors?: Float32Array;
  refused: Refused;
  /** why the history ends */
  stop: (typeof STOP_REASONS)[number];
  /** SimplifyConstraints.mirror if it was given; collapses then come in pairs */
  mirror?: Uint32Array;
}

/** In the order of `enum class Verdict` in wasm/simplify/legality.h. */
export const VERDICTS = ['legal', 'lock', 'topology', 'flip', 'angle', 'deviation'] as const;

/**
 * Why each vertex of a MeshAt is kept: the cost terms of the cheapest collapse among its edges, where legal ones come first.
 * The cost is (error + size + strain + curvature + quality) * keep; see `struct CostTerms` in wasm/simplify/cost.h.
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
  /** an index into VERDICTS */
  verdict: Uint8Array;
}

/** Edges flipped after the history; both arrays are empty if there are none. */
export interface Flips {
  /** the triangles as the history left them */
  triangles: Uint32Array;
  /** per corner after the flips: the corner (3 * t + c) of `triangles` that it was */
  corners: Uint32Array;
}

export interface MeshAt {
  mesh: TriangleMesh;
  /** per input vertex: the vertex of `mesh` that it was merged into */
  vertexOfInput: Uint32Array;
  /** per vertex of `mesh`: the input vertex that survived as this vertex */
  inputOfVertex: Uint32Array;
  /** per triangle of `mesh`: its input triangle */
  inputOfTriangle: Uint32Array;
  flips: Flips;
}

/** A history that the core keeps; see `keepHistory`. */
export interface HistoryHandle {
  readonly handle: number;
}

/** A history as plain data, or one that the core keeps. */
export type HistoryInput = History | HistoryHandle;

/** A history with all of its inputs. */
export interface Reduction {
  mesh: MeshInput;
  strain: Float32Array;
  curvature: Float32Array;
  options: SimplifyOptions;
  history: HistoryInput;
}

/** The functions of the core on this topic. */
export interface SimplifyFunctions {
  /** strain: rank per triangle; curvature: per vertex, relative to its maximum; empty arrays count as 0 */
  simplify(mesh: MeshInput, strain: Float32Array, curvature: Float32Array, options: SimplifyOptions): History;
  /** the largest mesh of the history with at most `faces` triangles */
  meshAt(mesh: MeshInput, history: HistoryInput, faces: number): MeshAt;
  /** one entry per vertex of meshAt(mesh, history, faces) of the reduction */
  whyKept(reduction: Reduction, faces: number): WhyKept;
  /** copies a history into the core, which keeps it until `releaseHistory` */
  keepHistory(history: History): HistoryHandle;
  releaseHistory(handle: HistoryHandle): null;
}
