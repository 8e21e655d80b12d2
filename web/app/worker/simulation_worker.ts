/** The worker of the Test step: a core of its own, so that what else is computed neither waits for it nor stops it. */

import { expose, transfer } from 'comlink';
import type { Core } from '../../engine/core/core';
import { loadCore } from '../../engine/core/load_core';
import { calibrationOf, simulationOptions, STEP_SECONDS } from '../../engine/motion/simulation';
import { Twin } from '../../engine/motion/twin';
import { SimulationLoop } from './simulation_loop';
import type { ShowFrame, SimulationApi, TwinFrame, TwinSetup } from './simulation_protocol';

let core: Core;
let loop: SimulationLoop | null = null;
let show: ShowFrame;

/** A frame's arrays are the page's once they are sent. */
function moved(frame: TwinFrame): TwinFrame {
  const { original, optimized } = frame.bodies;
  const arrays = [original.positions, original.pins, optimized.positions, optimized.pins, frame.driven];
  const all = [...arrays, frame.deviations].filter((array) => array !== null);
  return transfer(
    frame,
    all.map((array) => array.buffer),
  );
}

let calibrated = { key: '', factor: 1 };

/** It takes a while, and depends on no setting of the simulation. */
function calibrationFor({ original, result, meshKey, size, settings }: TwinSetup): number {
  if (!settings.calibrate) return 1;
  const key = `${meshKey} ${settings.thickness} ${settings.poisson}`;
  if (calibrated.key !== key)
    calibrated = { key, factor: calibrationOf(core, { ...size, mesh: original }, result.mesh, settings) };
  return calibrated.factor;
}

function makeTwin(setup: TwinSetup): Twin {
  const { original, result, size, settings, pinned } = setup;
  return new Twin(core, original, result, {
    ...simulationOptions(size, settings, pinned),
    calibration: calibrationFor(setup),
    diagonal: size.diagonal,
    measuresNoise: true,
  });
}

/** One for each body. */
const MOST_THREADS = 3;

/** Of the threads' time, for stepping; the page and its pictures need some too. */
const SPARE_SHARE = 0.5;

const api: SimulationApi = {
  load: async (wasmFolder, showFrame) => {
    show = (frame) => showFrame(moved(frame));
    core = await loadCore({ wasmFolder, threads: Math.min(MOST_THREADS, navigator.hardwareConcurrency) });
  },
  start: async (setup, constraints) => {
    loop?.end();
    loop = null;
    // A thread for each body: then the hidden run costs nothing.
    const keepsNoise = setup.noise === 'always' || core.threads >= MOST_THREADS;
    const spareSeconds = keepsNoise ? Infinity : SPARE_SHARE * core.threads * STEP_SECONDS;
    const twin = makeTwin(setup);
    loop = new SimulationLoop(twin, setup.number, show, { constraints, spareSeconds });
    return twin.collisionScene;
  },
  setRequest: async (constraints) => loop?.setRequest(constraints),
  play: async (isPlaying) => loop?.play(isPlaying),
  step: async () => loop?.step(),
  grab: async (name, point) => loop?.grab(name, point),
  drag: async (target) => loop?.drag(target),
  release: async () => loop?.release(),
};

expose(api);
