/** What every command needs: the loaded core, the opened model, progress and warnings. */

import { existsSync } from 'node:fs';
import type { Core, Progress } from '../engine/core/core';
import type { OpenModel } from '../engine/document/open';
import { openModel } from '../engine/document/open';
import { describeHealth } from '../engine/body/health';
import { loadCore } from '../engine/core/load_core';
import { prepareBody } from '../engine/stages/pipeline';
import type { PreparedBody } from '../engine/stages/pipeline';
import type { Report } from '../engine/report/report';
import type { Arguments } from './arguments';
import { UsageError } from './failure';
import { checkFolder, readModelFiles, writeWhole } from './files';
import { plain } from './words';

export interface Session {
  args: Arguments;
  core: Core;
  /** Warnings are told at the end, so that a failure is one line. */
  warnings: string[];
  /** what the progress line says before the phase */
  activity: string;
}

const CLEAR_LINE = '\r\u001b[K';

export async function startSession(args: Arguments): Promise<Session> {
  for (const report of args.reports) if (report !== '-') checkFolder(report);
  const session = { args, warnings: [], activity: '' };
  const showsProgress = !args.quiet && process.stderr.isTTY;
  const onProgress = showsProgress ? (progress: Progress) => showProgress(session, progress) : undefined;
  const core = await loadCore({ threads: args.settings.threads, wasmFolder: findWasm(), onProgress });
  return Object.assign(session, { core });
}

/** The core lies beside the built page, or in a working copy in public/. */
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

/** The chosen bodies made ready; null for one without a usable face, which is an error where none is left. */
export function prepareBodies(session: Session, model: OpenModel): (PreparedBody | null)[] {
  const chosen = new Set(chosenBodies(session, model));
  let failure: Error | null = null;
  const prepared = model.bodies.map((body, i) => {
    if (!chosen.has(i)) return null;
    session.activity = body.name;
    try {
      return prepareBody(session.core, body, session.args.settings, model.document);
    } catch (error) {
      if (!(error instanceof Error) || error.constructor !== Error) throw error;
      failure ??= error;
      session.warnings.push(`${error.message.replace(/\.$/, '')}; it stays as it is`);
      return null;
    }
  });
  if (failure && prepared.every((body) => body === null)) throw failure;
  for (const body of prepared) if (body) warnAbout(session, model, body);
  return prepared;
}

function warnAbout({ warnings }: Session, model: OpenModel, { body, weld, inspection }: PreparedBody): void {
  const name = model.bodies.length > 1 ? `${body.name}: ` : '';
  for (const { kind, text } of describeHealth(body, weld, inspection))
    if (kind !== 'fact') warnings.push(`${name}${text}`);
}

export const usable = (bodies: (PreparedBody | null)[]): PreparedBody[] =>
  bodies.filter((body) => body !== null);

/**
 * Writes the report where it was asked for; `text` is what stdout gets where the report does not go there. `missed` says
 * why targets were not reached, and is said even where nothing else is.
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
