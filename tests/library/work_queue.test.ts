/** When the library starts a worker. */

import { beforeEach, expect, it, vi } from 'vitest';
import type { Listener, StartedWorker } from '../../web/library/protocol';
import { LimberError } from '../../web/library/options';
import type { ModelFiles } from '../../web/library/protocol';
import { workQueue } from '../../web/library/work_queue';

const { startWorker, terminate } = vi.hoisted(() => ({ startWorker: vi.fn(), terminate: vi.fn() }));
vi.mock('../../web/library/start_worker', () => ({ startWorker }));

startWorker.mockImplementation(async ({ onMessage }: Listener): Promise<StartedWorker> => ({
  core: { wasmFolder: '' },
  post: () => queueMicrotask(() => onMessage({ value: { notes: [] } as never })),
  keepAlive: () => {},
  terminate,
}));

const NO_MODELS: Promise<ModelFiles[]> = Promise.resolve([]);

beforeEach(() => {
  workQueue().close();
  vi.clearAllMocks();
});

it('starts a worker for each number of threads and ends the one before, whose core keeps its memory', async () => {
  for (const threads of [undefined, 0, 1, 1, 2]) await workQueue().run('inspect', NO_MODELS, { threads }, {});
  expect(startWorker.mock.calls.map(([, { threads }]) => threads as number)).toEqual([0, 1, 2]);
  expect(terminate).toHaveBeenCalledTimes(2);
});

it('starts another worker where one has ended while nothing ran', async () => {
  await workQueue().run('inspect', NO_MODELS, {}, {});
  const [{ onError }] = startWorker.mock.calls[0] as [Listener];
  onError(new Error('out of memory'));
  await workQueue().run('inspect', NO_MODELS, {}, {});
  expect(startWorker).toHaveBeenCalledTimes(2);
  onError(new Error('A late message of the first one ends nothing.'));
  await workQueue().run('inspect', NO_MODELS, {}, {});
  expect(startWorker).toHaveBeenCalledTimes(2);
});

it('starts later workers from the folder that the first call has named', async () => {
  await workQueue().run('inspect', NO_MODELS, {}, { assets: '/limber/' });
  workQueue().close();
  await workQueue().run('inspect', NO_MODELS, {}, {});
  expect(startWorker.mock.calls.map(([, { assets }]) => assets as string)).toEqual(['/limber/', '/limber/']);
});

it('tells in a sentence that a call cannot be sent, which is no error of the library', async () => {
  startWorker.mockImplementationOnce(async () => ({
    core: { wasmFolder: '' },
    post: (request: object) => void structuredClone(request),
    keepAlive: () => {},
    terminate,
  }));
  const options = { young: () => 1 } as object;
  await expect(workQueue().run('inspect', NO_MODELS, options, {})).rejects.toMatchObject({
    name: 'LimberError',
    isInternal: false,
    message: expect.stringMatching(/^The call cannot be sent to the worker: give /) as string,
  });
});

it('starts another worker after an error inside, which may have broken the core, and not after bad input', async () => {
  const failures = [true, false].map((isInternal) => ({ message: 'No.', setting: null, isInternal }));
  for (const failure of failures) {
    startWorker.mockImplementationOnce(async ({ onMessage }: Listener) => ({
      core: { wasmFolder: '' },
      post: () => queueMicrotask(() => onMessage({ failure })),
      keepAlive: () => {},
      terminate,
    }));
    await expect(workQueue().run('inspect', NO_MODELS, {}, {})).rejects.toMatchObject(failure);
  }
  expect(startWorker).toHaveBeenCalledTimes(2);
  await expect(workQueue().run('inspect', NO_MODELS, {}, {})).rejects.toMatchObject(failures[1]);
  expect(startWorker).toHaveBeenCalledTimes(2);
});

it('works on calls in their order, whichever model is ready first', async () => {
  const order: string[] = [];
  const slow = new Promise<ModelFiles[]>((resolve) => setTimeout(() => resolve([]), 20));
  const first = workQueue()
    .run('inspect', slow, {}, {})
    .then(() => order.push('slow'));
  const second = workQueue()
    .run('inspect', NO_MODELS, {}, {})
    .then(() => order.push('ready'));
  await Promise.all([first, second]);
  expect(order).toEqual(['slow', 'ready']);
});

it('ends calls whose models are not ready when it is closed, and goes on with the next', async () => {
  const ended = workQueue().run('inspect', new Promise(() => {}), {}, {});
  workQueue().close();
  await expect(ended).rejects.toThrow(new LimberError('The library was closed while it worked.'));
  await workQueue().run('inspect', NO_MODELS, {}, {});
  expect(startWorker).toHaveBeenCalledTimes(1);
});

it('keeps the worker where a model cannot be had', async () => {
  await workQueue().run('inspect', NO_MODELS, {}, {});
  vi.clearAllMocks();
  const error = new LimberError('There is no model.');
  await expect(workQueue().run('inspect', Promise.reject(error), {}, {})).rejects.toBe(error);
  await expect(workQueue().run('inspect', Promise.reject(new Error('x')), {}, {})).rejects.toMatchObject({
    isInternal: true,
  });
  await workQueue().run('inspect', NO_MODELS, {}, {});
  expect(startWorker).not.toHaveBeenCalled();
  expect(terminate).not.toHaveBeenCalled();
});
