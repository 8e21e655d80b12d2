/** limber optimize IN OUT */

import { basename } from 'node:path';
import { bindingOfBody, writeBinding } from '../engine/report/binding_file';
import type { Core } from '../engine/core/core';
import { droppedByExport, exportGlb } from '../engine/document/export';
import type { OpenModel } from '../engine/document/open';
import { describeSolve } from '../engine/body/health';
import { findHeld } from '../engine/body/constraints';
import { methodOf, resolveModel, resolveModes } from '../engine/settings/options';
import { optimizeBody } from '../engine/stages/optimize';
import type { OptimizedBody, Timings } from '../engine/stages/optimize';
import { describeLargeFit, isHeldBySeams, startStopwatch } from '../engine/stages/pipeline';
import type { PreparedBody } from '../engine/stages/pipeline';
import {
  describeRefused,
  calibrationReport,
  fitReport,
  resultReport,
  startReport,
  stopReport,
  worstSurface,
} from '../engine/report/report';
import type { Report, StoppedBody, StopReport } from '../engine/report/report';
import { facesByRatio, shareInProportion } from '../engine/stages/face_shares';
import type { Arguments } from './arguments';
import { EXIT } from './failure';
import { checkFolder, checkOutput, writeWhole } from './files';
import { checkLevels, writeLevels, writtenBody } from './levels';
import type { Finished, WrittenLevel } from './levels';
import { finish, openFile, prepareBodies, startSession, usable } from './session';
import type { Session } from './session';
import { count, percent, plural } from './words';

const DEFAULT_RATIO = 0.5;

export async function runOptimize(args: Arguments): Promise<number> {
  const [input, output] = args.operands;
  checkOutput(output, input);
  checkLevels(args);
  if (args.bind !== null) checkFolder(args.bind);
  const total = startStopwatch();
  const stopwatch = startStopwatch();
  const session = await startSession(args);
  const model = await openFile(session, input);
  const load = stopwatch();
  const prepared = prepareBodies(session, model);
  const weld = stopwatch();
  const finished = optimizeAll(session, model, prepared);
  const done = finished.flatMap((one) => (one ? [one.body] : []));
  stopwatch();
  const written = finished.map((one) => one && writtenBody(session, one.body, one.body.result));
  writeWhole(output, await exportGlb(model, written, { fields: args.fields }));
  if (args.bind !== null) writeWhole(args.bind, bindingText(session.core, done));
  const dropped = droppedByExport(model);
  if (dropped.length > 0) session.warnings.push(`${output} leaves out ${dropped.join(', ')}`);
  const exportTime = stopwatch();
  const levels = await writeLevels(session, model, finished);
  const report = startReport(session.core, 'optimize', optionsAsUsed(args), usable(prepared));
  fillReport(report, done, levels);
  const factors = written.flatMap((one) => one?.calibration ?? []);
  if (args.settings.calibrate) report.calibration = calibrationReport(usable(prepared), factors);
  session.warnings.push(...describeSolve(report.modes ?? [], report.solve?.coarseVertices ?? 0));
  report.timings = {
    ...{ load, weld, ...sumTimings(done), export: exportTime },
    ...(levels.length > 0 ? { levels: stopwatch() } : {}),
    total: total(),
  };
  const describe = (bodies: StoppedBody[], where = '') =>
    describeMiss(bodies, where) + describeSeams(bodies, done, args);
  const missed = [
    ...(wantsCount(args) ? [describe(done.map(stopOf))] : []),
    ...levels.map(({ bodies, report: { file } }) => describe(bodies, `${file}: `)),
  ].filter((sentence) => sentence !== '');
  const text = [summaryLine(args, done, report.timings.total), ...levels.map(levelLine)].join('\n');
  finish(session, report, text, missed);
  return missed.length === 0 ? EXIT.done : EXIT.missedTarget;
}

/** null for a body that stays as it is. */
function optimizeAll(
  session: Session,
  model: OpenModel,
  prepared: (PreparedBody | null)[],
): (Finished | null)[] {
  const { args, core, warnings } = session;
  const targets = shareTargets(args, prepared);
  return prepared.map((one, i) => {
    if (!one) return null;
    const { name } = one.body;
    session.activity = name;
    const { held, note } = findHeld(model.document, one, args.settings);
    if (note !== '') warnings.push(note);
    const onTry = (faces: number) => (session.activity = `${name}, trying ${count(faces)} faces`);
    const target = { targetFaces: targets[i], onTry, ...held };
    const body = optimizeBody(core, one, args.settings, target);
    const large = describeLargeFit(body.fitted);
    if (large !== '') warnings.push(`${name}: ${large}`);
    return { body, held };
  });
}

function bindingText(core: Core, done: OptimizedBody[]): string {
  return writeBinding(
    done.map(({ prepared, result }) =>
      bindingOfBody(prepared, result.mesh.triangles.length / 3, core.bindToResult(prepared.mesh, result)),
    ),
  );
}

function optionsAsUsed(args: Arguments): object {
  const { settings, faces, ratio, mesh, fields } = args;
  const guided = methodOf(settings).needsGuidance
    ? { model: resolveModel(settings), modes: resolveModes(settings) }
    : {};
  const target = {
    ...(faces !== null ? { faces } : {}),
    ...(wantsRatio(args) ? { ratio: ratio ?? DEFAULT_RATIO } : {}),
  };
  return { ...settings, ...guided, ...target, ...(mesh !== null ? { mesh } : {}), fields };
}

/** Whether a number of faces is a target at all: other targets stand for themselves. */
const wantsCount = (args: Arguments): boolean => args.faces !== null || wantsRatio(args);
const wantsRatio = ({ faces, ratio, settings }: Arguments): boolean =>
  ratio !== null ||
  (faces === null &&
    [settings.maxDeviation, settings.minAngle, settings.maxFrequencyError].every((n) => n === 0));

