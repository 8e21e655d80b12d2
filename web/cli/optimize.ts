/** limber optimize IN OUT */

import { describeFailedModes, describeResiduals } from '../engine/body/health';
import { startStopwatch } from '../engine/core/stopwatch';
import { droppedByExport, passThrough } from '../engine/document/export';
import { describeEmpty } from '../engine/document/open';
import type { OpenModel } from '../engine/document/open';
import { describeLargeFit } from '../engine/report/fit_words';
import { settingsAsUsed } from '../engine/report/report';
import type { Report } from '../engine/report/report';
import { FileOutput } from '../engine/stages/file_output';
import { requestFile } from '../engine/stages/budget/file_targets';
import type { FileRun } from '../engine/stages/file_run';
import { STAGES } from '../engine/stages/stages';
import type { Arguments } from './arguments';
import { EXIT, UsageError } from './failure';
import { writeWhole } from './files';
import { writeLevels } from './levels';
import type { WrittenLevels } from './levels';
import { levelLine, summaryLine, tuningLines } from './optimize_words';
import { finish, openAnyFile, prepareFile, save, startSession } from './session';
import type { Session } from './session';
import { shownName, shownOutput } from './standard';
import { missedTargets, targetOf } from './targets';
import { clearProgress } from './terminal';
import { ofBody } from './warnings';
import { plain } from './words';

export async function runOptimize(args: Arguments): Promise<number> {
  const [input, path] = args.operands;
  const total = startStopwatch();
  const stopwatch = startStopwatch();
  const session = await startSession(args);
  const model = await openAnyFile(session, input);
  if (model.bodies.length === 0) return passOn(session, model);
  const load = stopwatch();
  const file = prepareFile(session, model);
  const weld = stopwatch();
  const output = optimizeFile(session, file);
  stopwatch();
  save(session, path, await output.glb());
  if (args.bind !== null) save(session, args.bind, output.binding());
  if (args.settingsFile !== null) save(session, args.settingsFile, output.settings());
  const dropped = droppedByExport(model);
  if (dropped.length > 0) session.warnings.push(`${shownOutput(path)} leaves out ${dropped.join(', ')}`);
  const exportTime = stopwatch();
  const levels = await writeLevels(args, output, (name, bytes) => {
    writeWhole(name, bytes);
    session.written.push(name);
  });
  const levelsTime = stopwatch();
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
  return finishOptimize(session, { output, report, levels });
}

/** Writes a model without triangles as it is. */
async function passOn(session: Session, model: OpenModel): Promise<number> {
  const [input, path] = session.args.operands;
  if (session.args.reports.length + session.args.settings.lods.length > 0 || session.args.bind !== null)
    throw new UsageError(
      `${model.name} ${describeEmpty(model)}, of which nothing can be reported: leave out --report, --lods and --bind.`,
    );
  const [main] = session.checked.files.get(input)!;
  save(session, path, await passThrough(model, main.bytes));
  session.warnings.length = 0;
  clearProgress();
  const line = `${shownName(input)} ${describeEmpty(model)} and is passed on as it is -> ${shownOutput(path)}\n`;
  if (!session.args.quiet) (session.checked.takesStdout ? process.stderr : process.stdout).write(plain(line));
  return EXIT.done;
}

interface Optimized {
  output: FileOutput;
  report: Report;
  levels: WrittenLevels;
}

/** Says what has come of it; returns the exit code. */
function finishOptimize(session: Session, { output, report, levels }: Optimized): number {
  const { args } = session;
  const missed = missedTargets(args, output, levels.written);
  const text = [
    summaryLine(args, output, report.timings.total),
    ...tuningLines(report),
    ...levels.written.map((level) => levelLine(level.report)),
  ].join('\n');
  session.warnings.push(...missed.unasked, ...(args.soft ? missed.asked : []));
  const told = [...(args.soft ? [] : missed.asked), ...(levels.failure ? [levels.failure.sentence] : [])];
  finish(session, report, text, told);
  if (levels.failure) return levels.failure.code;
  return missed.asked.length === 0 || args.soft ? EXIT.done : EXIT.missedTarget;
}

/** Takes every body through its stages; warns where a result is not as asked. */
function optimizeFile({ args, warnings }: Session, file: FileRun): FileOutput {
  const { settings, fields } = args;
  const output = new FileOutput(file, requestFile(file, { settings, fields, ...targetOf(args) }));
  output.compute((run, own) => {
    const { note } = run.get(STAGES.constraints, own);
    if (note !== '') warnings.push(note);
    warnings.push(...describeFailedModes(run.context.body.name, run.get(STAGES.guidingModes, own)));
    const large = describeLargeFit(run.get(STAGES.fitted, own));
    if (large !== '') warnings.push(ofBody(run.context.body.name, large));
  });
  return output;
}

function optionsAsUsed(args: Arguments): object {
  const { settings, fields } = args;
  const { faces, ratio } = targetOf(args);
  const target = { ...(faces !== null ? { faces } : {}), ...(ratio !== null ? { ratio } : {}) };
  return { ...settingsAsUsed(settings), ...target, fields };
}
