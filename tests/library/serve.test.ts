/** What the worker of the library answers. */

import { expect, it } from 'vitest';
import type { SimulateOptions } from '../../web/library/options';
import type { WorkMessage } from '../../web/library/protocol';
import { Server } from '../../web/library/work/serve';
import { textFile } from '../engine/support/files';
import { toObj, torus } from '../engine/support/shapes';

const wasmFolder = new URL('../../public/wasm/', import.meta.url).href;

/** The last message on a simulation of a ring beside itself. */
async function simulated(options: SimulateOptions): Promise<WorkMessage> {
  const messages: WorkMessage[] = [];
  const ring = [textFile('ring.obj', toObj(torus()))];
  await new Server((message) => messages.push(message)).answer({
    command: 'simulate',
    models: [ring, ring],
    options: { seconds: 0.1, substeps: 2, threads: 1, ...options },
    core: { wasmFolder },
  });
  return messages.at(-1)!;
}

it('calibrates where nothing is said of the material, as the command line does, and refuses springs', async () => {
  expect(await simulated({ calibrate: true })).toMatchObject({
    value: { report: { calibration: [{ factor: expect.closeTo(1, 3) as number }] } },
  });
  expect(await simulated({ calibrate: true, material: 'springs' })).toMatchObject({
    failure: { message: 'calibrate is for material "shell" and no solver: leave the others out.' },
  });
});
