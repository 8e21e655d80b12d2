/** The messages between the page and the worker of the Test step: plain data, typed arrays moved rather than copied. */

import type { MeshAt, SurfacePoint, CollisionScene, TriangleMesh } from '../../engine/core/core';
import type { Settings } from '../../engine/settings/options';
import type { BodySize } from '../../engine/body/prepared_body';
import type { SceneRotation } from '../../engine/motion/scene_rotation';
import type { TwinName, TwinSample } from '../../engine/motion/twin';
import type { TunedBody } from '../../engine/solvers/tuned_body';

export interface TwinSetup {
  /** counts starts; frames contain it, so that those of an earlier twin are never shown */
  number: number;
  original: TriangleMesh;
  result: MeshAt;
  /** equal for equal meshes */
  meshKey: string;
  size: BodySize;
  /** from the space of the meshes to the scene's, in which gravity pulls and colliders lie; null: the same */
  rotation: SceneRotation | null;
  settings: Settings;
  /** vertices of the original; null: the default pins of the scenario */
  pinned: Uint32Array | null;
  /** the tuned parameters of the result in the solver of the settings; null: those of the original, untuned */
  tuned: TunedBody | null;
  /** whether the original runs a third time, hidden, with its constraints in another order */
  noise: 'always' | 'in real time';
}

/** The contents of a frame in addition to positions. */
export interface TwinRequest {
  /** the deviation of each vertex, for its colour */
  vertexDistances: boolean;
  /** the original driven by the optimized body */
  driven: boolean;
}

/** The cost and the state of one body. */
export interface BodyState {
  positions: Float32Array;
  /** pins[3 * pin + c] */
  pins: Float32Array;
  /** the shortest of the last steps on one thread */
  stepSeconds: number;
  /** mean change of the length of edges, % */
  stretch: number;
}

/** The latest state of both bodies. */
export interface TwinFrame {
  number: number;
  /** seconds since the start */
  time: number;
  bodies: Record<TwinName, BodyState>;
  driven: Float32Array | null;
  /** per vertex of the original, in % of its diagonal */
  vertexDistances: Float32Array | null;
  /** one per step since the last frame */
  samples: TwinSample[];
  /** false: paused by the page; no frame follows */
  playing: boolean;
  /** simulated seconds per second while it plays */
  pace: number;
  /** the bodies that have diverged, which ends the motion */
  diverged: TwinName[];
  /** a sentence if the core has failed for another reason */
  failure: string | null;
}

export interface SimulationApi {
  /** `lifeLock`: see keepAlive. */
  load(wasmFolder: string, show: ShowFrame, lifeLock: string): Promise<void>;
  /**
   * Replaces the last twin with a new one, at rest and paused; returns its collision scene. Throws an Error with one
   * sentence if it cannot be simulated.
   */
  start(setup: TwinSetup, request: TwinRequest): Promise<CollisionScene>;
  setRequest(request: TwinRequest): Promise<void>;
  play(isPlaying: boolean): Promise<void>;
  step(): Promise<void>;
  /** Starts dragging a point of one body, and the same point of the other. */
  grab(name: TwinName, point: SurfacePoint): Promise<void>;
  drag(target: [number, number, number]): Promise<void>;
  release(): Promise<void>;
}

/** Resolves once the frame has been drawn; a newer one is sent after that. */
export type ShowFrame = (frame: TwinFrame) => Promise<void>;
