/** The worker that replays histories. It has a core of its own, so that the slider does not wait for a fit. */

import { expose } from 'comlink';
import { loadCore } from '../../engine/core/load_core';
import { giveAway } from './handing_over';
import { keepAlive } from './life';
import { Replay } from './replay';
import type { HandedHistory, ReplayApi } from './replay';

let started: (replay: Replay) => void;
let failed: (error: unknown) => void;
const replay = new Promise<Replay>((resolve, reject) => ([started, failed] = [resolve, reject]));

const api: ReplayApi = {
  start: async (wasmFolder, lock) => {
    await keepAlive(lock);
    await loadCore({ wasmFolder, threads: 1 }).then((core) => started(new Replay(core)), failed);
    await replay;
  },
  listen: (port) => {
    port.onmessage = ({ data }: MessageEvent<HandedHistory>) => void replay.then((one) => one.keep(data));
  },
  meshAt: async (id, faces) => {
    const mesh = await (await replay).meshAt(id, faces);
    return mesh && giveAway(mesh);
  },
};

expose(api);
