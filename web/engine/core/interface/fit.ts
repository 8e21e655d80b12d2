/** The fit of a result to the modes of its original. */

import type { Charts, MeshInput } from './mesh';
import type { MeshAt } from './simplify';

export interface FitOptions {
  /** of the shell, in units of the mesh; half and twice as thick ones count too */
  thickness: number;
  poisson: number;
  charts: Charts;
  /** whether their seams stay in place; those of groups always do */
  keepsSeams: boolean;
  /** per input vertex: not 0 where it stays; may be empty */
  locked: Uint8Array;
  /** vertices that stay too; the modes of the body pinned there are fitted */
  pinned: Uint32Array;
  /** SimplifyConstraints.mirror: a result that is its own image stays one */
  mirror?: Uint32Array;
  /** what the result keeps, where it does so already: distance from `mesh`, in its units, and degrees; 0 sets no limit */
  maxDeviation: number;
  minAngle: number;
}

/** A result that vibrates like its original; frequency errors (root mean square, %) of each part that was fitted. */
export interface Fitted {
  result: MeshAt;
  errorBefore: Float64Array;
  errorAfter: Float64Array;
  /** components of more than 20,000 vertices, which are fitted at half and twice the thickness, in six rounds */
  large: number;
  /** such components that stay as they are: the original has more than 120,000 vertices there, or memory is short */
  tooLarge: number;
}

/** The functions of the core on this topic. */
export interface FitFunctions {
  /** the result with its vertices moved a little and some edges flipped, so that it vibrates like `mesh` */
  fitModes(mesh: MeshInput, result: MeshAt, options: FitOptions): Fitted;
}
