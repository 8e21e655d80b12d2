/** The worker of the Test step: a core of its own, so that what else is computed neither waits for it nor stops it. */

import { expose, transfer } from 'comlink';
import type { Core } from '../../engine/core';
import { loadCore } from '../../engine/load_core';
import { simulationOptions } from '../../engine/simulation';
import { Twin } from '../../engine/twin';
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

function makeTwin({ original, result, size, settings, pinned }: TwinSetup): Twin {
  return new Twin(core, original, result, {
    ...simulationOptions(size, settings, pinned),
    diagonal: size.diagonal,
    measuresNoise: true,
  });
}

/** One for each body. */
const MOST_THREADS = 3;

const api: SimulationApi = {
  load: async (wasmFolder, showFrame) => {
    show = (frame) => showFrame(moved(frame));
    core = await loadCore({ wasmFolder, threads: Math.min(MOST_THREADS, navigator.hardwareConcurrency) });
  },
  start: async (setup, wishes) => {
    loop?.end();
    loop = null;
    // A thread for each body: then the hidden run costs nothing.
    const keepsNoise = setup.noise === 'always' || core.threads >= MOST_THREADS;
    loop = new SimulationLoop(makeTwin(setup), setup.number, show, { wishes, keepsNoise });
  },
  wish: async (wishes) => loop?.wish(wishes),
  play: async (isPlaying) => loop?.play(isPlaying),
  step: async () => loop?.step(),
  grab: async (name, point) => loop?.grab(name, point),
  drag: async (target) => loop?.drag(target),
  release: async () => loop?.release(),
};

expose(api);
