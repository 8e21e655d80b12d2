/** Checks of a batch before any work. */

import { existsSync, realpathSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { SOLVER_NAMES } from '../../engine/solvers/profiles';
import type { Arguments } from '../arguments';
import { UsageError } from '../failure';
import { findAt } from '../output_files/identity';
import { checkOutputs, isWritable } from '../output_files/outputs';
import { isOwnFile } from '../output_files/own_files';
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

/** The summary is written over no asset, and over no file of the user's own without --force. */
export function checkReports({ reports, force, batch }: Arguments, requests: AssetRequest[]): void {
  const capacity = { model: 0, positions: 0 };
  const outputs = reports.map((path) => ({ path, flag: '--report', isGlb: false, capacity }));
  const sources = requests.map(({ asset }) => asset.path);
  if (reports.length > 0)
    checkOutputs(outputs, batch.config === null ? sources : [...sources, batch.config], force);
}

/** Throws UsageError where settings files are asked for and no asset that is to have one has a solver. */
export function checkSettingsFiles(requests: AssetRequest[]): void {
  const asked = requests.filter(({ options }) => options.settingsFiles);
  if (asked.length > 0 && asked.every(({ options: { solver = 'none' } }) => solver === 'none'))
    throw new UsageError(
      `--settings-files needs a solver: --solver ${SOLVER_NAMES.join('|')}, or "solver" in the configuration.`,
    );
}
