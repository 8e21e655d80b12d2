/** limber optimize IN OUT */

import { describeFailedModes, describeSolve } from '../engine/body/health';
import { startStopwatch } from '../engine/core/stopwatch';
import { droppedByExport } from '../engine/document/export';
import { describeLargeFit } from '../engine/report/fit_words';
import { settingsAsUsed } from '../engine/report/report';
import type { StoppedBody } from '../engine/report/stop_report';
import type { FaceTarget } from '../engine/stages/face_shares';
import { FileOutput } from '../engine/stages/file_output';
import { requestFile } from '../engine/stages/file_targets';
import type { FileRun } from '../engine/stages/file_run';
import { STAGES } from '../engine/stages/stages';
import type { Arguments } from './arguments';
import { EXIT, inFlags } from './failure';
import { checkFolder, checkOutput, writeWhole } from './files';
import { checkLevels, writeLevels } from './levels';
import { describeGuard, describeMiss, levelLine, summaryLine, tuningLines } from './optimize_words';
import { finish, openFile, prepareFile, startSession } from './session';
import type { Session } from './session';

const DEFAULT_RATIO = 0.5;

export async function runOptimize(args: Arguments): Promise<number> {
  const [input, path] = args.operands;
  checkOutput(path, input);
  checkLevels(args);
  for (const file of [args.bind, args.settingsFile]) if (file !== null) checkFolder(file);
  const total = startStopwatch();
  const stopwatch = startStopwatch();
  const session = await startSession(args);
  const model = await openFile(session, input);
  const load = stopwatch();
  const file = prepareFile(session, model);
  const weld = stopwatch();
  const output = optimizeFile(session, file);
  stopwatch();
  writeWhole(path, await output.glb());
  if (args.bind !== null) writeWhole(args.bind, output.binding());
  if (args.settingsFile !== null) writeWhole(args.settingsFile, output.settings());
  const dropped = droppedByExport(model);
  if (dropped.length > 0) session.warnings.push(`${path} leaves out ${dropped.join(', ')}`);
  const exportTime = stopwatch();
  const levels = await writeLevels(args, output);
  const levelsTime = stopwatch();
  const report = output.report(
    optionsAsUsed(args),
    levels.map((level) => level.report),
  );
  session.warnings.push(...describeSolve(report.modes ?? [], report.solve?.coarseVertices ?? 0).map(inFlags));
  report.timings = {
    ...{ load, weld, ...report.timings, export: exportTime },
    ...(levels.length > 0 ? { levels: levelsTime } : {}),
    total: total(),
  };
  const describe = (bodies: StoppedBody[], where = '') =>
    describeMiss(bodies, output.prepared(), { where, settings: args.settings });
  const guards = [
    describeGuard(output.stopped()),
    ...levels.map(({ bodies, report: { file: name } }) => describeGuard(bodies, `${name}: `)),
  ].filter((sentence) => sentence !== '');
  const isShort = asksForCount(args) && !args.givesDeviation;
  if (!isShort && !args.givesDeviation) session.warnings.push(...guards);
  const missed = [
    ...(wantsCount(args) ? [describe(output.stopped())] : []),
    ...levels.map(({ bodies, report: { file: name } }) => describe(bodies, `${name}: `)),
    ...(isShort ? guards : []),
  ].filter((sentence) => sentence !== '');
  const text = [
    summaryLine(args, output, report.timings.total),
    ...tuningLines(report),
    ...levels.map((level) => levelLine(level.report)),
  ].join('\n');
  finish(session, report, text, missed);
  return missed.length === 0 ? EXIT.done : EXIT.missedTarget;
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
    if (large !== '') warnings.push(`${run.context.body.name}: ${large}`);
  });
  return output;
}

function optionsAsUsed(args: Arguments): object {
  const { settings, mesh, fields } = args;
  const { faces, ratio } = targetOf(args);
  const target = { ...(faces !== null ? { faces } : {}), ...(ratio !== null ? { ratio } : {}) };
  return { ...settingsAsUsed(settings), ...target, ...(mesh !== null ? { mesh } : {}), fields };
}

/** What is asked for; half the faces where nothing else is a target. */
function targetOf({ faces, ratio, givesDeviation, settings }: Arguments): FaceTarget {
  const isAlone =
    faces === null && !givesDeviation && settings.minAngle === 0 && settings.maxFrequencyError === 0;
  return { faces, ratio: ratio ?? (isAlone ? DEFAULT_RATIO : null) };
}

/** Whether the user has asked for a number of faces, and not the default. */
const asksForCount = ({ faces, ratio }: Arguments): boolean => faces !== null || ratio !== null;

/** Whether a number of faces is a target at all: the other targets need none. */
function wantsCount(args: Arguments): boolean {
  const { faces, ratio } = targetOf(args);
  return faces !== null || ratio !== null;
}
