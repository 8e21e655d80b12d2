/** The worker of the Test step. It has a core of its own, so that other computations neither wait for it nor stop it. */

import { expose, transfer } from 'comlink';
import type { Core } from '../../engine/core/core';
import { loadCore } from '../../engine/core/load_core';
import { STEP_SECONDS } from '../../engine/motion/simulation';
import { Twin } from '../../engine/motion/twin';
import { keepAlive } from './life';
import { TwinPlayer } from './simulation_player';
import type { ShowFrame, SimulationApi, TwinFrame, TwinSetup } from './simulation_protocol';
import { standingSetup } from './standing_setup';
import { calibrationFor, isCalibrated, twinOptions } from './twin_options';

let core: Core;
let player: TwinPlayer | null = null;
let show: ShowFrame;

/** Transfers the arrays of a frame to the page without copying them. */
function moved(frame: TwinFrame): TwinFrame {
  const { original, optimized } = frame.bodies;
  const arrays = [original.positions, original.pins, optimized.positions, optimized.pins, frame.driven];
  const all = [...arrays, frame.vertexDistances].filter((array) => array !== null);
  return transfer(
    frame,
    all.map((array) => array.buffer),
  );
}

let calibrated = { key: '', factor: 1 };

/** The last calibration is cached: it takes a while and depends on no setting of the simulation. */
function keptCalibration(setup: TwinSetup): number {
  if (!isCalibrated(setup)) return 1;
  const { meshKey, settings } = setup;
  const key = `${meshKey} ${settings.thickness} ${settings.poisson}`;
  if (calibrated.key !== key) calibrated = { key, factor: calibrationFor(core, setup) };
  return calibrated.factor;
}

function makeTwin(setup: TwinSetup): Twin {
  const { original, result, size } = setup;
  return new Twin(core, original, result, {
    ...twinOptions(setup),
    calibration: keptCalibration(setup),
    diagonal: size.diagonal,
    measuresNoise: true,
  });
}

/** One thread for each body. */
const MAX_THREADS = 3;

/** The share of the threads' time that steps may take; the page and its drawing need the rest. */
const SPARE_SHARE = 0.5;

const api: SimulationApi = {
  load: async (wasmFolder, showFrame, lifeLock) => {
    await keepAlive(lifeLock);
    show = (frame) => showFrame(moved(frame));
    core = await loadCore({ wasmFolder, threads: Math.min(MAX_THREADS, navigator.hardwareConcurrency) });
  },
  start: async (asked, request) => {
    const setup = standingSetup(asked);
    player?.end();
    player = null;
    // With a thread for each body the reordered run costs nothing.
    const keepsNoise = setup.noise === 'always' || core.threads >= MAX_THREADS;
    const spareSeconds = keepsNoise ? Infinity : SPARE_SHARE * core.threads * STEP_SECONDS;
    const twin = makeTwin(setup);
    player = new TwinPlayer(twin, setup, show, { request, spareSeconds });
    return twin.collisionScene;
  },
  setRequest: async (request) => player?.setRequest(request),
  play: async (isPlaying) => player?.play(isPlaying),
  step: async () => player?.step(),
  grab: async (name, point) => player?.grab(name, point),
  drag: async (target) => player?.drag(target),
  release: async () => player?.release(),
};

expose(api);
