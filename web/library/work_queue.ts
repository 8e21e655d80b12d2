/** The worker and the queue of requests. The worker is started by the first request, and again after it has ended. */

import { LimberError } from './options';
import type { RunOptions } from './options';
import type { CommandName, Commands, Failure, ModelFiles, StartedWorker, WorkMessage } from './protocol';
import { startWorker } from './start_worker';

interface Work {
  command: CommandName;
  models: Promise<ModelFiles[]>;
  options: Commands[CommandName]['options'];
  run: RunOptions;
  resolve(value: unknown): void;
  reject(reason: unknown): void;
}

class WorkQueue {
  private readonly waiting: Work[] = [];
  private running: Work | null = null;
  private worker: Promise<StartedWorker> | null = null;
  /** what the worker was started for */
  private threads = 0;
  /** of the last call that named them: a page serves them to all of its workers */
  private assets: RunOptions['assets'];

  /** Rejects with the signal's reason where it is aborted, otherwise with a LimberError. */
  run<Name extends CommandName>(
    command: Name,
    models: Promise<ModelFiles[]>,
    options: Commands[Name]['options'],
    run: RunOptions,
  ): Promise<Commands[Name]['reply']> {
    return new Promise((resolve, reject) => {
      const { signal } = run;
      // If the models cannot be read, the error is reported when it is their turn.
      models.catch(() => {});
      if (signal?.aborted) return reject(signal.reason);
      const onAbort = () => this.abort(work, signal!.reason);
      const settle =
        <Value>(end: (value: Value) => void) =>
        (value: Value): void => {
          signal?.removeEventListener('abort', onAbort);
          end(value);
        };
      const ends = { resolve: settle(resolve) as Work['resolve'], reject: settle(reject) };
      const work: Work = { command, models, options, run, ...ends };
      signal?.addEventListener('abort', onAbort, { once: true });
      this.waiting.push(work);
      this.next();
    });
  }

  /** Ends the worker and frees its memory; running and waiting work is rejected. */
  close(): void {
    const open = [...(this.running ? [this.running] : []), ...this.waiting.splice(0)];
    this.running = null;
    this.endWorker();
    for (const work of open) work.reject(new LimberError('The library was closed while it worked.'));
  }

  private next(): void {
    if (this.running) return;
    const work = this.waiting.shift();
    if (!work) return;
    this.running = work;
    work.models.then(
      (models) => this.begin(work, models).catch((error: unknown) => this.fail(work, error)),
      (error: unknown) => this.refuse(work, error),
    );
  }

  private async begin(work: Work, models: ModelFiles[]): Promise<void> {
    if (this.running !== work) return;
    const { run, command, options } = work;
    this.useThreads(options.threads ?? 0);
    this.assets = run.assets ?? this.assets;
    this.worker ??= this.start();
    const worker = await this.worker;
    if (this.running !== work) return;
    worker.keepAlive(true);
    try {
      worker.post({ command, models, options, core: worker.core });
    } catch (error) {
      throw isUnclonable(error) ? new LimberError(UNCLONABLE) : error;
    }
  }

  /** A core keeps its memory and its build, so that one for another number of threads is another worker's. */
  private useThreads(threads: number): void {
    if (threads !== this.threads) this.endWorker();
    this.threads = threads;
  }

  private start(): Promise<StartedWorker> {
    const { assets, threads } = this;
    // A worker that has been replaced may still have a message on its way.
    const isCurrent = () => this.worker === started;
    const started: Promise<StartedWorker> = startWorker(
      {
        onMessage: (message) => void (isCurrent() && this.receive(message)),
        onError: (error) => void (isCurrent() && this.lose(error)),
      },
      { assets: assets === undefined ? null : String(assets), threads },
    );
    return started;
  }

  /** The worker has ended by itself; the next work gets another one. */
  private lose(error: Error): void {
    if (this.running) this.fail(this.running, error);
    else this.endWorker();
  }

  private receive(message: WorkMessage): void {
    const work = this.running;
    if (!work) return;
    if ('progress' in message) return this.tell(work, message);
    this.running = null;
    if ('value' in message) work.resolve(message.value);
    else work.reject(errorOf(message.failure));
    // An internal failure may have left the core in a broken state.
    if ('failure' in message && message.failure.isInternal) this.endWorker();
    else void this.worker?.then((worker) => this.running ?? worker.keepAlive(false));
    this.next();
  }

  /** An error of the caller's function ends the work. */
  private tell(work: Work, { progress }: Extract<WorkMessage, { progress: unknown }>): void {
    try {
      work.run.onProgress?.(progress);
    } catch (error) {
      this.abort(work, error);
    }
  }

  /** The core cannot be interrupted from outside in every build, so a running work ends with its worker. */
  private abort(work: Work, reason: unknown): void {
    const index = this.waiting.indexOf(work);
    if (index >= 0) this.waiting.splice(index, 1);
    if (this.running === work) this.end();
    work.reject(reason);
    this.next();
  }

  private fail(work: Work, error: unknown): void {
    this.end();
    work.reject(error instanceof LimberError ? error : internalError(error));
    this.next();
  }

  /** There is no model to send: the worker knows nothing of it and stays. */
  private refuse(work: Work, error: unknown): void {
    if (this.running === work) this.running = null;
    work.reject(error instanceof LimberError ? error : internalError(error));
    this.next();
  }

  private end(): void {
    this.running = null;
    this.endWorker();
  }

  private endWorker(): void {
    // One that could not be started has nothing to end.
    this.worker?.then(
      (worker) => worker.terminate(),
      () => {},
    );
    this.worker = null;
  }
}

/** Whether a message could not be sent because of what is in it. */
const isUnclonable = (error: unknown): boolean => (error as Partial<Error> | null)?.name === 'DataCloneError';

const UNCLONABLE =
  'The call cannot be sent to the worker: give options that are plain numbers, texts and lists, and bytes that have not been transferred.';

const internalError = (error: unknown): LimberError =>
  new LimberError(error instanceof Error ? error.message : String(error), null, true);

const errorOf = ({ message, setting, isInternal }: Failure): LimberError =>
  new LimberError(message, setting, isInternal);

let queue: WorkQueue | null = null;

/** The queue of this thread. */
export const workQueue = (): WorkQueue => (queue ??= new WorkQueue());
