/** When the library starts a worker. */

import { beforeEach, expect, it, vi } from 'vitest';
import type { Listener, StartedWorker } from '../../web/library/protocol';
import { workQueue } from '../../web/library/work_queue';

const { startWorker, terminate } = vi.hoisted(() => ({ startWorker: vi.fn(), terminate: vi.fn() }));
vi.mock('../../web/library/start_worker', () => ({ startWorker }));

startWorker.mockImplementation(async ({ onMessage }: Listener): Promise<StartedWorker> => ({
  core: { wasmFolder: '' },
  post: () => queueMicrotask(() => onMessage({ value: { notes: [] } as never })),
  keepAlive: () => {},
  terminate,
}));

beforeEach(() => {
  workQueue().close();
  vi.clearAllMocks();
});

it('starts a worker for each number of threads and ends the one before, whose core keeps its memory', async () => {
  for (const threads of [undefined, 0, 1, 1, 2]) await workQueue().run('inspect', [], { threads }, {});
  expect(startWorker.mock.calls.map(([, { threads }]) => threads as number)).toEqual([0, 1, 2]);
  expect(terminate).toHaveBeenCalledTimes(2);
});

it('starts another worker where one has ended while nothing ran', async () => {
  await workQueue().run('inspect', [], {}, {});
  const [{ onError }] = startWorker.mock.calls[0] as [Listener];
  onError(new Error('out of memory'));
  await workQueue().run('inspect', [], {}, {});
  expect(startWorker).toHaveBeenCalledTimes(2);
  onError(new Error('A late message of the first one ends nothing.'));
  await workQueue().run('inspect', [], {}, {});
  expect(startWorker).toHaveBeenCalledTimes(2);
});

it('starts later workers from the folder that the first call has named', async () => {
  await workQueue().run('inspect', [], {}, { assets: '/limber/' });
  workQueue().close();
  await workQueue().run('inspect', [], {}, {});
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
  await expect(workQueue().run('inspect', [], options, {})).rejects.toMatchObject({
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
    await expect(workQueue().run('inspect', [], {}, {})).rejects.toMatchObject(failure);
  }
  expect(startWorker).toHaveBeenCalledTimes(2);
  await expect(workQueue().run('inspect', [], {}, {})).rejects.toMatchObject(failures[1]);
  expect(startWorker).toHaveBeenCalledTimes(2);
});
