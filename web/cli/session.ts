/** The state of a command: the loaded core, the opened files, progress and warnings. */

import type { Core } from '../engine/core/core';
import { openAnyModel, openModel } from '../engine/document/open';
import type { OpenModel, SourceFile } from '../engine/document/open';
import type { Report } from '../engine/report/report';
import { ofModel } from '../engine/report/warnings';
import type { Warning } from '../engine/report/warnings';
import { FileRun } from '../engine/stages/file_run';
import { preparedWarnings } from '../engine/stages/file_warnings';
import { pairedModel } from '../engine/body/paired_bodies';
import { chosenBodies } from '../engine/body/selection';
import type { Arguments } from './arguments';
import { takeCore } from './core_start';
import { describeFailure, inFlags, UsageError } from './failure';
import { writeWhole } from './files';
import { checkFiles } from './inputs';
import type { CheckedFiles } from './inputs';
import { checkRoom, sizeOfModel } from './output_files/outputs';
import { shownNames, shownOutput, STANDARD } from './standard';
import { clearProgress, showProgress } from './terminal';
import { warningLines } from './warnings';
import { counted } from '../engine/core/words';
import { inOneLine, plain } from './words';

export interface Session {
  args: Arguments;
  core: Core;
  /** what is read and written, checked before the work */
  checked: CheckedFiles;
  /** what has been written so far, as the user calls it */
  written: string[];
  /** writes a whole file, which it is for whoever runs the session to put where its path says */
  write: (path: string, content: Uint8Array | string) => void;
  /** whether a batch runs the session, for which a model without triangles is as good as any */
  isHosted: boolean;
  /** written at the end, so that a failure is one line */
  warnings: Warning[];
  /** the beginning of the progress line, before the phase */
  activity: string;
}

/** Who runs a session, where that is not the command line alone: it has a core already, and takes what is written. */
export type SessionHost = Pick<Session, 'core' | 'write'>;

/** Reads the files of the command and checks those that it writes, then loads the core. */
export async function startSession(args: Arguments, host?: SessionHost): Promise<Session> {
  const checked = await checkFiles(args);
  const warnings: Warning[] = args.formerWords.map(inFlags);
  const session = { args, checked, warnings, written: [], activity: '', write: writeWhole, isHosted: false };
  if (host) return { ...session, ...host, isHosted: true };
  const core = await takeCore(args, (progress) => showProgress(session.activity, progress));
  return Object.assign(session, { core });
}

/** Opens the model of an operand and makes sure that there is room for what comes of it. */
export async function openFile(session: Session, operand = 0): Promise<OpenModel> {
  return noted(session, operand, await openModel(filesOf(session, operand)));
}

/** As `openFile`, but a glTF without triangles opens as a model without bodies. */
export async function openAnyFile(session: Session, operand = 0): Promise<OpenModel> {
  return noted(session, operand, await openAnyModel(filesOf(session, operand)));
}

const filesOf = ({ args, checked }: Session, operand: number): SourceFile[] =>
  checked.files.get(args.operands[operand])!;

function noted(session: Session, operand: number, model: OpenModel): OpenModel {
  checkRoom(session.checked.outputs, sizeOfModel(model));
  warnOf(session, operand, model.notes);
  return model;
}

/** Adds warnings on the model of an operand, which they name where the command reads two. A model that is both of them has them once. */
export function warnOf({ args, warnings, checked }: Session, operand: number, found: Warning[]): void {
  if (checked.files.size === 1) {
    if (operand === 0) warnings.push(...found);
    return;
  }
  const name = shownNames(args.operands)[operand];
  warnings.push(...found.map((warning) => ofModel(name, warning)));
}

/** Writes an output. */
export function writeOutput(session: Session, path: string, content: Uint8Array | string): void {
  if (path === STANDARD) process.stdout.write(content);
  else session.write(path, content);
  session.written.push(shownOutput(path));
}

/** Writes an output; where that fails, the sentence has what was written before. */
export function save(session: Session, path: string, content: Uint8Array | string): void {
  try {
    writeOutput(session, path, content);
  } catch (error) {
    throw new UsageError(`${describeFailure(error).line.replace(/\.$/, '')}${describeWritten(session)}.`);
  }
}

/** A clause on what has been written, to follow a failure; '' where nothing has. */
export function describeWritten({ written }: Pick<Session, 'written'>): string {
  if (written.length === 0) return '';
  return `; ${written.join(', ')} ${written.length === 1 ? 'is' : 'are'} written`;
}

/** A run over the chosen bodies of the model of an operand, prepared. A body without a usable face stays as it is; an error where no other is left. */
export function prepareFile(session: Session, model: OpenModel, operand = 0): FileRun {
  const { args, core } = session;
  const onActivity = (body: string, triedFaces?: number): void => {
    session.activity = triedFaces === undefined ? body : `${body}, trying ${counted(triedFaces, 'face')}`;
  };
  const guides = args.command === 'optimize';
  const file = new FileRun(core, model, { chosen: chosenBodies(model, args.settings), guides, onActivity });
  warnOf(session, operand, preparedWarnings(file, args.settings));
  return file;
}

/** As `prepareFile`, of the bodies beside those of the original: see `pairedModel`. */
export function preparePartners(session: Session, original: OpenModel, other: OpenModel): FileRun {
  return prepareFile(session, pairedModel(original, other, session.args.settings), 1);
}

/**
 * Writes the report where it was asked for, and `text` to stdout where the report does not go there. `missed`: why targets
 * were not reached; written to stderr even with --quiet.
 */
export function finish(session: Session, report: Report, text: string, missed: string[] = []): void {
  clearProgress();
  const { args, core, warnings, checked } = session;
  const { timings, ...others } = report;
  const json = `${JSON.stringify({ ...others, peakHeapBytes: core.peakHeapBytes(), timings }, null, 2)}\n`;
  for (const path of args.reports) save(session, path, json);
  const summary = checked.takesStdout ? process.stderr : process.stdout;
  if (!args.quiet && !args.reports.includes(STANDARD)) summary.write(`${plain(text)}\n`);
  if (!args.quiet)
    for (const line of warningLines(warnings, args.verbose))
      process.stderr.write(`limber: ${inOneLine(line)}.\n`);
  for (const sentence of missed) process.stderr.write(`limber: ${inOneLine(sentence)}.\n`);
}
