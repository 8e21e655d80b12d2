/** The Test step's state: both bodies in motion in a worker of their own, started again whenever their inputs change. */

import { batch, computed, effect, signal, untracked } from '@preact/signals';
import { proxy, wrap } from 'comlink';
import type { Remote } from 'comlink';
import type { MeshAt, SurfacePoint, CollisionScene } from '../../engine/core/core';
import { OPTIONS } from '../../engine/settings/options';
import type { Settings } from '../../engine/settings/options';
import { topCorners } from '../../engine/motion/top_corners';
import type { TwinName, TwinSample } from '../../engine/motion/twin';
import type { SimulationApi, TwinFrame, TwinRequest } from '../worker/simulation_protocol';
import { pinsKey, resultKey } from './keys';
import { results, shownMesh, status, view, wantedFaces, wants } from './store';

/** What is held: what the scenario holds by itself, the two upper corners, or the pins of the Motion step. */
export type Held = 'scenario' | 'corners' | 'pins';

export const twin = {
  playing: signal(!matchMedia('(prefers-reduced-motion: reduce)').matches),
  layout: signal<'beside' | 'over'>('beside'),
  /** draw the original as the optimized body carries it */
  driven: signal(false),
  heat: signal(false),
  /** measure the noise floor also where time does not keep up then */
  alwaysNoise: signal(false),
  /** null: the pins of the Motion step where there are any */
  held: signal<Held | null>(null),
  /** what is on screen; null until a simulation stands */
  frame: signal<TwinFrame | null>(null),
  /** the latest frame a few times a second, for numbers that are read */
  numbers: signal<TwinFrame | null>(null),
  samples: signal<TwinSample[]>([]),
  /** the largest deviation of any vertex since the start, % */
  worst: signal(0),
  /** what both bodies can touch */
  collisionScene: signal<CollisionScene | null>(null),
  /** why nothing can be simulated */
  failure: signal<string | null>(null),
};

/** In milliseconds: numbers that change faster cannot be read, and a curve need not grow faster. */
const NUMBERS_EVERY = 250;
const CURVE_EVERY = 100;
/** Of what the user still moves: a slider is not followed step by step. */
const REST_MILLISECONDS = 200;
/** In seconds: a worker in the middle of a longer step is not waited for. */
const LONG_STEP = 0.3;
/** Steps that the curve remembers: a minute. */
const MOST_SAMPLES = 3600;

export const pinSource = computed<Held>(() => {
  const hasPins = wants.settings.value.pins !== '';
  const { value: held } = twin.held;
  if (held === null) return hasPins ? 'pins' : 'scenario';
  return held === 'pins' && !hasPins ? 'scenario' : held;
});

const simulationKeys = (Object.keys(OPTIONS) as (keyof Settings)[]).filter((key) =>
  ['simulation', 'material'].includes(OPTIONS[key].group),
);

/** What the simulation is made of; null where it cannot be yet. */
const key = computed<string | null>(() => {
  const settings = wants.settings.value;
  if (view.step.value !== 'test' || isPending() || !shownMesh.value || !results.body.value) return null;
  const values = simulationKeys.map((name) => settings[name]);
  const pins = pinSource.value === 'pins' ? pinsKey(settings) : pinSource.value;
  return [meshKey(), pins, ...values, twin.alwaysNoise.value].join(' ');
});

const meshKey = (): string =>
  [
    results.opened.value,
    wants.body.value,
    resultKey(wants.settings.value),
    wantedFaces.value,
    isFittedShown(),
  ].join(' ');

/** Whether another mesh is still to come. */
const isPending = (): boolean => status.working.value && !isFittedShown();

const isFittedShown = (): boolean => results.fitted.value?.result === shownMesh.value;

let worker: Worker | null = null;
let remote: Remote<SimulationApi> | null = null;
let loaded: Promise<void> = Promise.resolve();
let number = 0;
let numbersAt = 0;
let curveAt = 0;
let recorded: TwinSample[] = [];

const constraints = (): TwinRequest => ({
  deviations: twin.heat.value,
  driven: twin.driven.value,
});

