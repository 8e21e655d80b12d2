/** What the worker of the library answers. */

import { expect, it } from 'vitest';
import type { SimulateOptions } from '../../web/library/options';
import type { ModelFiles, WorkMessage, WorkRequest } from '../../web/library/protocol';
import { resultBytes } from '../../web/library/work/result_bytes';
import { Server } from '../../web/library/work/serve';
import { textFile } from '../engine/support/files';
import { addRichMesh, glbFile, startDocument } from '../engine/support/gltf';
import { grid, toObj, torus } from '../engine/support/shapes';

const wasmFolder = new URL('../../public/wasm/', import.meta.url).href;

const RING = [textFile('ring.obj', toObj(torus()))];

/** The last message on a request. */
async function answered(request: Omit<WorkRequest, 'core'>): Promise<WorkMessage> {
  const messages: WorkMessage[] = [];
  await new Server((message) => messages.push(message)).answer({ ...request, core: { wasmFolder } });
  return messages.at(-1)!;
}

/** The last message on a simulation of a ring beside itself. */
const simulated = (options: SimulateOptions): Promise<WorkMessage> =>
  answered({
    command: 'simulate',
    models: [RING, RING],
    options: { seconds: 0.1, substeps: 2, threads: 1, ...options },
  });

it('calibrates where nothing is said of the material, as the command line does, and refuses springs', async () => {
  expect(await simulated({ calibrate: true })).toMatchObject({
    value: { report: { calibration: [{ factor: expect.closeTo(1, 3) as number }] } },
  });
  expect(await simulated({ calibrate: true, material: 'springs' })).toMatchObject({
    failure: { message: 'calibrate is for material "shell" and no solver: leave the others out.' },
  });
});

it('notes a target that is missed, as the command line warns of it, and knows settings by their names', async () => {
  const asked = { threads: 1, wantsBodies: false };
  const notesOf = async (options: object) => {
    const message = await answered({
      command: 'optimize',
      models: [RING],
      options: { ...asked, ...options },
    });
    return (message as { value: { notes: string[] } }).value.notes;
  };
  expect(await notesOf({ faces: 2, maxDeviation: 0 })).toEqual([
    expect.stringMatching(/^Stopped at \d+ faces, not 2: /),
  ]);
  expect(await notesOf({ faces: 2 })).toEqual([
    expect.stringMatching(/the next collapses would exceed 1 %; maxDeviation 0 lifts this limit$/),
  ]);
  expect(await notesOf({ lods: [0.001] })).toEqual([
    expect.stringMatching(/^ring_lod1.glb: ring stopped at \d+ faces, /),
  ]);
  expect(await notesOf({ lods: [0.001], lodStyle: 'msft' })).toEqual([
    expect.stringMatching(/^ring.glb, level 1: ring stopped at \d+ faces, /),
  ]);
});

it('notes what shapes of modes leave out', async () => {
  const document = startDocument();
  addRichMesh(document, 'sheet', grid(3, 3));
  const message = await answered({
    command: 'modes',
    models: [[await glbFile(document)]],
    options: { threads: 1, writesShapes: true },
  });
  const { notes } = (message as { value: { notes: string[] } }).value;
  expect(notes.at(-1)).toMatch(/^the shapes leave out 1 morph target\b/);
});

it('notes that bodies without area have no modes to compare', async () => {
  const line = [textFile('line.obj', 'v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n')];
  const message = await answered({ command: 'compare', models: [line, line], options: { threads: 1 } });
  const { notes } = (message as { value: { notes: string[] } }).value;
  expect(notes).toEqual(['first model: line: no modes to compare: its triangles have no area']);
});

it('answers a request once, and tells of files of the core that the caller does not serve, which is no error of ours', async () => {
  const messages: WorkMessage[] = [];
  const server = new Server((message) => messages.push(message));
  const core = { wasmFolder: 'http://localhost:1/limber/' };
  await server.answer({ command: 'inspect', models: [RING], options: { threads: 1 }, core });
  server.fail(new Error('Aborted'));
  const message =
    'The core in http://localhost:1/limber/ cannot be loaded: serve all files of limber/assets, of this version and unchanged, from its folder.';
  expect(messages).toEqual([{ failure: { message, setting: null, isInternal: false } }]);
});

it('gives results in memory of their own where the model lies in shared memory', async () => {
  const [{ name, bytes }] = RING;
  const shared = new Uint8Array(new SharedArrayBuffer(bytes.length));
  shared.set(bytes);
  // A copy of all bytes where nothing is asked to change.
  const message = await answered({
    command: 'optimize',
    models: [[{ name, bytes: shared }]],
    options: { threads: 1, ratio: 1, format: 'obj', wantsBodies: false },
  });
  const { files } = (message as { value: { files: ModelFiles } }).value;
  for (const file of files) expect(file.bytes.buffer).toBeInstanceOf(ArrayBuffer);
  expect(resultBytes(shared)).toEqual(bytes);
  expect(resultBytes(shared).buffer).toBeInstanceOf(ArrayBuffer);
  expect(resultBytes(bytes)).toBe(bytes);
});

it('doubts the size of what is moved where it is implausible in metres', async () => {
  const notesOf = async (command: 'simulate' | 'tune' | 'optimize', options: object) => {
    const models = command === 'optimize' ? [RING] : [RING, RING];
    const message = await answered({ command, models, options: { threads: 1, ...options } });
    return (message as { value: { notes: string[] } }).value.notes;
  };
  const doubt = /^(first model: )?ring: the body is .* km across: set unit if the file is not in metres$/;
  const short = { seconds: 0.05, substeps: 2 };
  expect(await notesOf('simulate', short)).toEqual([]);
  expect(await notesOf('simulate', { ...short, unit: 1000 })).toEqual([expect.stringMatching(doubt)]);
  for (const command of ['tune', 'optimize'] as const)
    expect(await notesOf(command, { solver: 'springs', unit: 1000 })).toContainEqual(
      expect.stringMatching(doubt),
    );
  expect(await notesOf('optimize', { unit: 1000 })).toEqual([]);
});

it('notes which of two models has been welded, and not where there is one', async () => {
  const square = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 4 5 6\n';
  const models = [textFile('a.obj', square)];
  const notesOf = async (command: 'compare' | 'modes', all: ModelFiles[]) => {
    const message = await answered({ command, models: all, options: { threads: 1 } });
    return (message as { value: { notes: string[] } }).value.notes;
  };
  expect(await notesOf('modes', [models])).toEqual(['2 seam vertices welded']);
  expect(await notesOf('compare', [models, models])).toEqual([
    'first model: 2 seam vertices welded',
    'second model: 2 seam vertices welded',
  ]);
});
