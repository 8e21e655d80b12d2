/** A running simulation of one or two bodies: the only thing that lives across the boundary to the core. */

import type {
  Binding,
  Core,
  ScenarioName,
  SimulationOptions,
  StartOptions,
  CollisionScene,
  SurfacePoint,
  TriangleMesh,
} from '../core/core';
import { NONE } from '../core/core';
import { collisionSceneOf } from './colliders';
import type { BodyBinding } from '../report/binding_file';
import { materialOf } from '../stages/pipeline';
import type { BodySize, PreparedBody } from '../stages/pipeline';
import type { Settings } from '../settings/options';

/** Seconds of one step, whatever the substeps. */
export const STEP_SECONDS = 1 / 60;

export const SCENARIOS: readonly ScenarioName[] = ['twist', 'sway', 'hang', 'drop', 'pull', 'wind', 'drape'];

/** What the settings ask for, for this body and any that was made from it. `pinned`: null leaves it to the scenario. */
export function simulationOptions(
  original: BodySize,
  settings: Settings,
  pinned: Uint32Array | null,
): SimulationOptions {
  const { material, scenario, seconds, substeps, damping, selfCollision, friction, colliders } = settings;
  return {
    material,
    scenario,
    seconds,
    substeps,
    damping,
    selfCollision,
    friction,
    ...collisionSceneOf(colliders),
    pinned,
    ...materialOf(original, settings),
  };
}

/** Modes that a body is calibrated by. */
const CALIBRATION_MODES = 10;

/**
 * Young's modulus of `optimized` over the original's with which its first ten frequencies are the original's, both as
 * shells of the material that the settings name: a coarse mesh is a little too soft or too stiff throughout.
 */
export function calibrationOf(
  core: Core,
  original: BodySize & { mesh: TriangleMesh },
  optimized: TriangleMesh,
  settings: Settings,
): number {
  const material = materialOf(original, settings);
  return core.calibrationFactor(original.mesh, optimized, { modeCount: CALIBRATION_MODES, ...material });
}

/** What the optimized body is made of. */
const calibrated = (options: SimulationOptions): SimulationOptions => ({
  ...options,
  young: options.young * (options.calibration ?? 1),
});

/**
 * The binding of a file in terms of two prepared bodies: points of `optimized`, one per vertex of `original`. Throws an
 * Error with one sentence where the file is of other bodies.
 */
export function bindingBetween(
  original: PreparedBody,
  optimized: PreparedBody,
  bodies: BodyBinding[],
): Pick<Binding, 'triangle' | 'barycentric'> {
  const { vertexOfSource } = original.weld;
  const entry = bodies.find(({ mesh }) => mesh === original.body.mesh);
  if (!entry || entry.binding.triangle.length !== vertexOfSource.length)
    throw new Error(
      `The binding is not of "${original.body.name}": write it again with limber optimize --bind.`,
    );
  const triangleOfSource = new Uint32Array(entry.faces).fill(NONE);
  optimized.weld.sourceOfTriangle.forEach((source, t) => {
    if (source < entry.faces) triangleOfSource[source] = t;
  });
  const count = original.mesh.positions.length / 3;
  const triangle = new Uint32Array(count).fill(NONE);
  const barycentric = new Float32Array(3 * count);
  vertexOfSource.forEach((v, source) => {
    const bound = entry.binding.triangle[source];
    if (v === NONE || bound === NONE) return;
    triangle[v] = triangleOfSource[bound];
    barycentric.set(entry.binding.barycentric.subarray(3 * source, 3 * source + 3), 3 * v);
  });
  return { triangle, barycentric };
}

export interface TogetherOptions extends SimulationOptions {
  /** where the original's vertices lie on the optimized mesh; left out: by closest points */
  binding?: StartOptions['binding'];
  /** a last body: the original once more, with its constraints in another order; how far it strays is the noise floor */
  hasReordered?: boolean;
}

/** The original and, where given, its optimized mesh, in the same scenario at the same time. */
export class Simulation {
  private numbers: Uint32Array;
  private stepsDone = 0;
  /** what both bodies can touch */
  readonly collisionScene: CollisionScene;

  /** Throws an Error with one sentence where a mesh or an option is of no use. */
  constructor(
    private readonly core: Core,
    original: TriangleMesh,
    optimized: TriangleMesh | null,
    { binding = null, hasReordered = false, ...options }: TogetherOptions,
  ) {
    const bodies: [TriangleMesh, StartOptions][] = [[original, options]];
    if (optimized) bodies.push([optimized, { ...calibrated(options), binding }]);
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

  /** One step of 1/60 s of all bodies, on a thread each. Throws where one has flown apart. */
  step(): void {
    this.core.stepSimulations(this.numbers);
    this.stepsDone += 1;
  }

  /** positions[3 * v + c] of body 0, the original, or 1, in units of the mesh; a copy. */
  positions(body: number): Float32Array {
    return this.core.simulationPositions(this.numbers[body]);
  }

  /** Where the pins of a body are, [3 * pin + c]. */
  pins(body: number): Float32Array {
    return this.core.simulationPins(this.numbers[body]);
  }

  /** What a body's last step took on its thread, in seconds. */
  stepSeconds(body: number): number {
    return this.core.simulationSeconds(this.numbers[body]);
  }

  /** Draws a point of one body towards `target`, until it is let go. */
  drag(body: number, point: SurfacePoint, target: [number, number, number]): void {
    this.core.dragSimulation(this.numbers[body], point, target);
  }

  release(body: number): void {
    this.core.releaseSimulation(this.numbers[body]);
  }

  /** Ends the last body, and goes on with the others. */
  endLast(): void {
    this.core.endSimulation(this.numbers[this.numbers.length - 1]);
    this.numbers = this.numbers.slice(0, -1);
  }

  /** Frees the memory of the core; the last call. */
  end(): void {
    for (const number of this.numbers) this.core.endSimulation(number);
  }
}
