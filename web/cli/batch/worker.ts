/**
 * A process that works on one asset after the other. It writes into a folder of its own, from where the batch takes results when they are
 * whole, so that one that has lost its batch changes nothing.
 */

import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, relative, sep } from 'node:path';
import { materialOf } from '../../engine/body/material';
import type { Core } from '../../engine/core/core';
import { sum } from '../../engine/core/mesh';
import { startStopwatch } from '../../engine/core/stopwatch';
import { isModelName } from '../../engine/document/format_names';
import { worstFidelity } from '../../engine/report/fidelity_report';
import { describeFailure } from '../failure';
import { writing } from '../file_error';
import { finishOptimize, missedOf, optimizeModel } from '../optimize';
import type { Optimized } from '../optimize';
import { loadSessionCore } from '../core_start';
import { startSession } from '../session';
import type { Session } from '../session';
import { warningLines } from '../warnings';
import { hashOf, keyOf } from './key';
import type { StagedFile, WorkDone, WorkOrder } from './messages';
import { drawAsset } from './picture/asset_picture';
import { failedRecord, NO_NUMBERS } from './record';
import type { AssetNumbers, AssetRecord } from './record';

const batch = process.ppid;
let loaded: { threads: number; core: Promise<Core> } | null = null;

process.on('disconnect', () => process.exit());
process.on('message', (order: WorkOrder) => {
  void work(order).then((done) => process.send!(done));
});

/** The core calls this in the midst of its loops, where no message arrives. */
function endWithoutBatch(): void {
  if (process.ppid !== batch) process.exit();
}

function coreFor(threads: number): Promise<Core> {
  if (loaded?.threads === threads) return loaded.core;
  const core = loadSessionCore(threads, endWithoutBatch);
  loaded = { threads, core };
  // What failed may have been the machine, so that the next asset tries again.
  core.catch(() => (loaded = null));
  return core;
}

async function work(order: WorkOrder): Promise<WorkDone> {
  const seconds = startStopwatch();
  const files: StagedFile[] = [];
  const write = (path: string, content: Uint8Array | string) => {
    files.push(stage(order, files.length, { path, content }));
  };
  try {
    const core = await coreFor(order.args.settings.threads);
    const session = await startSession(order.args, { core, write });
    const { state, numbers, sentences, picture } = await optimizeAsset(session, order, files);
    const key = keyOf([...session.checked.files.values()][0], order, order.result);
    const written = files.map(({ name, bytes, sha256 }) => ({ name, bytes, sha256 }));
    const record = { asset: order.asset, state, key, written, sentences, ...numbers, seconds: seconds() };
    return { record, files, picture, memory: process.memoryUsage().rss };
  } catch (error) {
    const record = failedRecord(order.asset, describeFailure(error).line, seconds());
    return { record, files: [], picture: null, memory: process.memoryUsage().rss };
  }
}

function stage(
  { folder, out }: WorkOrder,
  number: number,
  { path, content }: { path: string; content: Uint8Array | string },
): StagedFile {
  const staged = join(folder, `${number}.part`);
  writing(path, () => writeFileSync(staged, content));
  const name = relative(out, path).split(sep).join('/');
  return { staged, path, name, bytes: Buffer.byteLength(content), sha256: hashOf(content) };
}

type AssetResult = Pick<AssetRecord, 'state' | 'sentences'> & {
  numbers: AssetNumbers;
  picture: string | null;
};

async function optimizeAsset(session: Session, order: WorkOrder, files: StagedFile[]): Promise<AssetResult> {
  const watches = { total: startStopwatch(), lap: startStopwatch() };
  const done = await optimizeModel(session, watches);
  const sources = [...session.checked.files.values()][0];
  const bytesBefore = sources.reduce((sum, { bytes }) => sum + bytes.length, 0);
  if (!('report' in done)) {
    const numbers = { ...NO_NUMBERS, bytesBefore, bytesAfter: bytesOfResult(order, files) };
    return { state: 'done', sentences: [done.passedOn], numbers, picture: null };
  }
  try {
    finishOptimize(session, done);
    if (done.levels.failure) throw new Error(done.levels.failure.sentence);
    const missed = session.args.soft ? [] : missedOf(session.args, done.output, done.levels).requested;
    return {
      state: missed.length > 0 ? 'missed' : 'done',
      sentences: [...missed, ...warningLines(session.warnings, session.args.verbose)],
      numbers: { ...numbersOf(session, done, order), bytesBefore, bytesAfter: bytesOfResult(order, files) },
      picture: await pictureOf(done, order, files),
    };
  } finally {
    done.file.dispose();
  }
}

function numbersOf(session: Session, { output, report }: Optimized, { options }: WorkOrder): AssetNumbers {
  const { before, after } = output.writtenFaces();
  return {
    ...NO_NUMBERS,
    facesBefore: before,
    facesAfter: after,
    deviation: report.surface?.hausdorff ?? null,
    frequencyError: options.frequencies ? frequencyErrorOf(session, output) : null,
  };
}

/** As limber compare measures it; null where the modes of a body cannot be found. */
function frequencyErrorOf({ core, args }: Session, output: Optimized['output']): number | null {
  try {
    const results = output.results();
    const all = output.prepared().map((original, i) => {
      const material = materialOf(original, args.settings);
      return core.compareFidelity(original.mesh, results[i].mesh, { modeCount: 10, ...material });
    });
    return worstFidelity(all)?.frequencyErrorMean ?? null;
  } catch {
    return null;
  }
}

/** The result itself among what was written. */
const mainOf = ({ args }: WorkOrder, files: StagedFile[]): StagedFile =>
  files.find(({ path }) => path === args.operands[1])!;

/** Bytes of the result with what belongs to it, which is written before it; levels and reports come after. */
const bytesOfResult = (order: WorkOrder, files: StagedFile[]): number =>
  sum(files.slice(0, files.indexOf(mainOf(order, files)) + 1).map(({ bytes }) => bytes));

/** A model that cannot be drawn is no failure. */
async function pictureOf({ file }: Optimized, order: WorkOrder, files: StagedFile[]): Promise<string | null> {
  try {
    const main = mainOf(order, files);
    const needed = files.filter((one) => one === main || !isModelName(one.path));
    const written = needed.map(({ path, staged }) => ({
      name: relative(dirname(main.path), path).split(sep).join('/'),
      bytes: new Uint8Array(readFileSync(staged)),
    }));
    const path = join(order.folder, 'picture.png');
    writeFileSync(path, await drawAsset(file.model, written));
    return path;
  } catch {
    return null;
  }
}
