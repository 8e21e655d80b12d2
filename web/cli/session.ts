/** What every command needs: the loaded core, the opened files, progress and warnings. */

import { existsSync } from 'node:fs';
import { describeHealth } from '../engine/body/health';
import type { PreparedBody } from '../engine/body/prepared_body';
import type { Core, Progress } from '../engine/core/core';
import { loadCore } from '../engine/core/load_core';
import { openModel } from '../engine/document/open';
import type { OpenModel } from '../engine/document/open';
import type { Report } from '../engine/report/report';
import { FileRun } from '../engine/stages/file_run';
import type { Arguments } from './arguments';
import { inFlags, UsageError } from './failure';
import { checkFolder, readModelFiles, writeWhole } from './files';
import { count, plain } from './words';

export interface Session {
  args: Arguments;
  core: Core;
  /** written at the end, so that a failure is one line */
  warnings: string[];
  /** the beginning of the progress line, before the phase */
  activity: string;
}

const CLEAR_LINE = '\r\u001b[K';

export async function startSession(args: Arguments): Promise<Session> {
  for (const report of args.reports) if (report !== '-') checkFolder(report);
  const session = { args, warnings: args.formerWords.map(inFlags), activity: '' };
  const showsProgress = !args.quiet && process.stderr.isTTY;
  const onProgress = showsProgress ? (progress: Progress) => showProgress(session, progress) : undefined;
  const core = await loadCore({ threads: args.settings.threads, wasmFolder: findWasm(), onProgress });
  return Object.assign(session, { core });
}

/** The core is beside the built page, or in public/ in a working copy. */
function findWasm(): string {
  const folders = ['../app/wasm/', '../../public/wasm/'].map((folder) => new URL(folder, import.meta.url));
  const found = folders.find((folder) => existsSync(new URL('limber-single.mjs', folder)));
  if (!found) throw new UsageError('The WebAssembly core is missing: run npm run build.');
  return found.href;
}

function showProgress({ activity }: { activity: string }, { phase, fraction }: Progress): void {
  process.stderr.write(`${CLEAR_LINE}${plain(activity)}: ${phase} ${Math.round(100 * fraction)} %`);
}

export function clearProgress(): void {
  if (process.stderr.isTTY) process.stderr.write(CLEAR_LINE);
}

export async function openFile(session: Session, path: string): Promise<OpenModel> {
  const model = await openModel(readModelFiles(path));
  session.warnings.push(...model.notes);
  return model;
}

/** The numbers of the bodies that --mesh names; all without it. */
export function chosenBodies({ args }: Session, model: OpenModel): number[] {
  const numbers = model.bodies.map((_, i) => i);
  if (args.mesh === null) return numbers;
  const chosen = numbers.filter((i) => model.bodies[i].name === args.mesh);
  if (chosen.length > 0) return chosen;
  const names = model.bodies.map((body) => `"${body.name}"`).slice(0, 20);
  throw new UsageError(`${model.name} has no body "${args.mesh}": it has ${names.join(', ')}.`);
}

/** A run over the chosen bodies, prepared. A body without a usable face stays as it is; an error where no other is left. */
export function prepareFile(session: Session, model: OpenModel): FileRun {
  const { args, core, warnings } = session;
  const onActivity = (body: string, triedFaces?: number): void => {
    session.activity = triedFaces === undefined ? body : `${body}, trying ${count(triedFaces)} faces`;
  };
  const guides = args.command === 'optimize';
  const file = new FileRun(core, model, { chosen: chosenBodies(session, model), guides, onActivity });
  for (const sentence of file.leaveOutUnusable(args.settings))
    warnings.push(`${sentence.replace(/\.$/, '')}; it stays as it is`);
  for (const body of file.prepared(args.settings)) warnAbout(session, model, body);
  return file;
}

function warnAbout({ warnings }: Session, model: OpenModel, { body, weld, inspection }: PreparedBody): void {
  const name = model.bodies.length > 1 ? `${body.name}: ` : '';
  for (const { kind, text } of describeHealth(body, weld, inspection))
    if (kind !== 'fact') warnings.push(`${name}${text}`);
}

/**
 * Writes the report where it was asked for, and `text` to stdout where the report does not go there. `missed`: why targets
 * were not reached; written to stderr even with --quiet.
 */
export function finish(
  { args, core, warnings }: Session,
  report: Report,
  text: string,
  missed: string[] = [],
): void {
  clearProgress();
  const { timings, ...others } = report;
  const json = `${JSON.stringify({ ...others, peakHeapBytes: core.peakHeapBytes(), timings }, null, 2)}\n`;
  for (const path of args.reports) if (path !== '-') writeWhole(path, json);
  if (args.reports.includes('-')) process.stdout.write(json);
  else if (!args.quiet) process.stdout.write(`${plain(text)}\n`);
  if (!args.quiet) for (const warning of warnings) process.stderr.write(`limber: ${plain(warning)}.\n`);
  for (const sentence of missed) process.stderr.write(`limber: ${plain(sentence)}.\n`);
}
