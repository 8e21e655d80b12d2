/** limber batch SRC... OUT */

import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import {
  EMPTY_CONFIG,
  isExcluded,
  readBatchConfig,
  unusedPatterns,
} from '../../engine/settings/batch_config';
import { startStopwatch } from '../../engine/core/stopwatch';
import type { Arguments } from '../arguments';
import { EXIT, inFlags, UsageError } from '../failure';
import { makeFolder } from '../files';
import { readText } from '../input_files/read_file';
import { STANDARD } from '../standard';
import { counted, grouped } from '../../engine/core/words';
import { inOneLine } from '../words';
import { checkOut, checkReports, checkSettingsFiles } from './checks';
import { runDryBatch } from './dry';
import { Journal } from './journal';
import { takeLock } from './lock';
import { memoryLimit } from './memory';
import { requestsOf } from './orders';
import type { AssetRequest } from './orders';
import { sentenceOn } from './progress';
import { OWN_FOLDER } from './results';
import { BatchRun } from './run';
import { findSources } from './sources';
import { describeTotals, summaryOf } from './summary';
import type { Summary } from './summary';
import { writeSummary } from './write_summary';

export async function runBatch(args: Arguments): Promise<number> {
  const seconds = startStopwatch();
  const out = args.operands[args.operands.length - 1];
  checkOut(args, out);
  const { requests, notes } = readRequests(args, out);
  checkSettingsFiles(requests);
  checkReports(args, requests, out);
  sayNotes(args, [...args.formerWords.map(inFlags), ...notes]);
  const own = join(out, OWN_FOLDER);
  if (args.dryRun) return runDryBatch(args, out, requests, new Journal(own));
  makeFolder(own);
  const unlock = takeLock(own, out);
  try {
    const journal = new Journal(own);
    const crew = crewOf(args, requests.length);
    sayNotes(args, journal.notes);
    sayStart(args, requests, crew);
    journal.gather();
    const run = new BatchRun({ args, out, journal, ...crew }, requests);
    stopOnSignal(run, unlock);
    const rows = await run.all();
    journal.gather();
    const summary = summaryOf(rows, seconds());
    writeSummary(args, out, summary);
    return finish(args, out, summary);
  } finally {
    unlock();
  }
}

/** `notes`: what of the configuration or a preset counts for nothing. Throws where it, a source or a setting is not usable: nothing is begun then. */
function readRequests(args: Arguments, out: string): { requests: AssetRequest[]; notes: string[] } {
  const words = args.operands.slice(0, -1);
  if (args.operands.includes(STANDARD))
    throw new UsageError('A batch reads and writes folders: use limber optimize for stdin and stdout.');
  const { config: path } = args.batch;
  const config = path === null ? EMPTY_CONFIG : readBatchConfig(readText(path), path);
  const sources = findSources(words, out).filter(({ name }) => !isExcluded(config, name));
  if (sources.length === 0) throw new UsageError(`${path} excludes all models: remove some of its patterns.`);
  const names = sources.map(({ name }) => name);
  const { requests, notes } = requestsOf(config, args, sources);
  return { requests, notes: [...unusedPatterns(config, names, path ?? ''), ...notes] };
}

/** The number of jobs and their resources. */
export interface Crew {
  jobs: number;
  /** of each job */
  threads: number;
  /** bytes of each job */
  memory: number;
}

/** Threads of one job beyond which more do not help. */
const MAX_THREADS = 8;

export function crewOf({ batch, settings }: Arguments, assets: number, cores = availableParallelism()): Crew {
  const jobs = Math.max(1, Math.min(batch.jobs || cores, assets));
  const share = Math.max(1, Math.min(MAX_THREADS, Math.floor(cores / jobs)));
  return { jobs, threads: settings.threads || share, memory: memoryLimit(batch.memory, jobs) };
}

function sayNotes({ quiet }: Arguments, notes: string[]): void {
  if (!quiet) for (const note of notes) process.stderr.write(`limber: ${inOneLine(note)}.\n`);
}

function sayStart({ quiet }: Arguments, requests: AssetRequest[], { jobs, threads, memory }: Crew): void {
  if (quiet) return;
  const megabytes = grouped(Math.floor(memory / 2 ** 20));
  process.stderr.write(
    `${counted(requests.length, 'asset')}, ${counted(jobs, 'job')} of ${counted(threads, 'thread')} and at most ${megabytes} MB each\n`,
  );
}

/** On a signal, finished assets are kept; the same command continues with the rest. */
function stopOnSignal(run: BatchRun, unlock: () => void): void {
  const codes = { SIGINT: 130, SIGTERM: 143 } as const;
  for (const signal of ['SIGINT', 'SIGTERM'] as const)
    process.once(signal, () => {
      run.stop();
      unlock();
      process.stderr.write('limber: stopped; run the same command again to continue.\n');
      process.exit(codes[signal]);
    });
}

function finish(args: Arguments, out: string, summary: Summary): number {
  const { totals, assets } = summary;
  if (!args.quiet && !args.reports.includes(STANDARD))
    process.stdout.write(`${inOneLine(`${describeTotals(totals)} -> ${join(out, 'summary.html')}`)}\n`);
  for (const { asset, state, sentences } of assets) {
    const told = state === 'done' ? (args.verbose ? sentences : []) : sentences.slice(0, 1);
    for (const sentence of told) process.stderr.write(`limber: ${sentenceOn(asset, sentence)}\n`);
  }
  if (totals.failed > 0) return EXIT.badInput;
  return totals.missed > 0 ? EXIT.missedTarget : EXIT.done;
}