function openWorker(): Remote<SimulationApi> {
  worker = new Worker(new URL('../worker/simulation_worker.ts', import.meta.url), { type: 'module' });
  worker.addEventListener('error', ({ message }) => {
    closeWorker();
    twin.failure.value = `The simulation has stopped: ${message}.`;
  });
  const api = (remote = wrap<SimulationApi>(worker));
  loaded = api.load(new URL('wasm/', document.baseURI).href, proxy(showFrame));
  return api;
}

/** Frees everything that the simulation holds, also in the middle of a long step. */
function closeWorker(): void {
  worker?.terminate();
  worker = remote = null;
  forget();
}

/** What still runs is not what is wanted: its last picture stays, its numbers do not. */
function outdate(): void {
  number += 1;
  twin.numbers.value = null;
}

function forget(): void {
  number += 1;
  twin.frame.value = twin.numbers.value = null;
  twin.samples.value = recorded = [];
  twin.worst.value = 0;
}

function pinned(): Uint32Array | null {
  const { value: body } = results.body;
  if (!body || pinSource.value === 'scenario') return null;
  return pinSource.value === 'corners' ? topCorners(body.mesh) : (results.pins.value?.vertices ?? null);
}

async function start(result: MeshAt): Promise<void> {
  const { mesh: original, diagonal, scale } = results.body.value!;
  if ((twin.frame.value?.bodies.original.stepSeconds ?? 0) > LONG_STEP) closeWorker();
  forget();
  const mine = number;
  twin.failure.value = null;
  const api = remote ?? openWorker();
  const size = { body: { scale }, diagonal };
  const setup = {
    number,
    original,
    result,
    meshKey: meshKey(),
    size,
    settings: wants.settings.value,
    pinned: pinned(),
    noise: twin.alwaysNoise.value ? ('always' as const) : ('in real time' as const),
  };
  try {
    await loaded;
    const collisionScene = await api.start(setup, constraints());
    if (mine !== number) return;
    twin.collisionScene.value = collisionScene;
    await api.play(isMoving());
  } catch (error) {
    if (mine === number) twin.failure.value = error instanceof Error ? error.message : String(error);
  }
}

const isVisible = signal(!document.hidden);
const isMoving = (): boolean => twin.playing.value && isVisible.value;

/** Back to the start, at rest. */
export function reset(): void {
  if (shownMesh.value && key.value) void start(shownMesh.value);
}

/** One step of 1/60 s; pauses first. */
export function stepOnce(): void {
  twin.playing.value = false;
  void remote?.step();
}

export function grab(name: TwinName, point: SurfacePoint): void {
  void remote?.grab(name, point);
}

export function dragTo(target: [number, number, number]): void {
  void remote?.drag(target);
}

export function releaseDrag(): void {
  void remote?.release();
}

/** Resolves with the next picture, so that the worker sends no more frames than are drawn. */
function showFrame(frame: TwinFrame): Promise<void> {
  if (frame.number === number) take(frame);
  return new Promise((resolve) => requestAnimationFrame(() => resolve()));
}

function take(frame: TwinFrame): void {
  recorded.push(...frame.samples);
  const worst = frame.samples.reduce((most, sample) => Math.max(most, sample.max), twin.worst.value);
  const now = performance.now();
  const isStill = !twin.playing.value || !frame.playing;
  batch(() => {
    twin.worst.value = worst;
    twin.frame.value = frame;
    if (frame.exploded.length > 0) twin.playing.value = false;
    if (frame.failure) twin.failure.value = frame.failure;
    if (isStill || now - numbersAt > NUMBERS_EVERY) {
      numbersAt = now;
      twin.numbers.value = frame;
    }
    if (isStill || now - curveAt > CURVE_EVERY) {
      curveAt = now;
      twin.samples.value = recorded = recorded.slice(-MOST_SAMPLES);
    }
  });
}

/** Starts following the state. */
export function startSimulations(): void {
  document.addEventListener('visibilitychange', () => (isVisible.value = !document.hidden));
  effect(() => {
    const { value: wanted } = key;
    if (view.step.value !== 'test') return untracked(closeWorker);
    if (wanted === null) return;
    untracked(outdate);
    const timer = setTimeout(() => void start(shownMesh.value!), REST_MILLISECONDS);
    return () => clearTimeout(timer);
  });
  effect(() => {
    const isPlaying = isMoving();
    untracked(() => void remote?.play(isPlaying));
  });
  effect(() => {
    const wanted = constraints();
    untracked(() => void remote?.setRequest(wanted));
  });
}
