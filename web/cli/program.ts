/** Reads the words, loads and runs a command, and ends the program with its exit code. */

import { VERSION } from '../engine/core/version';
import { parseArguments } from './arguments';
import type { Arguments } from './arguments';
import { startCore } from './core_start';
import { describeFailure, EXIT } from './failure';
import { fileError } from './file_error';
import type { Command } from './flags';
import { clearProgress } from './terminal';

/** Each command loads what it needs when it is run. */
const RUN: Record<Command, (args: Arguments) => Promise<number>> = {
  optimize: async (args) => (await import('./optimize')).runOptimize(args),
  batch: async (args) => (await import('./batch/batch')).runBatch(args),
  tune: async (args) => (await import('./tune')).runTune(args),
  modes: async (args) => (await import('./modes')).runModes(args),
  compare: async (args) => (await import('./compare')).runCompare(args),
  simulate: async (args) => (await import('./simulate')).runSimulate(args),
  inspect: async (args) => (await import('./inspect')).runInspect(args),
};

const dryRun = async (args: Arguments): Promise<number> =>
  args.command === 'batch' ? RUN.batch(args) : (await import('./dry_run')).runDry(args);

function run(args: Arguments): Promise<number> {
  // The processes of a batch have cores of their own.
  if (args.command !== 'batch') startCore(args);
  return RUN[args.command](args);
}

/** Returns when the command has ended; the program ends once its output is written. */
export async function startProgram(words: string[]): Promise<void> {
  // Errors of the threads in the pool arrive here.
  process.on('uncaughtException', (error) => exit(fail(error)));
  exit(await runWords(words).catch(fail));
}

/** Ends the program where stdout fails: without a word where its reader has closed it early, as `head` does. */
export function endWithoutOutput(error: NodeJS.ErrnoException): void {
  if (error.code === 'EPIPE') process.exit(EXIT.brokenPipe);
  // What is still to be written fails as well.
  if (process.exitCode !== undefined) return;
  process.exitCode = fail(fileError('stdout cannot be written', error));
  exit(process.exitCode);
}

async function runWords(words: string[]): Promise<number> {
  if (words[0] === 'completion') return (await import('./shell/completion')).runCompletion(words.slice(1));
  if (words[0] === 'help' && words[1] === 'completion') return runWords(['completion', '--help']);
  const parsed = parseArguments(words);
  if (!('show' in parsed)) return parsed.dryRun ? dryRun(parsed) : run(parsed);
  const text = parsed.show === 'version' ? VERSION : (await import('./help')).helpText(parsed.command);
  process.stdout.write(`${text}\n`);
  // Help without being asked for it means that something was missing.
  return words.length > 0 ? EXIT.done : EXIT.badInput;
}

function fail(error: unknown): number {
  clearProgress();
  const { code, line } = describeFailure(error);
  process.stderr.write(`limber: ${line}\n`);
  return code;
}

/** The pool of threads keeps Node alive, so the program ends itself once all its output is written, or has failed to be. */
function exit(code: number): void {
  const end = () => setImmediate(() => process.exit(process.exitCode ?? code));
  process.stdout.write('', () => process.stderr.write('', end));
}
