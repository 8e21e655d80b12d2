/** How a client starts workers: none once it was ended, whatever it was doing, and one for all calls that wait. */

import { expose } from 'comlink';
import { beforeEach, expect, it, vi } from 'vitest';
import { Client } from '../../web/app/state/client';
import { CANCELLED } from '../../web/app/worker/protocol';

/** The locks of workers that live, and how a browser frees them. */
const locks = new Map<string, () => void>();
let workers: FakeWorker[] = [];
/** whether workers answer at all, and whether they can start */
let [isAnswering, isStarting] = [true, true];

/** Answers every call, and has its lock until it is terminated. */
class FakeWorker {
  private readonly ports = new MessageChannel();
  private lock = '';
  postMessage = this.ports.port1.postMessage.bind(this.ports.port1);
  addEventListener = this.ports.port1.addEventListener.bind(this.ports.port1);
  removeEventListener = this.ports.port1.removeEventListener.bind(this.ports.port1);

  constructor() {
    workers.push(this);
    this.ports.port1.start();
    const start = (_options: unknown, _progress: unknown, lock: string) => {
      this.lock = lock;
      if (!isStarting) throw new Error('No network.');
      return { threads: 1, job: null };
    };
    if (isAnswering) expose({ start, open: () => ({ name: 'a.obj' }) }, this.ports.port2);
  }

  terminate(): void {
    this.ports.port1.close();
    locks.get(this.lock)?.();
  }
}

vi.stubGlobal('location', { search: '' });
vi.stubGlobal('Worker', FakeWorker);
vi.stubGlobal('navigator', {
  locks: { request: (lock: string, onFree: () => void) => locks.set(lock, onFree) },
});

const rest = () => new Promise((resolve) => setTimeout(resolve, 20));
const lost = vi.fn();

beforeEach(() => {
  workers = [];
  lost.mockClear();
});

it('the requested end of its worker is not reported as a loss', async () => {
  isAnswering = true;
  const client = new Client('http://localhost/', lost);
  await client.open([]);
  client.end();
  await rest();
  expect([workers.length, lost.mock.calls.length]).toEqual([1, 0]);
});

it('a call that waits for the worker to start is cancelled', async () => {
  isAnswering = false;
  const client = new Client('http://localhost/', lost);
  const opened = client.open([]);
  client.end();
  await expect(opened).rejects.toThrow(CANCELLED);
  await rest();
  expect([workers.length, lost.mock.calls.length]).toEqual([1, 0]);
});

it('calls that wait for a worker which has not started try again together', async () => {
  [isAnswering, isStarting] = [true, false];
  const client = new Client('http://localhost/', lost);
  await expect(client.ready()).rejects.toThrow('No network.');
  isStarting = true;
  const open = () => client.aside<{ name: string }>((worker) => worker.open([]));
  expect(await Promise.all([open(), open()])).toEqual([{ name: 'a.obj' }, { name: 'a.obj' }]);
  expect(workers).toHaveLength(2);
  client.end();
});
