/** Runs both bodies of the Test step in a worker of their own, and starts them again whenever their inputs change. */

import { batch, computed, effect, signal, untracked } from '@preact/signals';
import { proxy, wrap } from 'comlink';
import type { Remote } from 'comlink';
import type { MeshAt, SurfacePoint } from '../../engine/core/core';
import { OPTIONS } from '../../engine/settings/options';
import type { Settings } from '../../engine/settings/options';
import { findPinProblem } from '../../engine/motion/pin_problems';
import type { PinProblem } from '../../engine/motion/pin_problems';
import { topCorners } from '../../engine/motion/top_corners';
import { rotated, rotationOf } from '../../engine/motion/scene_rotation';
import type { SceneRotation } from '../../engine/motion/scene_rotation';
import type { TwinName, TwinSample } from '../../engine/motion/twin';
import { watchLife } from '../worker/life';
import type { SimulationApi, TwinFrame, TwinRequest, TwinSetup } from '../worker/simulation_protocol';
import { keyOf } from '../../engine/stages/stage';
import { STAGES } from '../../engine/stages/stages';
import { coreFolder } from '../worker/core_folder';
import { isMissingFile } from './offline';
import { results, shownFit, shownMesh, status, view, wantedKey, wants } from './store';
import { isTuningWanted, pinSource, twin, usedTuning } from './twin';
import { say } from '../language/say';

/** ms; faster changing numbers would be unreadable. */
const NUMBERS_EVERY = 250;
/** ms between two updates of the chart. */
const CURVE_EVERY = 100;
/** ms; a simulation starts once its settings have not changed for this long. */
const REST_MILLISECONDS = 200;
/** s; a worker whose steps take longer is ended rather than waited for. */
const LONG_STEP = 0.3;
/** Steps that the chart shows at most: a minute. */
const MAX_SAMPLES = 3600;

const simulationKeys = (Object.keys(OPTIONS) as (keyof Settings)[]).filter((key) =>
  ['simulation', 'material', 'solver'].includes(OPTIONS[key].group),
);

/** The inputs of the simulation as text; null while they are incomplete. */
export const simulationKey = computed<string | null>(() => {
  const settings = wants.settings.value;
  if (view.step.value !== 'test' || isPending() || !shownMesh.value || !results.body.value) return null;
  const values = simulationKeys.map((name) => settings[name]);
  const pins = pinSource.value === 'pins' ? pinsKey() : pinSource.value;
  return [meshKey(), pins, ...values, usedTuning.value !== null, twin.alwaysNoise.value].join(' ');
});

/** Pins that are yet to be found will restart it. */
const pinsKey = (): string =>
  `${keyOf(STAGES.pinned, wants.settings.value)} ${results.pins.value?.text ?? ''}`;

const meshKey = (): string =>
  [results.opened.value, wants.body.value, wantedKey(STAGES.fitted), isFittedShown()].join(' ');

/** Whether the optimized mesh is yet to be fitted or tuned. */
const isPending = (): boolean =>
  status.working.value && (!isFittedShown() || (isTuningWanted.value && usedTuning.value === null));

/** A fit that changes nothing shows the mesh of the history, which may still be in replay. */
const isFittedShown = (): boolean =>
  shownFit.value !== null && (shownFit.value.result !== null || !status.isReplaying.value);

let worker: Worker | null = null;
let remote: Remote<SimulationApi> | null = null;
let loaded: Promise<void> = Promise.resolve();
/** counts starts; see TwinSetup */
let startNumber = 0;
let numbersAt = 0;
let curveAt = 0;
let recorded: TwinSample[] = [];

const frameRequest = (): TwinRequest => ({
  vertexDistances: twin.heat.value,
  driven: twin.driven.value,
});

const describeEnd = (why: string): string =>
  say('The simulation has stopped: {why}. Press Reset to start it again.', { why });

const notLoaded = (): string =>
  say('its program could not be loaded; reload the page, and your work is restored');

function openWorker(): Remote<SimulationApi> {
  worker = new Worker(new URL('../worker/simulation_worker.ts', import.meta.url), { type: 'module' });
  const own = worker;
  const onEnd = (why: string): void => {
    if (worker !== own) return;
    closeWorker();
    twin.failure.value = describeEnd(why);
  };
  worker.addEventListener('error', ({ message }) => onEnd(message ?? notLoaded()));
  const api = (remote = wrap<SimulationApi>(worker));
  const lock = `limber-simulation-${crypto.randomUUID()}`;
  loaded = api.load(coreFolder(), proxy(showFrame), lock);
  loaded.then(
    () => watchLife(lock, () => onEnd(say('the browser has ended it'))),
    () => {
      // The next start retries.
      own.terminate();
      if (worker === own) worker = remote = null;
    },
  );
  return api;
}

/** Ends the worker, even in the middle of a long step, and frees its memory. */
function closeWorker(): void {
  worker?.terminate();
  worker = remote = null;
  clearFrames();
}

