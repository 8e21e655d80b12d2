/** The page's side of the worker: calls, progress and cancel, and a fresh worker where one has ended by itself. */

import { proxy, transfer, wrap } from 'comlink';
import type { Remote } from 'comlink';
import { PHASES } from '../../engine/core/core';
import { coreMemory } from '../../engine/core/memory_size';
import type { SourceFile } from '../../engine/document/open';
import { carrySettingErrors } from '../worker/errors';
import { watchLife } from '../worker/life';
import { CANCELLED, CORE_BROKEN } from '../worker/protocol';
import type { CallProgress, OpenedFile, Started, WorkerApi } from '../worker/protocol';
import { coreFolder } from '../worker/core_folder';

carrySettingErrors();

/** ms after which a worker that does not answer a cancel is ended. */
const PATIENCE = 10_000;

/** Bytes that the core may take, of `?memory=` in the address; undefined: as many as it can. Throws an Error. */
function memoryAsked(): number | undefined {
  const text = new URLSearchParams(location.search).get('memory');
  return text === null ? undefined : coreMemory(text, '?memory=');
}

/** A call ended because its worker did. */
export class WorkerLost extends Error {}

/** One worker, and the promise that rejects when it ends by itself. */
interface Running {
  worker: Worker;
  remote: Remote<WorkerApi>;
  ended: Promise<never>;
  end(error: Error): void;
}

export class Client {
  private current!: Running;
  private started: Promise<Started>;
  private job: Int32Array | null = null;
  private lastProgress: CallProgress | null = null;
  private files: SourceFile[] | null = null;
  private abandon: ((error: Error) => void) | null = null;
  private hasEnded = false;
  threads = 1;

  /**
   * `base`: the address of the page's folder, with a final slash. `onLost`: a worker has ended while nothing ran.
   * `listen`, if any, is given the port at which the histories of each worker arrive.
   */
  constructor(
    private readonly base: string,
    private readonly onLost: () => void,
    private readonly listen?: (port: MessagePort) => void,
  ) {
    this.started = this.startWorker();
    this.started.catch(() => {});
  }

  /** Starts a worker, which opens the files that were open before. What ends it before that is not tried again. */
  private async startWorker(): Promise<Started> {
    let isStarted = false;
    const onError = (why: string) => (isStarted ? this.lose(current, why) : current.end(new WorkerLost(why)));
    const current = (this.current = openWorker(onError));
    const onProgress = proxy((progress: CallProgress) => (this.lastProgress = progress));
    const lock = `limber-worker-${crypto.randomUUID()}`;
    const starting = current.remote.start(
      { wasmFolder: coreFolder(this.base), threads: 0, memory: memoryAsked() },
      onProgress,
      lock,
    );
    const started = await Promise.race([starting, current.ended]);
    if (this.listen) {
      const { port1, port2 } = new MessageChannel();
      await Promise.race([current.remote.connect(transfer(port1, [port1])), current.ended]);
      this.listen(port2);
    }
    watchLife(lock, () => onError('the browser has ended it, perhaps for want of memory'));
    if (this.files) await Promise.race([current.remote.open(this.files), current.ended]);
    isStarted = true;
    this.threads = started.threads;
    this.job = started.job;
    return started;
  }

  /** The worker has ended by itself: a fresh one opens the same files, and the running call fails. */
  private lose(lost: Running, why: string): void {
    if (lost !== this.current || this.hasEnded) return;
    const wasIdle = this.abandon === null;
    this.restart(lost, new WorkerLost(why));
    if (wasIdle) this.onLost();
  }

  /** Ends the worker. Its calls fail with `error`. */
  private restart(ended: Running, error: Error): void {
    ended.worker.terminate();
    this.job = null;
    this.started = this.startWorker();
    // A failed start is told to whoever calls next.
    this.started.catch(() => {});
    ended.end(error);
  }

  ready(): Promise<Started> {
    return this.started;
  }

  /** Spends time in which nothing is asked on compiling the engine; see warm_up.ts. */
  async warmUp(): Promise<void> {
    await this.started;
    const { current } = this;
    await Promise.race([current.remote.warmUp(), current.ended]);
  }

