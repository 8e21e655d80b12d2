/** Interactive simulations, and comparisons of motions. */

import type { ElasticMaterial } from './material';
import type { MeshInput, SurfacePoint } from './mesh';
import type { ScenarioName } from '../scenarios';
import type { Binding } from './transfer';
import type { SolverConstants, SolverModel } from './tune';

/** In the order of `enum class SimulationModel` in wasm/simulate/simulation.h. */
export const SIMULATION_MODELS = ['springs', 'shell', 'solid'] as const;

/** shell: membrane and bending, the same material on any mesh; springs: one per edge, as in the paper; solid: closed parts are solid, open ones shells */
export type SimulationModel = (typeof SIMULATION_MODELS)[number];

/** A capsule, or a ball if `from` equals `to`; units of the mesh. */
export interface Collider {
  from: [number, number, number];
  to: [number, number, number];
  radius: number;
}

/** All that a body can touch besides itself; it does not move. Units of the mesh. */
export interface CollisionScene {
  /** y of a horizontal floor; null: no floor */
  ground: number | null;
  colliders: Collider[];
}

/** A solver model on one mesh, with its tuned parameters; see wasm/simulate/simulated_solver.h for the order of factors. */
export interface SimulatedSolver {
  model: SolverModel;
  constants: SolverConstants;
  /** per stretch constraint; absent: 1 */
  stretchFactors?: Float64Array;
  /** per bending constraint; absent: 1; never for 'morley' */
  bendFactors?: Float64Array;
  /** per vertex, kg; absent: by the mass rule of the model */
  masses?: Float64Array;
}

export interface SimulationOptions extends ElasticMaterial, Partial<CollisionScene> {
  material: SimulationModel;
  /** the solver of this body, used instead of `material`; absent or null: none */
  solver?: SimulatedSolver | null;
  /** what happens; see wasm/simulate/scenario.h */
  scenario: ScenarioName;
  /** duration of the scenario */
  seconds: number;
  /** substeps per step of 1/60 s, 1 to 10,000 */
  substeps: number;
  /** rate at which velocities decay, 1/s */
  damping: number;
  /** whether triangles of the body collide with each other */
  selfCollision: boolean;
  /** Coulomb's coefficient, for all that the body touches */
  friction: number;
  /** ratio of Young's moduli, optimized body to original, see calibrationFactor; 1 by default */
  calibration?: number;
  /** vertices of the original; null: the default pins of the scenario */
  pinned: Uint32Array | null;
}

export interface StartOptions extends SimulationOptions {
  /** points of this body bound to the original's vertices, to transfer its pins; by default closest points are used */
  binding?: Pick<Binding, 'triangle' | 'barycentric'> | null;
  /** order of the constraints: 0 is the natural one, any other number seeds a different one */
  order?: number;
}

export interface ComparisonOptions {
  /** the solver of the other body, if the original has one; absent or null: the original's without factors and masses */
  otherSolver?: SimulatedSolver | null;
  /** whether the substeps are doubled until the original has converged; false by default */
  doublesSubsteps?: boolean;
  /** whether the positions of every step are kept */
  records: boolean;
  /** points of the other body bound to the original's vertices, to transfer its pins; null: closest points are used */
  binding: Pick<Binding, 'triangle' | 'barycentric'> | null;
}

/** The cost of simulating one body, and its positions. */
export interface MotionRun {
  /** number solved per substep */
  constraints: number;
  /** number of edges of the mesh */
  edges: number;
  /** time of the shortest step, including all work */
  secondsPerStep: number;
  /** positions[(step * vertexCount + v) * 3 + c] after each step; empty unless `records` */
  positions: Float32Array;
}

/** How differently two bodies move, in % of the original's diagonal; see wasm/compare/motion_deviation.h. */
export interface MotionDeviation {
  mean: number;
  max: number;
}

/** How differently two bodies move in the same scenario, in % of the original's diagonal. */
export interface MotionComparison {
  original: MotionRun;
  /** null if there was no other body */
  other: MotionRun | null;
  /** mean over points of the surface and steps */
  deviationMean: number;
  deviationMax: number;
  /** mean deviation of the original from itself with its constraints in another order */
  noiseFloor: number;
  /** as used */
  substeps: number;
  /** mean deviation of the original from itself with twice the substeps; 0 if there was no other body */
  substepDeviation: number;
  /** whether that is at most a quarter of `deviationMean` */
  isConverged: boolean;
}

/** The functions of the core on this topic. */
export interface SimulateFunctions {
  /** simulates the whole scenario for the original, and for `other` if given */
  compareMotion(
    original: MeshInput,
    other: MeshInput | null,
    options: SimulationOptions & ComparisonOptions,
  ): MotionComparison;
  /** all that a body can touch in this scenario, including what the options add */
  scenarioCollisionScene(original: MeshInput, options: SimulationOptions): CollisionScene;
  /** returns an id for the calls below; `mesh` is the original, or a body that its pins are transferred to */
  startSimulation(mesh: MeshInput, original: MeshInput, options: StartOptions): number;
  /** one step of 1/60 s each, in parallel; throws afterwards if a body has diverged, see simulationDiverged */
  stepSimulations(simulations: Uint32Array): null;
  /** positions[3 * v + c], in units of the mesh */
  simulationPositions(simulation: number): Float32Array;
  /** current positions of the pins, [3 * pin + c]: pinned vertices, then pinned points of the surface */
  simulationPins(simulation: number): Float32Array;
  /** duration of the last step on its thread, in seconds; 0 before the first */
  simulationSeconds(simulation: number): number;
  /** whether the body has grown beyond ten times its size or is not finite; no further step is allowed then */
  simulationDiverged(simulation: number): boolean;
  /** current deviation over 1,000 points of the surface; `other` must have been started with this original */
  simulationDeviation(original: number, other: number): MotionDeviation;
  /** pulls a point of the surface towards `target` until the next call or `releaseSimulation` */
  dragSimulation(simulation: number, point: SurfacePoint, target: [number, number, number]): null;
  releaseSimulation(simulation: number): null;
  /** frees the simulation's memory; every simulation that was started must be ended */
  endSimulation(simulation: number): null;
}
