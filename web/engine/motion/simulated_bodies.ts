/**
 * Bodies that are stepped together in one scenario.
 *
 * The levels of a simulation, from the inside out; each one adds one thing to the one before it:
 * - `Simulation` (wasm/simulate/simulation.h): one body and its solver.
 * - `RunningScenario` (wasm/simulate/running_scenario.h): one body in a scenario, with its clock, pins and loads.
 * - `SimulatedBodies` (here): up to three such bodies of one original, stepped side by side on threads of their own.
 * - `Twin` (twin.ts): the original and its result as SimulatedBodies, measured against each other after every step.
 * - `TwinPlayer` (web/app/worker/simulation_player.ts): a Twin that plays in real time and sends frames to the page.
 *
 * The command line needs no twin: `compareMotion` (wasm/compare/compare_motion.h) runs one RunningScenario after the
 * other, so that each has its own time. Both ways measure the deviation by wasm/compare/motion_deviation.h.
 */

import type {
  CollisionScene,
  Core,
  MotionDeviation,
  SimulatedSolver,
  SimulationOptions,
  StartOptions,
  SurfacePoint,
  TriangleMesh,
} from '../core/core';
import { STEP_SECONDS } from './simulation';

export interface BodiesOptions extends SimulationOptions {
  /** the solver of the optimized body, if the original has one; absent or null: the original's */
  otherSolver?: SimulatedSolver | null;
  /** per vertex of the original its point on the optimized mesh; null or absent: closest points */
  binding?: StartOptions['binding'];
  /** adds a last body: the original with its constraints in another order, whose deviation is the noise floor */
  hasReordered?: boolean;
}

/** The options of the optimized body, with its calibration in Young's modulus. */
const calibrated = (options: SimulationOptions): SimulationOptions => ({
  ...options,
  young: options.young * (options.calibration ?? 1),
});

/**
 * The original (body 0) and, where they are given, its optimized mesh and the reordered original, in one scenario at the
 * same time. They live in the core until `end` is called.
 */
export class SimulatedBodies {
  private numbers: Uint32Array;
  private stepsDone = 0;
  /** what all bodies can touch */
  readonly collisionScene: CollisionScene;

  /** Throws an Error with one sentence where a mesh or an option is invalid. */
  constructor(
    private readonly core: Core,
    original: TriangleMesh,
    optimized: TriangleMesh | null,
    { binding = null, hasReordered = false, otherSolver = null, ...options }: BodiesOptions,
  ) {
    const bodies: [TriangleMesh, StartOptions][] = [[original, options]];
    if (optimized) {
      const solver = otherSolver ?? options.solver;
      bodies.push([optimized, { ...calibrated(options), solver, binding }]);
    }
    if (hasReordered) bodies.push([original, { ...options, order: 1 }]);
    const numbers: number[] = [];
    try {
      for (const [body, own] of bodies) numbers.push(core.startSimulation(body, original, own));
    } catch (error) {
      for (const number of numbers) core.endSimulation(number);
      throw error;
    }
    this.numbers = Uint32Array.from(numbers);
    this.collisionScene = core.scenarioCollisionScene(original, options);
  }

  /** Seconds since the start. */
  get time(): number {
    return this.stepsDone * STEP_SECONDS;
  }

  /** One step of 1/60 s of all bodies, each on a thread of its own. Throws after it where one has diverged. */
  step(): void {
    this.core.stepSimulations(this.numbers);
    this.stepsDone += 1;
  }

  /** positions[3 * v + c] of a body, in units of the mesh; a copy. */
  positions(body: number): Float32Array {
    return this.core.simulationPositions(this.numbers[body]);
  }

  /** Where the pins of a body are, pins[3 * pin + c]. */
  pins(body: number): Float32Array {
    return this.core.simulationPins(this.numbers[body]);
  }

  /** The duration of a body's last step on its thread, in seconds; 0 before the first. */
  stepSeconds(body: number): number {
    return this.core.simulationSeconds(this.numbers[body]);
  }

  /** Whether a connected part of a body has grown beyond ten times the body's size, or it is not finite; no step may follow. */
  hasDiverged(body: number): boolean {
    return this.core.simulationDiverged(this.numbers[body]);
  }

  /** How differently a body has moved from the original, over its surface, after the last step. */
  deviation(body: number): MotionDeviation {
    return this.core.simulationDeviation(this.numbers[0], this.numbers[body]);
  }

  /** Pulls a point of one body towards `target` until it is released. */
  drag(body: number, point: SurfacePoint, target: [number, number, number]): void {
    this.core.dragSimulation(this.numbers[body], point, target);
  }

  release(body: number): void {
    this.core.releaseSimulation(this.numbers[body]);
  }

  /** Ends the last body; the others go on. */
  endLast(): void {
    this.core.endSimulation(this.numbers[this.numbers.length - 1]);
    this.numbers = this.numbers.slice(0, -1);
  }

  /** Frees the memory in the core; must be the last call. */
  end(): void {
    for (const number of this.numbers) this.core.endSimulation(number);
  }
}
