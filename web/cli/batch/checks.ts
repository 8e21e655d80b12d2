/** Checks of a batch before any work. */

import { existsSync, realpathSync } from 'node:fs';
import { dirname, join, resolve, sep } from 'node:path';
import { SOLVER_NAMES } from '../../engine/solvers/profiles';
import type { Arguments } from '../arguments';
import { UsageError } from '../failure';
import { findAt } from '../output_files/identity';
import { checkOutputs, isWritable, outputsOf } from '../output_files/outputs';
import { isOwnFile } from '../output_files/own_files';
import { STANDARD } from '../standard';
import { argumentsFor } from './orders';
import type { AssetRequest } from './orders';
import { OWN_FOLDER } from './results';
import { hasSummary, SUMMARY_FILES } from './write_summary';

/** Throws UsageError where OUT is no folder for results, or the system does not let them be written there. */
export function checkOut({ operands, force }: Arguments, out: string): void {
  const found = findAt(out);
  if (!found) return checkWritable(out);
  if (!found.isDirectory()) throw new UsageError(`${out} is a file: name a folder for the results.`);
  const same = operands
    .slice(0, -1)
    .find((word) => existsSync(word) && realpathSync(word) === realpathSync(out));
  if (same !== undefined) throw new UsageError(`${out} is also SRC: choose another folder for the results.`);
  checkWritable(out);
  if (force || existsSync(join(out, OWN_FOLDER)) || hasSummary(out)) return;
  const foreign = SUMMARY_FILES.map((name) => join(out, name)).find(
    (path) => existsSync(path) && !isOwnFile(path),
  );
  if (foreign !== undefined)
    throw new UsageError(
      `${foreign} exists and was not written by limber: choose another folder, or replace it with --force.`,
    );
}

/** Throws UsageError where the folder, or the nearest one above it that exists, lets no files be made. */
function checkWritable(out: string): void {
  let folder = resolve(out);
  while (!existsSync(folder)) folder = dirname(folder);
  const own = join(out, OWN_FOLDER);
  if (!isWritable(folder) || (existsSync(own) && !isWritable(own)))
    throw new UsageError(
      `${out} cannot be written: ${folder === resolve(out) ? 'the folder' : folder} is write-protected, so choose another one.`,
    );
}

/** The summary is written over no asset, no result, and over no file of the user's own without --force. */
export function checkReports(args: Arguments, requests: AssetRequest[], out: string): void {
  const { force, batch } = args;
  const paths = args.reports.filter((path) => path !== STANDARD);
  if (paths.length === 0) return;
  const results = new Set(resultsOf(args, requests, out).map((path) => resolve(path)));
  const taken = paths.find((path) => results.has(resolve(path)));
  if (taken !== undefined)
    throw new UsageError(
      `${taken}, the file of --report, is also written by the batch itself: choose another name.`,
    );
  const capacity = { model: 0, positions: 0 };
  const outputs = paths
    .filter((path) => !isMadeWith(out, dirname(path)))
    .map((path) => ({ path, flag: '--report', isGlb: false, capacity }));
  const sources = requests.map(({ asset }) => asset.path);
  checkOutputs(outputs, batch.config === null ? sources : [...sources, batch.config], force);
}

/** Paths of all that the batch writes besides its reports; files that belong to a result are not known before the work. */
const resultsOf = (args: Arguments, requests: AssetRequest[], out: string): string[] => [
  ...SUMMARY_FILES.slice(1).map((name) => join(out, name)),
  ...requests
    .flatMap((request) => outputsOf(argumentsFor(args, request, { out, threads: 0 })))
    .map(({ path }) => path),
];

/** Whether a folder does not exist yet and is made with the folder of the results: it is that folder or one above it. */
const isMadeWith = (out: string, folder: string): boolean =>
  !existsSync(folder) && `${resolve(out)}${sep}`.startsWith(`${resolve(folder)}${sep}`);

/** Throws UsageError where settings files are asked for and no asset that is to have one has a solver. */
export function checkSettingsFiles(requests: AssetRequest[]): void {
  const asked = requests.filter(({ options }) => options.settingsFiles);
  if (asked.length > 0 && asked.every(({ options: { solver = 'none' } }) => solver === 'none'))
    throw new UsageError(
      `--settings-files needs a solver: --solver ${SOLVER_NAMES.join('|')}, or "solver" in the configuration.`,
    );
}
