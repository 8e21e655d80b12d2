/** The page's side of the worker: calls, progress and cancel. */

import { proxy, wrap } from 'comlink';
import type { Remote } from 'comlink';
import { PHASES } from '../../engine/core/core';
import type { SourceFile } from '../../engine/document/open';
import { carrySettingErrors } from '../worker/errors';
import { CANCELLED } from '../worker/protocol';
import type { CallProgress, OpenedFile, Started, WorkerApi } from '../worker/protocol';

carrySettingErrors();

export class Client {
  private worker!: Worker;
  private remote!: Remote<WorkerApi>;
  private started: Promise<Started>;
  private job: Int32Array | null = null;
  private lastProgress: CallProgress | null = null;
  private files: SourceFile[] | null = null;
  private abandon: ((error: Error) => void) | null = null;
  threads = 1;

  /** `base`: the address of the folder above wasm/, with a final slash. */
  constructor(private readonly base: string) {
    this.started = this.startWorker();
  }

  private startWorker(): Promise<Started> {
    this.worker = new Worker(new URL('../worker/worker.ts', import.meta.url), { type: 'module' });
    this.remote = wrap<WorkerApi>(this.worker);
    const onProgress = proxy((progress: CallProgress) => (this.lastProgress = progress));
    return this.remote.start(new URL('wasm/', this.base).href, 0, onProgress).then((started) => {
      this.threads = started.threads;
      this.job = started.job;
      return started;
    });
  }

  ready(): Promise<Started> {
    return this.started;
  }

  /** Opens files; where that fails, the earlier file stays open. The bytes are kept for a worker that must start again. */
  async open(files: SourceFile[]): Promise<OpenedFile> {
    const opened = await this.call<OpenedFile>((remote) => remote.open(files));
    this.files = files;
    return opened;
  }

  /** One call of the worker, which ends early with CANCELLED when `cancel` is called meanwhile. */
  call<T>(make: (remote: Remote<WorkerApi>) => Promise<unknown>): Promise<T> {
    this.lastProgress = null;
    return new Promise<T>((resolve, reject) => {
      // From here on it can be cancelled, also while a fresh worker is still starting.
      this.abandon = reject;
      this.started.then(() => make(this.remote)).then((value) => resolve(value as T), reject);
    }).finally(() => (this.abandon = null));
  }

  /** A short call that waits until the running one has ended, without stopping it. */
  aside<T>(make: (remote: Remote<WorkerApi>) => Promise<unknown>): Promise<T> {
    return this.started.then(() => make(this.remote)).then((value) => value as T);
  }

  /** Progress of the running call, read from shared memory or from the last message of the worker. */
  progress(): CallProgress | null {
    if (!this.job) return this.lastProgress;
    const [phase, fraction] = [Atomics.load(this.job, 1), Atomics.load(this.job, 2) / 10000];
    return { phase: PHASES[phase], fraction, part: this.lastProgress?.part };
  }

  /** Whether a running call can be stopped without losing what the worker has computed. */
  get canStop(): boolean {
    return this.job !== null;
  }

  /** Stops the running call: by a flag in shared memory, or by a fresh worker that opens the same files again. */
  cancel(): void {
    if (!this.abandon) return;
    if (this.job) return this.requestCancel(this.job);
    this.worker.terminate();
    this.abandon(new Error(CANCELLED));
    this.started = this.startWorker().then(async (started) => {
      if (this.files) await this.remote.open(this.files);
      return started;
    });
  }

  /** A call clears the flag as it starts, so the flag is set again and again until this call has ended. */
  private requestCancel(job: Int32Array): void {
    const call = this.abandon;
    const repeat = () => {
      if (this.abandon !== call) return clearInterval(timer);
      Atomics.store(job, 0, 1);
    };
    const timer = setInterval(repeat, 15);
    repeat();
  }
}
