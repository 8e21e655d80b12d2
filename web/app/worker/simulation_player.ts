/**
 * Plays a twin in real time, or slower if steps take longer, and sends its latest state to the page, never more frames
 * than the page can draw. See web/engine/motion/simulated_bodies.ts for the levels below.
 */

import { STEP_SECONDS } from '../../engine/motion/simulation';
import type { Twin, TwinName, TwinSample } from '../../engine/motion/twin';
import { rotated } from '../../engine/motion/scene_rotation';
import type { BodyState, ShowFrame, TwinFrame, TwinRequest, TwinSetup } from './simulation_protocol';

const STEP_MILLISECONDS = 1000 * STEP_SECONDS;

/** Steps that are late by more than this, in milliseconds, are dropped: slow motion looks better than a leap. */
const MAX_BEHIND = 100;

/** The number of steps after which the noise floor is dropped if the twin is slower than real time. */
const TRIED_STEPS = 30;
/** The speed from which motion counts as real time. */
const REAL_TIME = 0.9;

/** The time over which the speed is measured, in milliseconds. */
const PACE_SPAN = 1000;

export class TwinPlayer {
  request: TwinRequest;
  private isPlaying = false;
  private isShowing = false;
  private hasNews = false;
  private hasEnded = false;
  private due = 0;
  private tries = TRIED_STEPS;
  /** time limit for the steps of all bodies together, beyond which the noise floor is dropped */
  private readonly spareSeconds: number;
  private readonly stepped: number[] = [];
  private samples: TwinSample[] = [];
  private diverged: TwinName[] = [];
  private failure: string | null = null;
  private moveDragged: ((target: [number, number, number]) => void) | null = null;

  constructor(
    private readonly twin: Twin,
    private readonly setup: Pick<TwinSetup, 'number' | 'rotation'>,
    private readonly showFrame: ShowFrame,
    { request, spareSeconds }: { request: TwinRequest; spareSeconds: number },
  ) {
    this.request = request;
    this.spareSeconds = spareSeconds;
    this.announce();
  }

  play(isPlaying: boolean): void {
    if (isPlaying === this.isPlaying) return;
    this.isPlaying = isPlaying;
    this.stepped.length = 0;
    this.due = performance.now();
    if (isPlaying) this.schedule();
    this.announce();
  }

  /** One step while paused. */
  step(): void {
    if (!this.isPlaying) this.advance();
  }

  setRequest(request: TwinRequest): void {
    this.request = request;
    this.announce();
  }

  grab(...grip: Parameters<Twin['drag']>): void {
    this.moveDragged = this.twin.drag(...grip);
  }

  drag(target: [number, number, number]): void {
    const [x, y, z] = rotated(Float32Array.from(target), this.setup.rotation);
    this.moveDragged?.([x, y, z]);
  }

  release(): void {
    this.moveDragged = null;
    this.twin.release();
  }

  end(): void {
    this.isPlaying = false;
    this.hasEnded = true;
    this.twin.end();
  }

  /** Computes the next step when it is due; messages are handled between two steps. */
  private schedule(): void {
    const wait = this.due - performance.now();
    if (wait > 1) setTimeout(() => this.run(), wait);
    else afterMessages(() => this.run());
  }

  private run(): void {
    if (!this.isPlaying) return;
    const now = performance.now();
    if (now >= this.due) {
      this.due = Math.max(this.due + STEP_MILLISECONDS, now - MAX_BEHIND);
      this.advance();
    }
    if (this.isPlaying) this.schedule();
  }

  private advance(): void {
    if (this.hasEnded || this.diverged.length > 0 || this.failure) return;
    try {
      const { sample, diverged } = this.twin.step();
      this.diverged = diverged;
      if (sample) this.samples.push(sample);
    } catch (error) {
      this.failure = error instanceof Error ? error.message : String(error);
    }
    if (this.diverged.length > 0 || this.failure) this.isPlaying = false;
    const now = performance.now();
    this.stepped.push(now);
    while (this.stepped[0] < now - PACE_SPAN) this.stepped.shift();
    if (this.isPlaying) this.tryNoise();
    this.announce();
  }

  private tryNoise(): void {
    this.tries -= 1;
    if (this.tries === 0 && this.isTooSlow()) this.twin.endNoise();
  }

  private isTooSlow(): boolean {
    const { twin } = this;
    const seconds = 2 * twin.stepSeconds('original') + twin.stepSeconds('optimized');
    return this.pace() < REAL_TIME && seconds > this.spareSeconds;
  }

  private announce(): void {
    this.hasNews = true;
    if (!this.isShowing) void this.show();
  }

  private async show(): Promise<void> {
    this.isShowing = true;
    while (this.hasNews && !this.hasEnded) {
      this.hasNews = false;
      await this.showFrame(this.frame());
    }
    this.isShowing = false;
  }

  private frame(): TwinFrame {
    const { twin, setup, request, samples, diverged, failure } = this;
    this.samples = [];
    return {
      number: setup.number,
      time: twin.time,
      bodies: { original: this.stateOf('original'), optimized: this.stateOf('optimized') },
      driven: request.driven ? this.inMesh(twin.driven()) : null,
      vertexDistances: request.vertexDistances ? twin.vertexDistances() : null,
      samples,
      playing: this.isPlaying,
      pace: this.pace(),
      diverged,
      failure,
    };
  }

  private stateOf(name: TwinName): BodyState {
    const { twin } = this;
    return {
      positions: this.inMesh(twin.positions(name)),
      pins: this.inMesh(twin.pins(name)),
      stepSeconds: twin.stepSeconds(name),
      stretch: twin.stretchOf(name),
    };
  }

  /** Points of the scene in the space of the meshes. */
  private inMesh(points: Float32Array): Float32Array {
    return rotated(points, this.setup.rotation, true);
  }

  private pace(): number {
    const { stepped } = this;
    if (stepped.length < 2) return 1;
    return ((stepped.length - 1) * STEP_MILLISECONDS) / (stepped[stepped.length - 1] - stepped[0]);
  }
}

const channel = new MessageChannel();
let waiting: (() => void)[] = [];
channel.port1.onmessage = () => {
  const actions = waiting;
  waiting = [];
  for (const action of actions) action();
};

/** Runs an action once pending messages have been handled; a timer of 0 would wait for milliseconds. */
function afterMessages(action: () => void): void {
  waiting.push(action);
  channel.port2.postMessage(null);
}
