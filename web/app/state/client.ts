/** The page's side of the worker: calls, progress and cancellation, and a new worker after a crash. */

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

/** ms after which a worker that does not respond to a cancellation is ended. */
const PATIENCE = 10_000;

/** The memory limit of the core in bytes, from `?memory=` in the address; undefined: no limit. Throws an Error. */
function memoryAsked(): number | undefined {
  const text = new URLSearchParams(location.search).get('memory');
  return text === null ? undefined : coreMemory(text, '?memory=');
}

/** A call failed because its worker has ended. */
export class WorkerLost extends Error {}

/** One worker, and the promise that rejects when it ends unexpectedly. */
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
   * `base`: the address of the page's folder, with a final slash. `onLost`: called when a worker has ended while
   * nothing ran. `listen`, if given, receives the port at which the histories of each worker arrive.
   */
  constructor(
    private readonly base: string,
    private readonly onLost: () => void,
    private readonly listen?: (port: MessagePort) => void,
  ) {
    this.started = this.startWorker();
    this.started.catch(() => {});
  }

  /** Starts a worker, which reopens the open files. If it ends before that, there is no further attempt. */
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
    watchLife(lock, () => onError('the browser has ended it, perhaps because memory ran out'));
    if (this.files) await Promise.race([current.remote.open(this.files), current.ended]);
    isStarted = true;
    this.threads = started.threads;
    this.job = started.job;
    return started;
  }

  /** The worker has ended unexpectedly: a new one opens the same files, and the running call fails. */
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
    // A failed start is reported by the next call.
    this.started.catch(() => {});
    ended.end(error);
  }

  ready(): Promise<Started> {
    return this.started;
  }

  /** Uses idle time to compile the engine; see warm_up.ts. */
  async warmUp(): Promise<void> {
    await this.started;
    const { current } = this;
    await Promise.race([current.remote.warmUp(), current.ended]);
  }

  /** Opens files; if that fails, the earlier file stays open. The bytes are kept for a worker that must be restarted. */
  async open(files: SourceFile[]): Promise<OpenedFile> {
    // Stops the warm-up of the engine; calls clear the flag as they start.
    if (this.job) Atomics.store(this.job, 0, 1);
    const opened = await this.call<OpenedFile>((remote) => remote.open(files));
    this.files = files;
    return opened;
  }

  /** Calls the worker; ends early with CANCELLED if `cancel` is called meanwhile. */
  call<T>(make: (remote: Remote<WorkerApi>) => Promise<unknown>): Promise<T> {
    this.lastProgress = null;
    // The progress of the last call does not apply to this one.
    if (this.job) Atomics.store(this.job, 1, PHASES.indexOf('idle'));
    return new Promise<T>((resolve, reject) => {
      // From here on it can be cancelled, even while a new worker is still starting.
      this.abandon = reject;
      this.aside<T>(make).then(resolve, reject);
    }).finally(() => (this.abandon = null));
  }

  /** A short call that waits until the running one has ended, without stopping it. */
  async aside<T>(make: (remote: Remote<WorkerApi>) => Promise<unknown>): Promise<T> {
    const { started } = this;
    // Of several waiting calls, the first one retries for all.
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

  /** Another attempt to start if the last one has failed. Throws if the worker was ended for good. */
  private retry(): Promise<Started> {
    if (this.hasEnded) throw new Error(CANCELLED);
    this.current.worker.terminate();
    return (this.started = this.startWorker());
  }

  /** Progress of the running call, read from shared memory or from the last message of the worker. */
  progress(): CallProgress | null {
    // Until the worker has reported something, the values in shared memory may belong to one body of many.
    if (!this.job || !this.lastProgress) return this.lastProgress;
    const [phase, fraction] = [Atomics.load(this.job, 1), Atomics.load(this.job, 2) / 10000];
    return { phase: PHASES[phase], fraction, share: this.lastProgress.share };
  }

  /** Whether a running call can be stopped without losing what the worker has computed. */
  get canStop(): boolean {
    return this.job !== null;
  }

  /** Stops the running call: by a flag in shared memory, or by replacing the worker with a new one that opens the same files again. */
  cancel(): void {
    if (!this.abandon) return;
    if (this.job) return this.requestCancel(this.job);
    this.forceCancel();
  }

  /** Stops the running call, which may not respond, by replacing the worker with a new one that opens the same files again. */
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
  // Most workers end while no call waits.
  ended.catch(() => {});
  // A script that cannot be loaded causes an event without a message.
  worker.addEventListener('error', ({ message }) => onError(message ?? 'Failed to fetch its script'));
  return { worker, remote: wrap<WorkerApi>(worker), ended, end };
}
