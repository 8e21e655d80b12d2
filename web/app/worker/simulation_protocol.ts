/** What the page and the worker of the Test step say to each other: plain data, typed arrays moved rather than copied. */

import type { MeshAt, SurfacePoint, CollisionScene, TriangleMesh } from '../../engine/core/core';
import type { Settings } from '../../engine/settings/options';
import type { BodySize } from '../../engine/body/prepared_body';
import type { TwinName, TwinSample } from '../../engine/motion/twin';

export interface TwinSetup {
  /** counts starts; frames carry it, so that those of an earlier twin are never shown */
  number: number;
  original: TriangleMesh;
  result: MeshAt;
  /** equal for equal meshes */
  meshKey: string;
  size: BodySize;
  settings: Settings;
  /** vertices of the original; null: what the scenario itself holds */
  pinned: Uint32Array | null;
  /** whether the original runs a third time, hidden, with its constraints in another order */
  noise: 'always' | 'in real time';
}

/** What a frame carries besides positions. */
export interface TwinRequest {
  /** the deviation of each vertex */
  deviations: boolean;
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
  deviations: Float32Array | null;
  /** of all steps since the frame before */
  samples: TwinSample[];
  /** false: nothing moves until it is told to, so that this is the last frame */
  playing: boolean;
  /** simulated seconds per second while it plays */
  pace: number;
  /** which bodies have flown apart; nothing moves any more then */
  exploded: TwinName[];
  /** a sentence where the core has given up for another reason */
  failure: string | null;
}

export interface SimulationApi {
  load(wasmFolder: string, show: ShowFrame): Promise<void>;
  /**
   * Replaces what has been there, at rest and paused; returns what the bodies can touch. Throws one sentence where that
   * cannot be simulated.
   */
  start(setup: TwinSetup, constraints: TwinRequest): Promise<CollisionScene>;
  setRequest(constraints: TwinRequest): Promise<void>;
  play(isPlaying: boolean): Promise<void>;
  step(): Promise<void>;
  /** Takes hold of a point, of both bodies. */
  grab(name: TwinName, point: SurfacePoint): Promise<void>;
  drag(target: [number, number, number]): Promise<void>;
  release(): Promise<void>;
}

/** Resolves once the frame has been drawn; a newer one is sent after that. */
export type ShowFrame = (frame: TwinFrame) => Promise<void>;
