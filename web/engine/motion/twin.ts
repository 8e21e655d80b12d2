/** The original and its optimized mesh in one scenario, measured against each other while they move. */

import type {
  Binding,
  Core,
  MeshAt,
  SimulationOptions,
  SurfacePoint,
  CollisionScene,
  TriangleMesh,
} from '../core/core';
import { Simulation } from './simulation';
import { boundPositions, Deviation, hasExploded, Stretch } from './twin_measures';
import type { DeviationNow } from './twin_measures';
import { onOptimized, onOriginal } from './twin_points';

export type TwinName = 'original' | 'optimized';

/** After one step. Deviations are in % of the original's diagonal. */
export interface TwinSample {
  /** seconds since the start */
  time: number;
  mean: number;
  max: number;
  /** mean deviation of the original from itself with its constraints in another order; null: not measured */
  noise: number | null;
}

export interface TwinOptions extends SimulationOptions {
  /** run the original once more with its constraints in another order */
  measuresNoise: boolean;
}

/** In the order of the bodies of a Simulation. */
const NAMES: readonly TwinName[] = ['original', 'optimized'];
const REORDERED = 2;

/** Steps of which the shortest counts as what a step takes. */
const COST_STEPS = 120;

export class Twin {
  readonly binding: Binding;
  private readonly simulation: Simulation;
  private readonly bodies: Record<TwinName, TriangleMesh>;
  private readonly stretch: Record<TwinName, Stretch>;
  private readonly costs: Record<TwinName, number[]> = { original: [], optimized: [] };
  private readonly deviation: Deviation;
  private readonly noise: Deviation;
  /** what both bodies can touch */
  readonly collisionScene: CollisionScene;
  private latest: DeviationNow;
  private hasNoise: boolean;

  /** Throws an Error with one sentence where a mesh or an option is of no use. */
  constructor(
    core: Core,
    original: TriangleMesh,
    result: MeshAt,
    private readonly options: TwinOptions & { diagonal: number },
  ) {
    const { measuresNoise, diagonal, ...simulated } = options;
    this.hasNoise = measuresNoise;
    this.bodies = { original, optimized: result.mesh };
    this.binding = core.bindToResult(original, result);
    this.simulation = new Simulation(core, original, result.mesh, {
      ...simulated,
      binding: this.binding,
      hasReordered: measuresNoise,
    });
    this.collisionScene = this.simulation.collisionScene;
    this.stretch = { original: new Stretch(original), optimized: new Stretch(result.mesh) };
    this.deviation = new Deviation(original, this.bound(result.mesh.positions), diagonal);
    this.noise = new Deviation(original, original.positions, diagonal);
    this.latest = this.deviation.between(original.positions, this.bound(result.mesh.positions));
  }

  get time(): number {
    return this.simulation.time;
  }

  /** One step of 1/60 s. Names the bodies that it has made fly apart, after which no other step can follow. */
  step(): { sample: TwinSample | null; exploded: TwinName[] } {
    let failure: unknown = null;
    try {
      this.simulation.step();
    } catch (error) {
      failure = error;
    }
    const exploded = NAMES.filter((name) => hasExploded(this.positions(name), this.options.diagonal));
    if (exploded.length > 0) return { sample: null, exploded };
    if (failure) throw failure;
    for (const name of NAMES) this.recordCost(name);
    return { sample: this.measure(), exploded };
  }

  private recordCost(name: TwinName): void {
    const costs = this.costs[name];
    costs.push(this.simulation.stepSeconds(NAMES.indexOf(name)));
    if (costs.length > COST_STEPS) costs.shift();
  }

  private measure(): TwinSample {
    const original = this.positions('original');
    this.latest = this.deviation.between(original, this.bound(this.positions('optimized')));
    const noise = this.hasNoise
      ? this.noise.between(original, this.simulation.positions(REORDERED)).mean
      : null;
    return { time: this.time, mean: this.latest.mean, max: this.latest.max, noise };
  }

  private bound(positions: Float32Array): Float32Array {
    return this.onOriginalVertices(positions, false);
  }

  private onOriginalVertices(positions: Float32Array, offsets: boolean): Float32Array {
    const rest = this.bodies.original.positions;
    return boundPositions(this.binding, this.bodies.optimized, positions, { rest, offsets });
  }

  /** positions[3 * v + c], a copy. */
  positions(name: TwinName): Float32Array {
    return this.simulation.positions(NAMES.indexOf(name));
  }

  pins(name: TwinName): Float32Array {
    return this.simulation.pins(NAMES.indexOf(name));
  }

  /** The original's vertices as the optimized body carries them. */
  driven(): Float32Array {
    return this.onOriginalVertices(this.positions('optimized'), true);
  }

  /** Per vertex of the original, after the last step. */
  deviations(): Float32Array {
    return this.latest.values;
  }

  /** The shortest of the last steps on one thread, in seconds; 0 before the first. */
  stepSeconds(name: TwinName): number {
    return this.costs[name].length > 0 ? Math.min(...this.costs[name]) : 0;
  }

  /** Mean change of the length of edges, in %. */
  stretchOf(name: TwinName): number {
    return this.stretch[name].mean(this.positions(name));
  }

  /** Draws a point of one body, and what is bound to it on the other, towards `target`. */
  drag(name: TwinName, point: SurfacePoint): (target: [number, number, number]) => void {
    const { original, optimized } = this.bodies;
    const points: Record<TwinName, SurfacePoint> = {
      original: name === 'original' ? point : onOriginal(original, optimized, this.binding, point),
      optimized: name === 'optimized' ? point : onOptimized(original, optimized, this.binding, point),
    };
    return (target) => {
      this.simulation.drag(0, points.original, target);
      this.simulation.drag(1, points.optimized, target);
      if (this.hasNoise) this.simulation.drag(REORDERED, points.original, target);
    };
  }

  /** From now on samples have no noise floor. */
  endNoise(): void {
    if (!this.hasNoise) return;
    this.hasNoise = false;
    this.simulation.endLast();
  }

  release(): void {
    for (let body = 0; body < (this.hasNoise ? 3 : 2); ++body) this.simulation.release(body);
  }

  end(): void {
    this.simulation.end();
  }
}
