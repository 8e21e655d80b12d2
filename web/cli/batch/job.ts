/** One of the processes that work on assets; it is started when it is needed, and again after it has ended. */

import { fork } from 'node:child_process';
import type { ChildProcess } from 'node:child_process';
import { rmSync } from 'node:fs';
import { grouped } from '../../engine/core/words';
import { makeFolder } from '../files';
import { memoryOf } from './memory';
import type { WorkDone, WorkOrder } from './messages';
import { failedRecord } from './record';

export interface JobOptions {
  /** the file of the command line, and what it is started with */
  program: string;
  words: string[];
  /** bytes */
  memory: number;
  /** the job's own folder */
  folder: string;
}

const MEGABYTE = 2 ** 20;
/** Milliseconds between checks of the memory. */
const LOOKS = 100;
/** The share of its memory limit that a process may retain from earlier assets before it is replaced. */
const KEPT_SHARE = 0.5;
/** Of what a process says before it ends. */
const MAX_LETTERS = 2000;

export class Job {
  private worker: ChildProcess | null = null;
  private said = '';

  constructor(private readonly options: JobOptions) {}

  get folder(): string {
    return this.options.folder;
  }

  /** Processes an asset. If the process ends early, only its asset fails. Throws UsageError if the folder cannot be created. */
  async work(order: WorkOrder): Promise<WorkDone> {
    const { folder, memory } = this.options;
    rmSync(folder, { recursive: true, force: true });
    makeFolder(folder);
    const started = performance.now();
    this.worker ??= this.start();
    const outcome = await this.outcome(this.worker, order);
    if (typeof outcome !== 'string') {
      if (outcome.memory > KEPT_SHARE * memory) this.end();
      return outcome;
    }
    this.end();
    const record = failedRecord(order.asset, outcome, (performance.now() - started) / 1000);
    return { record, files: [], picture: null, memory: 0 };
  }

  end(): void {
    this.worker?.kill('SIGKILL');
    this.worker = null;
  }

  private start(): ChildProcess {
    const { program, words, memory } = this.options;
    const worker = fork(program, words, {
      serialization: 'advanced',
      stdio: ['ignore', 'ignore', 'pipe', 'ipc'],
      execArgv: [`--max-old-space-size=${Math.max(64, Math.floor(memory / MEGABYTE))}`],
    });
    this.said = '';
    worker.stderr!.on('data', (text: Buffer) => {
      this.said = (this.said + text.toString()).slice(-MAX_LETTERS);
    });
    return worker;
  }

  /** The answer of the process, or a sentence on why there is none. */
  private outcome(worker: ChildProcess, order: WorkOrder): Promise<WorkDone | string> {
    return new Promise((resolve) => {
      let isTooLarge = false;
      const look = setInterval(() => {
        if ((memoryOf(worker.pid ?? 0) ?? 0) <= this.options.memory) return;
        isTooLarge = true;
        clearInterval(look); // a process that ends has no memory to look at
        worker.kill('SIGKILL');
      }, LOOKS);
      const settle = (value: WorkDone | string) => {
        clearInterval(look);
        worker.removeAllListeners();
        // Errors of a process that is being ended are of no interest.
        worker.on('error', () => {});
        resolve(value);
      };
      worker.on('message', (done: WorkDone) => settle(done));
      worker.on('error', (error) => settle(`its process could not be started: ${error.message}`));
      worker.on('exit', (code, signal) => settle(isTooLarge ? this.tooLarge() : this.ended(code, signal)));
      worker.send(order, (error) => error && settle(`its process could not be reached: ${error.message}`));
    });
  }

  private tooLarge(): string {
    const megabytes = grouped(Math.floor(this.options.memory / MEGABYTE));
    return `needs more than the ${megabytes} MB of a job: raise --memory, or lower --jobs`;
  }

  private ended(code: number | null, signal: NodeJS.Signals | null): string {
    if (/heap out of memory|Array buffer allocation failed/i.test(this.said)) return this.tooLarge();
    return `its process ended with ${signal ?? `exit code ${code}`}, perhaps because of an internal error or a lack of memory: try it alone with limber optimize`;
  }
}
