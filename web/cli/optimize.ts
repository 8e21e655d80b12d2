/** limber optimize IN OUT */

import { basename } from 'node:path';
import { bindingOfBody, writeBinding } from '../engine/binding_file';
import type { Core } from '../engine/core';
import { droppedByExport, exportGlb } from '../engine/document/export';
import { describeSolve } from '../engine/health';
import { findPins } from '../engine/pins';
import { resolveModel, resolveModes } from '../engine/options';
import { exportedBody, optimizeBody, startStopwatch } from '../engine/pipeline';
import type { OptimizedBody, PreparedBody, Timings } from '../engine/pipeline';
import {
  describeRefused,
  calibrationReport,
  meshReport,
  modesReport,
  startReport,
  stopReport,
  worstSurface,
} from '../engine/report';
import type { Report } from '../engine/report';
import { shareInProportion } from '../engine/share';
import { calibrationOf } from '../engine/simulation';
import type { Arguments } from './arguments';
import { EXIT } from './failure';
import { checkFolder, checkOutput, writeWhole } from './files';
import { finish, openFile, prepareBodies, startSession, usable } from './session';
import type { Session } from './session';
import { count, percent, plural } from './words';

const DEFAULT_RATIO = 0.5;

export async function runOptimize(args: Arguments): Promise<number> {
  const [input, output] = args.operands;
  checkOutput(output, input);
  if (args.bind !== null) checkFolder(args.bind);
  const total = startStopwatch();
  const stopwatch = startStopwatch();
  const session = await startSession(args);
  const model = await openFile(session, input);
  const load = stopwatch();
  const prepared = prepareBodies(session, model);
  const weld = stopwatch();
  const targets = shareTargets(args, prepared);
  const optimized = prepared.map((body, i) => {
    if (!body) return null;
    session.activity = body.body.name;
    const pinned = findPins(args.settings.pins, model.document, body);
    return optimizeBody(session.core, body, args.settings, { targetFaces: targets[i], pinned });
  });
  const done = optimized.filter((body) => body !== null);
  const factors = optimized.map((body) => (body ? calibrationFor(session, body) : undefined));
  stopwatch();
  const exported = optimized.map((body, i) =>
    body
      ? {
          ...exportedBody(session.core, body.prepared, body.result, args.fields ? body : null),
          calibration: factors[i],
        }
      : null,
  );
  const bytes = await exportGlb(model, exported, { fields: args.fields });
  writeWhole(output, bytes);
  if (args.bind !== null) writeWhole(args.bind, bindingText(session.core, done));
  const dropped = droppedByExport(model);
  if (dropped.length > 0) session.warnings.push(`${output} leaves out ${dropped.join(', ')}`);
  const report = startReport(session.core, 'optimize', optionsAsUsed(args), usable(prepared));
  fillReport(report, done);
  if (args.settings.calibrate)
    report.calibration = calibrationReport(
      done.map(({ prepared }) => prepared),
      factors.filter((factor) => factor !== undefined),
    );
  session.warnings.push(...describeSolve(report.modes ?? [], report.solve?.coarseVertices ?? 0));
  report.timings = { load, weld, ...sumTimings(done), export: stopwatch(), total: total() };
  const missed = wantsCount(args) && report.stop!.reason === 'exhausted' ? describeMiss(done) : '';
  finish(session, report, summaryLine(args, done, report.timings.total), missed);
  return missed === '' ? EXIT.done : EXIT.missedTarget;
}

function calibrationFor(session: Session, { prepared, result }: OptimizedBody): number | undefined {
  if (!session.args.settings.calibrate) return undefined;
  session.activity = prepared.body.name;
  return calibrationOf(session.core, prepared, result.mesh, session.args.settings);
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
  const guided =
    settings.method === 'qem' ? {} : { model: resolveModel(settings), modes: resolveModes(settings) };
  const target = {
    ...(faces !== null ? { faces } : {}),
    ...(wantsRatio(args) ? { ratio: ratio ?? DEFAULT_RATIO } : {}),
  };
  return { ...settings, ...guided, ...target, ...(mesh !== null ? { mesh } : {}), fields };
}

/** Whether a number of faces is a target at all: other targets stand for themselves. */
const wantsCount = (args: Arguments): boolean => args.faces !== null || wantsRatio(args);
const wantsRatio = ({ faces, ratio, settings }: Arguments): boolean =>
  ratio !== null || (faces === null && settings.maxDeviation === 0 && settings.minAngle === 0);

/** How many faces each body may keep: the larger of both targets, for the first one reached stops. */
function shareTargets(args: Arguments, bodies: (PreparedBody | null)[]): number[] {
  const { faces, ratio } = args;
  const counts = bodies.map((body) => (body ? body.mesh.triangles.length / 3 : 0));
  const share = faces === null ? null : shareInProportion(faces, counts);
  return counts.map((faceCount, i) => {
    // The sum keeps 0.3 * 10 from becoming 2.
    const byRatio = wantsRatio(args) ? Math.floor((ratio ?? DEFAULT_RATIO) * faceCount + 1e-9) : 0;
    return Math.max(1, byRatio, share ? share[i] : 0);
  });
}

function fillReport(report: Report, done: OptimizedBody[]): void {
  report.output = meshReport(done.map(({ measured }) => measured));
  const sets = done.flatMap(({ modes }) => modes ?? []);
  if (sets.length > 0) Object.assign(report, modesReport(sets));
  report.surface = worstSurface(done.map(({ measured }) => measured.distance));
  report.stop = stopReport(done.map(stopOf));
}

function stopOf({ result, targetFaces, history }: OptimizedBody) {
  return { faces: result.mesh.triangles.length / 3, targetFaces, history };
}

function sumTimings(done: OptimizedBody[]): Record<string, number> {
  const sumOf = (key: keyof Timings) => done.reduce((sum, { timings }) => sum + timings[key], 0);
  return {
    ...(done.some(({ modes }) => modes) ? { modes: sumOf('modes') } : {}),
    fields: sumOf('fields'),
    simplify: sumOf('simplify'),
    reduce: sumOf('reduce'),
    ...(sumOf('fit') > 0.001 ? { fit: sumOf('fit') } : {}),
    measure: sumOf('measure'),
  };
}

function totals(done: OptimizedBody[]) {
  const sum = (values: number[]) => values.reduce((a, b) => a + b, 0);
  return {
    before: sum(done.map(({ prepared }) => prepared.mesh.triangles.length / 3)),
    after: sum(done.map(({ result }) => result.mesh.triangles.length / 3)),
    target: sum(done.map(({ targetFaces }) => targetFaces)),
  };
}

function describeMiss(done: OptimizedBody[]): string {
  const missed = done.filter((body) => stopReport([stopOf(body)]).reason === 'exhausted');
  const { after, target } = totals(missed);
  const where = done.length > 1 ? ` in ${plural(missed.length, 'body', 'bodies')} of ${done.length}` : '';
  const { refused } = stopReport(missed.map(stopOf));
  return `Stopped at ${count(after)} faces${where}, not ${count(target)}: ${describeRefused(refused)}`;
}

function summaryLine({ operands }: Arguments, done: OptimizedBody[], seconds: number): string {
  const { before, after } = totals(done);
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
    `${seconds.toFixed(1)} s -> ${operands[1]}`,
  ].join(', ');
}
