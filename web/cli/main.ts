/** The command line: reads the words, runs a command, and ends with its exit code. */

import { VERSION } from '../engine/core/version';
import { parseArguments } from './arguments';
import type { Arguments } from './arguments';
import { runCompare } from './compare';
import { runDry } from './dry_run';
import { describeFailure, EXIT } from './failure';
import type { Command } from './flags';
import { helpText } from './help';
import { runInspect } from './inspect';
import { runModes } from './modes';
import { runOptimize } from './optimize';
import { runSimulate } from './simulate';
import { clearProgress } from './terminal';
import { runTune } from './tune';

const RUN: Record<Command, (args: Arguments) => Promise<number>> = {
  optimize: runOptimize,
  tune: runTune,
  modes: runModes,
  compare: runCompare,
  simulate: runSimulate,
  inspect: runInspect,
};

async function run(words: string[]): Promise<number> {
  const parsed = parseArguments(words);
  if (!('show' in parsed)) return parsed.dryRun ? runDry(parsed) : RUN[parsed.command](parsed);
  process.stdout.write(`${parsed.show === 'version' ? VERSION : helpText(parsed.command)}\n`);
  // Help without being asked for it means that something was missing.
  return words.length > 0 ? EXIT.done : EXIT.badInput;
}

async function main(): Promise<number> {
  try {
    return await run(process.argv.slice(2));
  } catch (error) {
    return fail(error);
  }
}

function fail(error: unknown): number {
  clearProgress();
  const { code, line } = describeFailure(error);
  process.stderr.write(`limber: ${line}\n`);
  return code;
}

/** The pool of threads keeps Node alive, so the program ends itself once all its output is written. */
function exit(code: number): void {
  process.stdout.write('', () => process.stderr.write('', () => process.exit(code)));
}

// Errors of the threads in the pool arrive here.
process.on('uncaughtException', (error) => exit(fail(error)));
// The reader of the output may close it early.
process.stdout.on('error', () => process.exit(EXIT.done));
exit(await main());
