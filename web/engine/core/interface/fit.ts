/** The fit of a result to the modes of its original. */

import type { Charts, MeshInput } from './mesh';
import type { MeshAt } from './simplify';

export interface FitOptions {
  /** of the shell, in units of the mesh; shells half and twice as thick are fitted too */
  thickness: number;
  poisson: number;
  charts: Charts;
  /** whether seams of `charts` stay in place; borders of groups always do */
  keepsSeams: boolean;
  /** per input vertex: not 0 if it must not move; may be empty */
  locked: Uint8Array;
  /** further vertices that must not move; the fitted modes are those of the body pinned there */
  pinned: Uint32Array;
  /** SimplifyConstraints.mirror; a symmetric result stays symmetric */
  mirror?: Uint32Array;
  /** limits that stay satisfied if the result satisfies them: distance from `mesh` in its units, degrees; 0: none */
  maxDeviation: number;
  minAngle: number;
}

/** A result that vibrates like its original, and the RMS frequency error (%) of each fitted part. */
export interface Fitted {
  result: MeshAt;
  errorBefore: Float64Array;
  errorAfter: Float64Array;
  /** number of components of more than 20,000 vertices, fitted at half and twice the thickness in six rounds */
  large: number;
  /** such components that are not fitted: more than 120,000 vertices in the original, or too little memory */
  tooLarge: number;
}

/** The functions of the core on this topic. */
export interface FitFunctions {
  /** moves vertices of the result slightly and flips some edges, so that it vibrates like `mesh` */
  fitModes(mesh: MeshInput, result: MeshAt, options: FitOptions): Fitted;
}
