/** The messages between the page and the worker of the Test step: plain data, typed arrays moved rather than copied. */

import type { MeshAt, SurfacePoint, CollisionScene, TriangleMesh } from '../../engine/core/core';
import type { Settings } from '../../engine/settings/options';
import type { BodySize } from '../../engine/body/prepared_body';
import type { SceneRotation } from '../../engine/motion/scene_rotation';
import type { TwinName, TwinSample } from '../../engine/motion/twin';
import type { TunedBody } from '../../engine/solvers/tuned_body';

export interface TwinSetup {
  /** counts starts; frames carry it, so that those of an earlier twin are never shown */
  number: number;
  original: TriangleMesh;
  result: MeshAt;
  /** equal for equal meshes */
  meshKey: string;
  size: BodySize;
  /** from the space of the meshes to the scene's, in which gravity pulls and colliders lie; null: the same */
  rotation: SceneRotation | null;
  settings: Settings;
  /** vertices of the original; null: what the scenario pins by itself */
  pinned: Uint32Array | null;
  /** what the result is simulated with in the solver of the settings; null: the same numbers as the original, as it is */
  tuned: TunedBody | null;
  /** whether the original runs a third time, hidden, with its constraints in another order */
  noise: 'always' | 'in real time';
}

/** What a frame carries besides positions. */
export interface TwinRequest {
  /** how far each vertex has moved differently, for its colour */
  vertexDistances: boolean;
  /** the original as the optimized body carries it */
  driven: boolean;
}

/** What one body costs and does. */
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
  /** false: nothing moves until the page says so, and no frame follows */
  playing: boolean;
  /** simulated seconds per second while it plays */
  pace: number;
  /** the bodies that have diverged; nothing moves any more then */
  diverged: TwinName[];
  /** a sentence where the core has failed for another reason */
  failure: string | null;
}

export interface SimulationApi {
  /** `lifeLock`: see keepAlive. */
  load(wasmFolder: string, show: ShowFrame, lifeLock: string): Promise<void>;
  /**
   * Replaces the last twin by a new one, at rest and paused; returns what its bodies can touch. Throws an Error with one
   * sentence where it cannot be simulated.
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
