/** limber optimize IN OUT */

import { chosenBodies } from '../engine/body/selection';
import { describeResiduals } from '../engine/body/health';
import { startStopwatch } from '../engine/core/stopwatch';
import { levelLabels } from '../engine/document/write/output_form';
import { listLost } from '../engine/document/write/lost';
import { passThrough } from '../engine/document/write/pass_through';
import { describeEmpty } from '../engine/document/open';
import { loadValidator } from '../engine/document/validate';
import type { OpenModel } from '../engine/document/open';
import { settingsOfMethod } from '../engine/report/report';
import type { Report } from '../engine/report/report';
import { FileOutput } from '../engine/stages/file_output';
import { requestFile } from '../engine/stages/budget/file_targets';
import type { FileRun } from '../engine/stages/file_run';
import { resultWarnings, sizeWarnings } from '../engine/stages/file_warnings';
import { faceTarget, missedTargets } from '../engine/stages/missed_targets';
import type { MissedTargets } from '../engine/stages/missed_targets';
import type { Arguments } from './arguments';
import { EXIT, flagOf } from './failure';
import { writeLevels } from './levels';
import type { WrittenLevels } from './levels';
import { levelLine, summaryLine, tuningLines } from './optimize_words';
import { checkModelOutputs, checkPassedOn, fileName, saveFiles } from './output_files/model_outputs';
import { withoutYielded } from './output_files/preset_compression';
import { finish, openAnyFile, prepareFile, save, writeOutput, startSession } from './session';
import type { Session } from './session';
import { shownName, shownOutput } from './standard';
import { requestedTargets } from './requested_targets';
import { warnOfErrors } from './validation';
import { clearProgress } from './terminal';
import { plain } from './words';

export async function runOptimize(args: Arguments): Promise<number> {
  const watches = { total: startStopwatch(), lap: startStopwatch() };
  const starting = startSession(args);
  if (args.validates) loadValidator(); // while the threads of the core start
  const session = await starting;
  const done = await optimizeModel(session, watches);
  if ('report' in done) return finishOptimize(session, done);
  clearProgress();
  const line = `${shownName(args.operands[0])} ${done.passedOn} -> ${shownOutput(args.operands[1])}\n`;
  if (!args.quiet) (session.checked.takesStdout ? process.stderr : process.stdout).write(plain(line));
  return EXIT.done;
}

/** Stopwatches that were started before the session: they count what it took to read the files. */
interface Watches {
  total: () => number;
  lap: () => number;
}

/** Optimizes the model of a session and writes all but the report. A model without triangles is passed on as it is. */
export async function optimizeModel(
  session: Session,
  { total, lap }: Watches,
): Promise<Optimized | PassedOn> {
  const [, path] = session.args.operands;
  const model = await openAnyFile(session);
  const { args, notes } = withoutYielded(session.args, model);
  session.args = args;
  session.warnings.push(...notes);
  if (model.bodies.length === 0) return passOn(session, model);
  const load = lap();
  const written = checkModelOutputs(session, model, chosenBodies(model, args.settings));
  const file = prepareFile(session, model);
  if (args.settings.solver !== 'none') session.warnings.push(...sizeWarnings(file, args.settings, flagOf));
  const weld = lap();
  const output = optimizeFile(session, file);
  lap();
  const files = await output.files(fileName(path));
  saveFiles(session, path, files);
  if (args.bind !== null) save(session, args.bind, output.binding());
  if (args.settingsFile !== null) save(session, args.settingsFile, output.settings());
  if (written.lost.length > 0)
    session.warnings.push(`${shownOutput(path)} leaves out ${listLost(written.lost)}`);
  const exportTime = lap();
  const levels = await writeLevels(args, output, (name, all) => {
    saveFiles(session, name, all, writeOutput);
  });
  if (args.validates) await warnOfErrors(session, files);
  const levelsTime = lap();
  const report = output.report(
    optionsAsUsed(args),
    levels.written.map((level) => level.report),
  );
  session.warnings.push(...describeResiduals(report.modes ?? []));
  report.timings = {
    ...{ load, weld, ...report.timings, export: exportTime },
    ...(levels.written.length > 0 ? { levels: levelsTime } : {}),
    total: total(),
  };
  return { file, output, report, levels };
}

/** The outcome for a model without triangles, in words that follow its name. */
export interface PassedOn {
  passedOn: string;
}

/** Writes a model without triangles as it is. */
async function passOn(session: Session, model: OpenModel): Promise<PassedOn> {
  const [input, path] = session.args.operands;
  if (!session.isHosted) checkPassedOn(session.args, model);
  const [main] = session.checked.files.get(input)!;
  const { form } = checkModelOutputs(session, model, []);
  saveFiles(session, path, await passThrough(model, main.bytes, { name: fileName(path), form }));
  session.warnings.length = 0;
  return { passedOn: `${describeEmpty(model)} and is written unchanged` };
}

export interface Optimized {
  file: FileRun;
  output: FileOutput;
  report: Report;
  levels: WrittenLevels;
}

/** Writes the report and says what has come of it; returns the exit code. */
export function finishOptimize(session: Session, { output, report, levels }: Optimized): number {
  const { args } = session;
  const missed = missedOf(args, output, levels);
  const text = [
    summaryLine(args, output, report.timings.total),
    ...tuningLines(report),
    ...levels.written.map(({ report: own }, i) => levelLine(labelsOf(args)[i], own)),
  ].join('\n');
  session.warnings.push(...missed.byDefault, ...(args.soft ? missed.requested : []));
  const told = [...(args.soft ? [] : missed.requested), ...(levels.failure ? [levels.failure.sentence] : [])];
  finish(session, report, text, told);
  if (levels.failure) return levels.failure.code;
  return missed.requested.length === 0 || args.soft ? EXIT.done : EXIT.missedTarget;
}

const labelsOf = ({ operands, settings }: Arguments): string[] => levelLabels(operands[1], settings);

/** The missed targets of a run, settings being flags. */
export const missedOf = (args: Arguments, output: FileOutput, { written }: WrittenLevels): MissedTargets =>
  missedTargets(requestedTargets(args), output, {
    levels: written.map(({ bodies }, i) => ({ file: labelsOf(args)[i], bodies })),
    nameOf: flagOf,
  });

/** Runs every body through its stages; warns where a result differs from the request. */
function optimizeFile({ args, warnings }: Session, file: FileRun): FileOutput {
  const { settings, fields } = args;
  const binding = args.bind !== null;
  const request = requestFile(file, {
    settings,
    fields,
    binding,
    isOnly: true,
    ...faceTarget(requestedTargets(args)),
  });
  const output = new FileOutput(file, request);
  output.compute((run, own) => {
    warnings.push(...resultWarnings(run, own));
  });
  return output;
}

function optionsAsUsed(args: Arguments): object {
  const { settings, fields } = args;
  const { faces, ratio } = faceTarget(requestedTargets(args));
  const target = { ...(faces !== null ? { faces } : {}), ...(ratio !== null ? { ratio } : {}) };
  return { ...settingsOfMethod(settings), ...target, fields };
}
