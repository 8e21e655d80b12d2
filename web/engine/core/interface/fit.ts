/** The fits of a result to its original: to the surface alone, or to the modes as well. */

import type { Charts, MeshInput } from './mesh';
import type { MeshAt } from './simplify';

/** What a fit has to respect. */
export interface ShapeFitOptions {
  charts: Charts;
  /** whether seams of `charts` stay in place; borders of groups always do */
  keepsSeams: boolean;
  /** per input vertex: not 0 if it must not move; may be empty */
  locked: Uint8Array;
  /** further vertices that must not move */
  pinned: Uint32Array;
  /** SimplifyConstraints.mirror; a symmetric result stays symmetric */
  mirror?: Uint32Array;
  /** limits that stay satisfied if the result satisfies them: distance from `mesh` in its units, degrees; 0: none */
  maxDeviation: number;
  minAngle: number;
  /** points of each surface at which a fit to the surface judges the deviation; 0 or absent: as many as a body needs */
  samples?: number;
}

/** Options of a fit to the modes of the body pinned at `pinned`. */
export interface FitOptions extends ShapeFitOptions {
  /** of the shell, in units of the mesh; shells half and twice as thick are fitted too */
  thickness: number;
  poisson: number;
}

/** A result fitted to the surface of its original. */
export interface ShapeFitted {
  result: MeshAt;
  /** number of flipped edges */
  flips: number;
}

/** A result fitted to the modes of its original, and the RMS frequency error (%) of each fitted part. */
export interface Fitted extends ShapeFitted {
  errorBefore: Float64Array;
  errorAfter: Float64Array;
  /** number of components of more than 20,000 vertices, fitted at half and twice the thickness in six rounds */
  large: number;
  /** such components that are not fitted: more than 120,000 vertices in the original, or too little memory */
  tooLarge: number;
}

/** The functions of the core on this topic. */
export interface FitFunctions {
  /** flips some edges and moves vertices of the result to the surface of `mesh`; keeps its outline, corners and area */
  fitShape(mesh: MeshInput, result: MeshAt, options: ShapeFitOptions): ShapeFitted;
  /** moves vertices of the result slightly and flips some edges, so that it vibrates like `mesh` */
  fitModes(mesh: MeshInput, result: MeshAt, options: FitOptions): Fitted;
}
