/** The original and its optimized mesh in one scenario, measured against each other after every step. */

import type {
  Binding,
  Core,
  MeshAt,
  SimulatedSolver,
  SimulationOptions,
  SurfacePoint,
  CollisionScene,
  TriangleMesh,
} from '../core/core';
import { SimulatedBodies } from './simulated_bodies';
import { Stretch } from './stretch';
import { onOptimized, onOriginal } from './twin_points';
import { boundPositions, VertexDistances } from './vertex_distances';

export type TwinName = 'original' | 'optimized';

/** After one step. Deviations are in % of the original's diagonal, see wasm/compare/motion_deviation.h. */
export interface TwinSample {
  /** seconds since the start */
  time: number;
  mean: number;
  max: number;
  /** mean deviation of the original from itself with its constraints in another order; null: not measured */
  noise: number | null;
}

export interface TwinOptions extends SimulationOptions {
  /** the solver of the optimized body, if the original has one; see solvers/solver_pair.ts */
  otherSolver?: SimulatedSolver | null;
  /** whether the original is also run with its constraints in another order */
  measuresNoise: boolean;
}

/** In the order of the bodies of SimulatedBodies. */
const NAMES: readonly TwinName[] = ['original', 'optimized'];
const REORDERED = 2;

/** The time of a step is the minimum over this many last steps. */
const COST_STEPS = 120;

export class Twin {
  readonly binding: Binding;
  private readonly bodies: SimulatedBodies;
  private readonly meshes: Record<TwinName, TriangleMesh>;
  private readonly stretch: Record<TwinName, Stretch>;
  private readonly costs: Record<TwinName, number[]> = { original: [], optimized: [] };
  /** the original at the start, in the pose of the scenario */
  private readonly start: Float32Array;
  private readonly distances: VertexDistances;
  /** what both bodies can touch */
  readonly collisionScene: CollisionScene;
  private hasNoise: boolean;

  /** Throws an Error with one sentence where a mesh or an option is of no use. */
  constructor(
    private readonly core: Core,
    original: TriangleMesh,
    result: MeshAt,
    options: TwinOptions & { diagonal: number },
  ) {
    const { measuresNoise, diagonal, ...simulated } = options;
    this.hasNoise = measuresNoise;
    this.meshes = { original, optimized: result.mesh };
    this.binding = core.bindToResult(original, result);
    this.bodies = new SimulatedBodies(core, original, result.mesh, {
      ...simulated,
      binding: this.binding,
      hasReordered: measuresNoise,
    });
    this.collisionScene = this.bodies.collisionScene;
    this.stretch = { original: new Stretch(original), optimized: new Stretch(result.mesh) };
    this.start = this.positions('original');
    const startOther = this.onOriginalVertices(this.positions('optimized'), false);
    this.distances = new VertexDistances(this.start, startOther, diagonal);
  }

  get time(): number {
    return this.bodies.time;
  }

  /** One step of 1/60 s. Names the bodies that have diverged in it, after which no other step may follow. */
  step(): { sample: TwinSample | null; diverged: TwinName[] } {
    try {
      this.bodies.step();
    } catch (error) {
      const diverged = NAMES.filter((_, body) => this.bodies.hasDiverged(body));
      if (diverged.length > 0) return { sample: null, diverged };
      throw error;
    }
    for (const name of NAMES) this.recordCost(name);
    return { sample: this.measure(), diverged: [] };
  }

  private recordCost(name: TwinName): void {
    const costs = this.costs[name];
    costs.push(this.bodies.stepSeconds(NAMES.indexOf(name)));
    if (costs.length > COST_STEPS) costs.shift();
  }

  private measure(): TwinSample {
    const { mean, max } = this.bodies.deviation(NAMES.indexOf('optimized'));
    const noise = this.hasNoise ? this.bodies.deviation(REORDERED).mean : null;
    return { time: this.time, mean, max, noise };
  }

  /** The original's vertices, bound to the optimized body at `positions`. */
  private onOriginalVertices(positions: Float32Array, offsets: boolean): Float32Array {
    return boundPositions(this.binding, this.meshes.optimized, positions, { rest: this.start, offsets });
  }

  /** positions[3 * v + c], a copy. */
  positions(name: TwinName): Float32Array {
    return this.bodies.positions(NAMES.indexOf(name));
  }

  /** Where the pins of a body are, pins[3 * pin + c]. */
  pins(name: TwinName): Float32Array {
    return this.bodies.pins(NAMES.indexOf(name));
  }

  /** The original's vertices, moved by the optimized body through the binding. */
  driven(): Float32Array {
    return this.onOriginalVertices(this.positions('optimized'), true);
  }

  /** Per vertex of the original, in % of its diagonal, after the last step: for the picture, see VertexDistances. */
  vertexDistances(): Float32Array {
    const carried = this.onOriginalVertices(this.positions('optimized'), false);
    return this.distances.between(this.positions('original'), carried);
  }

  /** The shortest of the last steps on one thread, in seconds; 0 before the first. */
  stepSeconds(name: TwinName): number {
    return this.costs[name].length > 0 ? Math.min(...this.costs[name]) : 0;
  }

  /** Mean change of the length of edges, in %. */
  stretchOf(name: TwinName): number {
    return this.stretch[name].mean(this.positions(name));
  }

  /** Grabs a point of one body and the corresponding point of the other; the returned function pulls both towards `target`. */
  drag(name: TwinName, point: SurfacePoint): (target: [number, number, number]) => void {
    const bound = { ...this.meshes, binding: this.binding };
    const points: Record<TwinName, SurfacePoint> = {
      original: name === 'original' ? point : onOriginal(this.core, bound, point),
      optimized: name === 'optimized' ? point : onOptimized(this.core, bound, point),
    };
    return (target) => {
      this.bodies.drag(0, points.original, target);
      this.bodies.drag(1, points.optimized, target);
      if (this.hasNoise) this.bodies.drag(REORDERED, points.original, target);
    };
  }

  /** From now on samples have no noise floor. */
  endNoise(): void {
    if (!this.hasNoise) return;
    this.hasNoise = false;
    this.bodies.endLast();
  }

  release(): void {
    for (let body = 0; body < (this.hasNoise ? 3 : 2); ++body) this.bodies.release(body);
  }

  end(): void {
    this.bodies.end();
  }
}