/** Invalidates the running simulation: its last frame stays on screen with the scale of its colours, but its numbers are removed. */
function invalidate(): void {
  startNumber += 1;
  twin.numbers.value = null;
  clearSamples();
}

function clearSamples(): void {
  twin.samples.value = recorded = [];
}

/** Removes the frames of the last simulation. */
function clearFrames(): void {
  startNumber += 1;
  twin.frame.value = twin.numbers.value = null;
  twin.worst.value = 0;
  clearSamples();
}

/** The rotation of the shown body in its scene. */
export const shownRotation = (): SceneRotation | null =>
  rotationOf(results.file.value!.bodies[wants.body.value].nodeMatrix);

/** The pinned vertices of the original; null: those of the scenario. */
function pinnedVertices(): Uint32Array | null {
  const { value: body } = results.body;
  if (!body || pinSource.value === 'scenario') return null;
  if (pinSource.value !== 'corners') return results.pins.value?.vertices ?? null;
  return topCorners({ ...body.mesh, positions: rotated(body.mesh.positions, shownRotation()) });
}

/** What is wrong with the held vertices in the scenario; null where nothing is. */
export const problemOfPins = computed((): PinProblem | null => {
  const { value: body } = results.body;
  const pinned = pinnedVertices();
  if (!body || !pinned || !results.file.value) return null;
  const mesh = { ...body.mesh, positions: rotated(body.mesh.positions, shownRotation()) };
  return findPinProblem(wants.settings.value.scenario, mesh, pinned);
});

/** The current setup of both bodies. */
export function twinSetup(result: MeshAt): TwinSetup {
  const { mesh: original, diagonal, scale } = results.body.value!;
  return {
    number: startNumber,
    original,
    result,
    meshKey: meshKey(),
    size: { body: { scale }, diagonal },
    rotation: shownRotation(),
    settings: wants.settings.value,
    pinned: pinnedVertices(),
    tuned: usedTuning.value,
    noise: twin.alwaysNoise.value ? 'always' : 'in real time',
  };
}

/** Starts a new simulation, at rest. */
async function start(result: MeshAt): Promise<void> {
  if ((twin.frame.value?.bodies.original.stepSeconds ?? 0) > LONG_STEP) closeWorker();
  clearFrames();
  const number = startNumber;
  twin.failure.value = null;
  const api = remote ?? openWorker();
  const setup = twinSetup(result);
  try {
    await loaded;
    const collisionScene = await api.start(setup, frameRequest());
    if (number !== startNumber) return;
    twin.collisionScene.value = collisionScene;
    await api.play(isMoving());
  } catch (error) {
    if (number === startNumber) twin.failure.value = describeFailure(error);
  }
}

function describeFailure(error: unknown): string {
  if (isMissingFile(error)) return describeEnd(notLoaded());
  return error instanceof Error ? error.message : String(error);
}

const isVisible = signal(!document.hidden);
const isMoving = (): boolean => twin.playing.value && isVisible.value;

/** Goes back to the start, at rest. */
export function reset(): void {
  if (shownMesh.value && simulationKey.value) void start(shownMesh.value);
}

/** Pauses and takes one step of 1/60 s. */
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

/** Resolves at the next animation frame, so that the worker sends no more frames than the page draws. */
function showFrame(frame: TwinFrame): Promise<void> {
  if (frame.number === startNumber) applyFrame(frame);
  return new Promise((resolve) => requestAnimationFrame(() => resolve()));
}

function applyFrame(frame: TwinFrame): void {
  recorded.push(...frame.samples);
  const worst = frame.samples.reduce((most, sample) => Math.max(most, sample.max), twin.worst.value);
  const now = performance.now();
  const isStill = !twin.playing.value || !frame.playing;
  batch(() => {
    twin.worst.value = worst;
    twin.frame.value = frame;
    if (frame.diverged.length > 0) twin.playing.value = false;
    if (frame.failure) twin.failure.value = frame.failure;
    if (isStill || now - numbersAt > NUMBERS_EVERY) {
      numbersAt = now;
      twin.numbers.value = frame;
    }
    if (isStill || now - curveAt > CURVE_EVERY) {
      curveAt = now;
      twin.samples.value = recorded = recorded.slice(-MAX_SAMPLES);
    }
  });
}

/** Starts following the state. */
export function startSimulations(): void {
  document.addEventListener('visibilitychange', () => (isVisible.value = !document.hidden));
  effect(() => {
    const { value: wanted } = simulationKey;
    if (view.step.value !== 'test') return untracked(closeWorker);
    // Frames of a body that is no longer shown would be mistaken for those of the next one.
    if (!results.body.value) return untracked(clearFrames);
    if (wanted === null) return untracked(invalidate);
    untracked(invalidate);
    const timer = setTimeout(() => void start(shownMesh.value!), REST_MILLISECONDS);
    return () => clearTimeout(timer);
  });
  effect(() => {
    const isPlaying = isMoving();
    untracked(() => void remote?.play(isPlaying));
  });
  effect(() => {
    const request = frameRequest();
    untracked(() => void remote?.setRequest(request));
  });
}
