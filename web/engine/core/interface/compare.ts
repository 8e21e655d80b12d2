/** Compares two meshes by surface distance and by frequencies. */

import type { ElasticMaterial } from './material';
import type { MeshInput } from './mesh';

/** Distances between two surfaces, in units of the mesh. */
export interface SurfaceDistance {
  hausdorff: number;
  mean: number;
  vertexHausdorff: number;
}

export interface FidelityOptions extends ElasticMaterial {
  /** number of compared modes, at least 1 */
  modeCount: number;
}

/** Errors in %, under the keys of the report. */
export interface Fidelity {
  frequencyErrorMean: number;
  frequencyErrorMax: number;
  frequencyErrorCalibrated: number;
  calibrationFactor: number;
  frequencyErrorThin: number;
  frequencyErrorThick: number;
  /** NaN if the original has no such modes */
  frequencyErrorHigh: number;
  macMean: number;
  macMin: number;
}

/** The lowest elastic shell modes over all parts of a body. */
export interface ShellModes {
  /** rad/s, ascending */
  omega: Float64Array;
  /** shapes[(k * vertexCount + v) * 3 + c] */
  shapes: Float32Array;
}

/** The functions of the core on this topic. */
export interface CompareFunctions {
  /** `samples` of each surface, besides its vertices; 0: ten for each triangle, and at least 10,000 */
  measureSurfaceDistance(a: MeshInput, b: MeshInput, samples: number): SurfaceDistance;
  /** only `hausdorff` of measureSurfaceDistance, in a fraction of the time */
  measureHausdorff(a: MeshInput, b: MeshInput, samples: number): number;
  /** whether measureHausdorff is at most `limit`, in units of the mesh, in a fraction of the time */
  isWithinHausdorff(a: MeshInput, b: MeshInput, limit: number, samples: number): boolean;
  compareFidelity(original: MeshInput, other: MeshInput, options: FidelityOptions): Fidelity;
  /** the 2 * options.modeCount modes of the original that frequencyErrors needs */
  shellModes(original: MeshInput, options: FidelityOptions): ShellModes;
  /** only `frequencyErrorMean` and `frequencyErrorMax` of compareFidelity, in %, for a sixth of the work */
  frequencyErrors(
    original: MeshInput,
    modes: ShellModes,
    other: MeshInput,
    options: FidelityOptions,
  ): { mean: number; max: number };
  /** only `calibrationFactor` of compareFidelity, in a fraction of the time */
  calibrationFactor(original: MeshInput, other: MeshInput, options: FidelityOptions): number;
}
