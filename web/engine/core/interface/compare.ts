/** How alike two meshes are: surface distance and frequencies. */

import type { ElasticMaterial } from './material';
import type { MeshInput } from './mesh';

/** In units of the mesh. */
export interface SurfaceDistance {
  hausdorff: number;
  mean: number;
  vertexHausdorff: number;
}

export interface FidelityOptions extends ElasticMaterial {
  /** compared modes, at least 1 */
  modeCount: number;
}

/** Errors in %; the keys of the report. */
export interface Fidelity {
  frequencyErrorMean: number;
  frequencyErrorMax: number;
  frequencyErrorCalibrated: number;
  calibrationFactor: number;
  frequencyErrorThin: number;
  frequencyErrorThick: number;
  frequencyErrorHigh: number;
  macMean: number;
  macMin: number;
}

/** The lowest elastic modes of a body's shell over all of its parts. */
export interface ShellModes {
  /** rad/s, ascending */
  omega: Float64Array;
  /** shapes[(k * vertexCount + v) * 3 + c] */
  shapes: Float32Array;
}

/** The functions of the core on this topic. */
export interface CompareFunctions {
  measureSurfaceDistance(a: MeshInput, b: MeshInput): SurfaceDistance;
  compareFidelity(original: MeshInput, other: MeshInput, options: FidelityOptions): Fidelity;
  /** twice options.modeCount modes of the original, for frequencyErrors */
  shellModes(original: MeshInput, options: FidelityOptions): ShellModes;
  /** frequencyErrorMean and frequencyErrorMax of compareFidelity alone, in %: a sixth of its work */
  frequencyErrors(
    original: MeshInput,
    modes: ShellModes,
    other: MeshInput,
    options: FidelityOptions,
  ): { mean: number; max: number };
  /** that of compareFidelity alone, in a fraction of the time */
  calibrationFactor(original: MeshInput, other: MeshInput, options: FidelityOptions): number;
}
