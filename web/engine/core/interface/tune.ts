/** Tuning: the parameters with which a solver moves a coarse mesh as it moves the original. */

import type { MeshInput } from './mesh';

export type StretchElement = 'membrane' | 'edge-springs';
export type BendElement = 'morley' | 'hinge-area' | 'hinge-length' | 'hinge' | 'cross-springs';
export type MassRule = 'area' | 'vertex';
export type TuneKind = 'global' | 'vertex' | 'constraint';

/** A solver model, see wasm/elastic/solvers/solver_model.h. */
export interface SolverModel {
  stretch: StretchElement;
  bend: BendElement;
  mass: MassRule;
}

/** The constants of a solver on one mesh, in SI units, see wasm/elastic/solvers/solver_model.h. */
export interface SolverConstants {
  stretch: number;
  secondStretch: number;
  bend: number;
  poisson: number;
  /** total mass over area, kg/m2 */
  surfaceDensity: number;
  /** metres per unit of the mesh */
  unit: number;
}

export interface TuneOptions {
  model: SolverModel;
  /** the constants that follow from the user's own parameters on the original */
  original: SolverConstants;
  /** the constants of the untouched coarse mesh: from the same parameters, typed in again */
  result: SolverConstants;
  /** vertices of the original and of the coarse mesh; both may be empty */
  pinnedOriginal: Uint32Array;
  pinnedResult: Uint32Array;
  tune: TuneKind;
  /** how the tuned masses are distributed: carried over from the original, or the same for every vertex */
  tunedMass: MassRule;
  /** whether original and result move through a short scene, untouched and tuned, and the better one is kept */
  runsTrial: boolean;
}

/**
 * Whether the frequencies to tune exist: deformations may meet no resistance in the solver, or no search
 * for modes converges, which says nothing about how the body bends.
 */
export type FrequencyStatus = 'found' | 'noResistance' | 'noConvergence';

/** Errors with the tuned parameters, whether a motion trial keeps these or not; NaN where the body has no such modes, like a flat sheet of springs. */
export interface TunedFrequencies {
  /** mean relative errors (%) of modes 1 to 10, free */
  errorUntouched: number;
  errorTuned: number;
  /** of modes 21 to 30, tuned */
  errorUnseen: number;
  /** of modes 1 to 10 under a clamping that was not tuned for, tuned */
  errorOtherPins: number;
}

export interface TunedMotion {
  /** 'sway' or 'hang' */
  scene: string;
  /** deviations, % of the diagonal */
  untouched: number;
  tuned: number;
  noiseFloor: number;
  kept: 'tuned' | 'untouched';
}

export interface Tuned {
  /** factors on the constants `result` of the options: both 1 where the untouched parameters are kept */
  stretchFactor: number;
  bendFactor: number;
  /** tune 'vertex': per vertex, mean about 1; else empty */
  stretchField: Float64Array;
  bendField: Float64Array;
  /** tune 'constraint': per constraint of its kind, in the order of the vertices below; else empty */
  stretchFactors: Float64Array;
  bendFactors: Float64Array;
  /** kg per vertex of the coarse mesh; their sum is the mass of the original */
  masses: Float64Array;
  /** pairs (springs) or triples (triangles) of vertices, one for each stretch constraint */
  stretchVertices: Uint32Array;
  /** pairs (cross springs) or quadruples (hinges: the edge, then the corners opposite) of vertices */
  bendVertices: Uint32Array;
  frequencies: TunedFrequencies;
  frequencyStatus: FrequencyStatus;
  /** untouched: the factors are 1, and only masses are tuned */
  kept: 'tuned' | 'untouched';
  /** null where `runsTrial` is false */
  motion: TunedMotion | null;
  /** why `motion` is null although a trial was requested, as a clause; otherwise empty */
  motionRefusal: string;
}

/** The functions of the core on this topic. */
export interface TuneFunctions {
  /** Both meshes must be welded and in the same space; throws an Error with one sentence where they do not belong together. */
  tuneSolver(original: MeshInput, result: MeshInput, options: TuneOptions): Tuned;
}
