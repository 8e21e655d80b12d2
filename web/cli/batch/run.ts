/** Runs a batch: jobs take one asset after the other; assets that are up to date are skipped. */

import { rmSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { staysObj } from '../../engine/document/write/output_form';
import type { Arguments } from '../arguments';
import { describeFailure } from '../failure';
import { makeFolder, readModelFiles } from '../files';
import { ASSET_WORKER } from './asset_worker';
import { Job } from './job';
import type { Journal } from './journal';
import { keyOf } from './key';
import type { WorkOrder } from './messages';
import { argumentsFor } from './orders';
import type { AssetRequest } from './orders';
import { BatchProgress } from './progress';
import { failedRecord } from './record';
import type { AssetRecord } from './record';
import { hashOfResult, OWN_FOLDER, Results } from './results';
import { reasonToDo } from './stale';
import type { Reason } from './stale';
import type { SummaryRow } from './summary';

export interface BatchOptions {
  args: Arguments;
  out: string;
  journal: Journal;
  jobs: number;
  threads: number;
  /** bytes of each job */
  memory: number;
}

/** Why an asset has to be done; null: it is up to date. */
export function reasonOf(request: AssetRequest, out: string, journal: Journal): Promise<Reason> {
  const { asset } = request;
  const carries = staysObj(asset.result, 'auto');
  const key = async () =>
    keyOf((await readModelFiles(asset.path, null, carries)).files, request, asset.result);
  return reasonToDo(journal.get(asset.name), key, (file) => hashOfResult(out, file));
}

export class BatchRun {
  private readonly rows: SummaryRow[] = [];
  private readonly progress: BatchProgress;
  private readonly results: Results;
  private readonly jobs: Job[];
  /** the folder of the jobs */
  private readonly work: string;
  private readonly looks = new Map<string, Promise<AssetRecord | null>>();
  private next = 0;

  constructor(
    private readonly options: BatchOptions,
    /** the largest files first, so that none of them is left to a single job at the end */
    private readonly requests: AssetRequest[],
  ) {
    const { args, out, journal, jobs, memory } = options;
    this.requests = [...requests].sort((a, b) => b.asset.bytes - a.asset.bytes);
    this.progress = new BatchProgress(requests.length, args);
    const byName = new Map(requests.map((request) => [request.asset.name, request]));
    this.results = new Results({
      ...{ out, force: args.force },
      sources: requests.map(({ asset }) => asset.path),
      known: journal.all().flatMap(({ written }) => written.map(({ name }) => name)),
      lookAt: (asset) => this.lookAt(byName.get(asset)!),
    });
    this.work = join(resolve(out), OWN_FOLDER, 'work');
    // What jobs of a killed run have left; those that still live find their folder gone, and end.
    rmSync(this.work, { recursive: true, force: true });
    this.jobs = Array.from({ length: jobs }, (_, i) => {
      const folder = join(this.work, `${process.pid}-${i}`);
      return new Job({ program: process.argv[1], words: [ASSET_WORKER], memory, folder });
    });
    this.expectResults();
  }

  /** Processes all assets; returns a record for each. */
  async all(): Promise<SummaryRow[]> {
    try {
      await Promise.all(this.jobs.map((job) => this.workThrough(job)));
    } finally {
      this.stop();
    }
    return this.rows;
  }

  /** Ends the jobs, and removes what they have not finished. */
  stop(): void {
    this.progress.clear();
    for (const job of this.jobs) job.end();
    // A process may write for the moment that its end takes.
    rmSync(this.work, { recursive: true, force: true, maxRetries: 3 });
  }

  /** Results of assets of this batch are theirs, unless they are done again; those of assets that are gone are nobody's. */
  private expectResults(): void {
    for (const { asset } of this.requests) {
      const record = this.options.journal.get(asset.name);
      if (record) this.results.expect(record);
    }
  }

  private async workThrough(job: Job): Promise<void> {
    while (this.next < this.requests.length) {
      const request = this.requests[this.next++];
      const { asset } = request;
      this.progress.begin(asset.name);
      const known = await this.lookAt(request);
      const record = known ?? (await this.done(job, request));
      if (!known) this.options.journal.add(record);
      this.progress.end(record, known !== null);
      this.rows.push({ ...record, isUnchanged: known !== null });
    }
  }

  /** What is remembered of an asset that is up to date, otherwise null; each is looked at once, so that the answer stays the same. */
  private lookAt(request: AssetRequest): Promise<AssetRecord | null> {
    const { name } = request.asset;
    const look = this.looks.get(name) ?? this.upToDate(request);
    this.looks.set(name, look);
    return look;
  }

  private async upToDate(request: AssetRequest): Promise<AssetRecord | null> {
    const { args, out, journal } = this.options;
    // The job says what is wrong with the input.
    const reason = args.batch.again
      ? 'asked for'
      : await reasonOf(request, out, journal).catch(() => 'failed');
    this.results.settle(request.asset.name, reason === null);
    return reason === null ? journal.get(request.asset.name)! : null;
  }

  private async done(job: Job, request: AssetRequest): Promise<AssetRecord> {
    try {
      const order = this.orderFor(request);
      makeFolder(dirname(order.args.operands[1]));
      const done = await job.work({ ...order, folder: job.folder });
      const record = await this.results.take(done);
      return { ...record, bytesBefore: done.record.bytesBefore || request.asset.bytes };
    } catch (error) {
      return failedRecord(request.asset.name, describeFailure(error).line);
    }
  }

  private orderFor(request: AssetRequest): Omit<WorkOrder, 'folder'> {
    const { args, threads, out } = this.options;
    const { asset, options, fromPreset } = request;
    return {
      asset: asset.name,
      args: argumentsFor(args, request, { out, threads }),
      options,
      fromPreset,
      result: asset.result,
      out,
    };
  }
}
