/** Running simulations, and comparisons of motions. */

import type { ElasticMaterial } from './material';
import type { MeshInput, SurfacePoint } from './mesh';
import type { ScenarioName } from '../scenarios';
import type { Binding } from './transfer';

/** In the order of `enum class SimulationModel` in wasm/simulate/simulation.h. */
export const SIMULATION_MODELS = ['springs', 'shell'] as const;

/** shell: membrane and bending, the same material on any mesh; springs: the edges, as in the paper */
export type SimulationModel = (typeof SIMULATION_MODELS)[number];

/** A ball, where `from` is `to`, or a capsule; units of the mesh. */
export interface Collider {
  from: [number, number, number];
  to: [number, number, number];
  radius: number;
}

/** What a body can touch, in units of the mesh; it does not move. */
export interface CollisionScene {
  /** height of a floor across y */
  ground: number | null;
  colliders: Collider[];
}

export interface SimulationOptions extends ElasticMaterial, Partial<CollisionScene> {
  material: SimulationModel;
  /** what happens; see wasm/simulate/scenario.h */
  scenario: ScenarioName;
  /** of the whole scenario */
  seconds: number;
  /** of a step of 1/60 s, 1 to 10,000 */
  substeps: number;
  /** 1/s: velocities fall by this rate */
  damping: number;
  /** sheets push each other away */
  selfCollision: boolean;
  /** Coulomb's coefficient, against all that the body touches */
  friction: number;
  /** Young's modulus of the optimized body over the original's, see calibrationFactor; left out: 1 */
  calibration?: number;
  /** vertices of the original; null: what the scenario itself holds */
  pinned: Uint32Array | null;
}

export interface StartOptions extends SimulationOptions {
  /** where the original's vertices lie on this body, which its pins are carried over by; left out: by closest points */
  binding?: Pick<Binding, 'triangle' | 'barycentric'> | null;
  /** of the constraints: 0 as they come, any other number an order of its own */
  order?: number;
}

export interface ComparisonOptions {
  /** keep the positions of every step */
  records: boolean;
  /** where the original's vertices lie on the other body, which its pins are carried over by; null: by closest points */
  binding: Pick<Binding, 'triangle' | 'barycentric'> | null;
}

/** What one body has cost. */
export interface MotionRun {
  /** solved in a substep */
  constraints: number;
  /** of the mesh */
  edges: number;
  /** the shortest step, all work included */
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
  /** null where there was no other body */
  other: MotionRun | null;
  /** over points of the surface and steps */
  deviationMean: number;
  deviationMax: number;
  /** the mean deviation of the original from itself with its constraints in another order */
  noiseFloor: number;
}

/** The functions of the core on this topic. */
export interface SimulateFunctions {
  /** the whole scenario, with the original alone or with both */
  compareMotion(
    original: MeshInput,
    other: MeshInput | null,
    options: SimulationOptions & ComparisonOptions,
  ): MotionComparison;
  /** all that a body can touch in this scenario: what the options add and what it has by itself */
  scenarioCollisionScene(original: MeshInput, options: SimulationOptions): CollisionScene;
  /** a number for the calls below; `mesh` is the original or a body that its pins are carried over to */
  startSimulation(mesh: MeshInput, original: MeshInput, options: StartOptions): number;
  /** one step of 1/60 s each, side by side; throws after it where a body has diverged, see simulationDiverged */
  stepSimulations(simulations: Uint32Array): null;
  /** positions[3 * v + c], in units of the mesh */
  simulationPositions(simulation: number): Float32Array;
  /** where the pins are now, [3 * pin + c]: pinned vertices, then pinned points of the surface */
  simulationPins(simulation: number): Float32Array;
  /** what the last step took on its thread, in seconds; 0 before the first */
  simulationSeconds(simulation: number): number;
  /** whether it has grown beyond ten times its size or is not finite; no step may follow */
  simulationDiverged(simulation: number): boolean;
  /** over 1,000 points of the surface, as they are now; both must have the same original, which is the first */
  simulationDeviation(original: number, other: number): MotionDeviation;
  /** draws a point of the surface towards `target` from now on */
  dragSimulation(simulation: number, point: SurfacePoint, target: [number, number, number]): null;
  releaseSimulation(simulation: number): null;
  /** frees its memory; every simulation that was started must be ended */
  endSimulation(simulation: number): null;
}