/** How many faces each body may keep: the larger of both targets, for the first one reached stops. */
function shareTargets(args: Arguments, bodies: (PreparedBody | null)[]): number[] {
  const { faces, ratio } = args;
  const counts = bodies.map((body) => (body ? body.mesh.triangles.length / 3 : 0));
  const share = faces === null ? null : shareInProportion(faces, counts);
  return counts.map((faceCount, i) => {
    const byRatio = wantsRatio(args) ? facesByRatio(ratio ?? DEFAULT_RATIO, faceCount) : 0;
    return Math.max(1, byRatio, share ? share[i] : 0);
  });
}

function fillReport(report: Report, done: OptimizedBody[], levels: WrittenLevel[]): void {
  Object.assign(report, resultReport(done.map((body) => ({ ...body, stopped: stopOf(body) }))));
  if (levels.length > 0) report.levels = levels.map((level) => level.report);
}

function stopOf({ result, targetFaces, history, frequency }: OptimizedBody): StoppedBody {
  return { faces: result.mesh.triangles.length / 3, targetFaces, history, frequency };
}

function sumTimings(done: OptimizedBody[]): Record<string, number> {
  const sumOf = (key: keyof Timings) => done.reduce((sum, { timings }) => sum + timings[key], 0);
  return {
    ...(done.some(({ modes }) => modes) ? { modes: sumOf('modes') } : {}),
    fields: sumOf('fields'),
    simplify: sumOf('simplify'),
    ...(done.some(({ frequency }) => frequency) ? { search: sumOf('search') } : {}),
    reduce: sumOf('reduce'),
    ...(sumOf('fit') > 0.001 ? { fit: sumOf('fit') } : {}),
    measure: sumOf('measure'),
  };
}

const sum = (values: number[]): number => values.reduce((a, b) => a + b, 0);

const isExhausted = (body: StoppedBody): boolean => stopReport([body]).reason === 'exhausted';

/** Why bodies are left with more faces than asked because nothing more can go; '' where none is. */
function describeMiss(bodies: StoppedBody[], where: string): string {
  const missed = bodies.filter(isExhausted);
  if (missed.length === 0) return '';
  const [after, target] = [
    sum(missed.map(({ faces }) => faces)),
    sum(missed.map((body) => body.targetFaces)),
  ];
  const which = bodies.length > 1 ? ` in ${plural(missed.length, 'body', 'bodies')} of ${bodies.length}` : '';
  const reasons = describeRefused(stopReport(missed).refused);
  return `${where}Stopped at ${count(after)} faces${which}, not ${count(target)}: ${reasons}`;
}

/** How to go on where seams keep a body from its target; '' where they do not. `bodies[i]` has become of `done[i]`. */
function describeSeams(bodies: StoppedBody[], done: OptimizedBody[], { settings }: Arguments): string {
  const isHeld = bodies.some(
    (body, i) => isExhausted(body) && isHeldBySeams(done[i].prepared, body.history.refused, settings),
  );
  return isHeld ? '; --seams cross lets them give way' : '';
}

function summaryLine({ operands }: Arguments, done: OptimizedBody[], seconds: number): string {
  const before = sum(done.map(({ prepared }) => prepared.mesh.triangles.length / 3));
  const after = sum(done.map(({ result }) => result.mesh.triangles.length / 3));
  const distance = worstSurface(done.map(({ measured }) => measured.distance));
  const broken = done.flatMap(({ measured }) =>
    (['components', 'boundaryLoops', 'genus'] as const).filter((key) => !measured.certificate[key]),
  );
  const topology =
    broken.length === 0 ? 'topology kept' : `TOPOLOGY CHANGED (${[...new Set(broken)].join(', ')})`;
  const smallest = Math.min(...done.map(({ measured }) => measured.quality.minAngle));
  return [
    `${basename(operands[0])}: ${count(before)} -> ${count(after)} faces (${percent(after / before - 1)})`,
    topology,
    `deviation ${distance.hausdorff.toFixed(2)} % (mean ${distance.mean.toFixed(2)} %)`,
    `smallest angle ${smallest.toFixed(1)} deg`,
    ...fitWords(done),
    ...frequencyWords(stopReport(done.map(stopOf))),
    `${seconds.toFixed(1)} s -> ${operands[1]}`,
  ].join(', ');
}

/** Of the part that is off most. */
function fitWords(done: OptimizedBody[]): string[] {
  const { fit } = fitReport(done.map(({ fitted }) => fitted));
  if (!fit) return [];
  const why = fit.unfitted ? [`not fitted: ${fit.unfitted.join('; ')}`] : [];
  const off = `frequencies off ${fit.after.toFixed(2)} % (${fit.before.toFixed(2)} % before the fit)`;
  return fit.before > 0 ? [off, ...why] : why;
}

/** Of the target: how far the frequencies are off, and how far they would be with fewer faces. */
function frequencyWords({ frequency }: StopReport): string[] {
  if (!frequency) return [];
  const { error, limit, beyond } = frequency;
  const less = beyond ? ` (${count(beyond.faces)} faces: ${beyond.error.toFixed(2)} %)` : '';
  return [`frequencies within ${error.toFixed(2)} % of ${limit} %${less}`];
}

function levelLine({ report: { file, output, surface } }: WrittenLevel): string {
  const { hausdorff, mean } = surface;
  const deviation = `deviation ${hausdorff.toFixed(2)} % (mean ${mean.toFixed(2)} %)`;
  return `${file}: ${count(output.faces)} faces, ${deviation}`;
}