  /** Opens files; where that fails, the earlier file stays open. The bytes are kept for a worker that must start again. */
  async open(files: SourceFile[]): Promise<OpenedFile> {
    // Stops what the engine computes to warm up; calls clear the flag as they start.
    if (this.job) Atomics.store(this.job, 0, 1);
    const opened = await this.call<OpenedFile>((remote) => remote.open(files));
    this.files = files;
    return opened;
  }

  /** One call of the worker, which ends early with CANCELLED when `cancel` is called meanwhile. */
  call<T>(make: (remote: Remote<WorkerApi>) => Promise<unknown>): Promise<T> {
    this.lastProgress = null;
    // What the last call told does not stand for this one.
    if (this.job) Atomics.store(this.job, 1, PHASES.indexOf('idle'));
    return new Promise<T>((resolve, reject) => {
      // From here on it can be cancelled, also while a fresh worker is still starting.
      this.abandon = reject;
      this.aside<T>(make).then(resolve, reject);
    }).finally(() => (this.abandon = null));
  }

  /** A short call that waits until the running one has ended, without stopping it. */
  async aside<T>(make: (remote: Remote<WorkerApi>) => Promise<unknown>): Promise<T> {
    const { started } = this;
    // Of several calls that wait, the first one tries again for all.
    await started.catch(() => (started === this.started ? this.retry() : this.started));
    const { current } = this;
    try {
      return (await Promise.race([make(current.remote), current.ended])) as T;
    } catch (error) {
      if (!(error instanceof Error) || !error.message.startsWith(CORE_BROKEN)) throw error;
      const why = error.message.slice(CORE_BROKEN.length);
      if (current === this.current) this.restart(current, new WorkerLost(why));
      throw new WorkerLost(why);
    }
  }

  /** Another try to start, where the last one has failed. Throws where the worker was ended for good. */
  private retry(): Promise<Started> {
    if (this.hasEnded) throw new Error(CANCELLED);
    this.current.worker.terminate();
    return (this.started = this.startWorker());
  }

  /** Progress of the running call, read from shared memory or from the last message of the worker. */
  progress(): CallProgress | null {
    // Until the worker has told something, what is in shared memory may be of one body of many.
    if (!this.job || !this.lastProgress) return this.lastProgress;
    const [phase, fraction] = [Atomics.load(this.job, 1), Atomics.load(this.job, 2) / 10000];
    return { phase: PHASES[phase], fraction, share: this.lastProgress.share };
  }

  /** Whether a running call can be stopped without losing what the worker has computed. */
  get canStop(): boolean {
    return this.job !== null;
  }

  /** Stops the running call: by a flag in shared memory, or by a fresh worker that opens the same files again. */
  cancel(): void {
    if (!this.abandon) return;
    if (this.job) return this.requestCancel(this.job);
    this.forceCancel();
  }

  /** Stops the running call, which may not answer, by a fresh worker that opens the same files again. */
  forceCancel(): void {
    const { abandon } = this;
    if (!abandon) return;
    abandon(new Error(CANCELLED));
    this.restart(this.current, new Error(CANCELLED));
  }

  /** Ends the worker for good: its calls fail as cancelled, and there must be no further ones. */
  end(): void {
    this.hasEnded = true;
    this.current.worker.terminate();
    this.current.end(new Error(CANCELLED));
    this.job = null;
  }

  /** A call clears the flag as it starts, so the flag is set again and again until this call has ended. */
  private requestCancel(job: Int32Array): void {
    const call = this.abandon;
    const latest = performance.now() + PATIENCE;
    const repeat = () => {
      if (this.abandon !== call || this.job !== job) return clearInterval(timer);
      Atomics.store(job, 0, 1);
      if (performance.now() > latest) this.forceCancel();
    };
    const timer = setInterval(repeat, 15);
    repeat();
  }
}

function openWorker(onError: (why: string) => void): Running {
  const worker = new Worker(new URL('../worker/worker.ts', import.meta.url), { type: 'module' });
  let end: (error: Error) => void = () => {};
  const ended = new Promise<never>((_, reject) => (end = reject));
  // Most workers are ended while no call waits.
  ended.catch(() => {});
  // A script that cannot be loaded gives an event without a message.
  worker.addEventListener('error', ({ message }) => onError(message ?? 'Failed to fetch its script'));
  return { worker, remote: wrap<WorkerApi>(worker), ended, end };
}
