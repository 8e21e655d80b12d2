/** limber modes IN */

import { describeSolve } from '../engine/body/health';
import type { PreparedBody } from '../engine/body/prepared_body';
import type { ModeSet } from '../engine/core/core';
import { startStopwatch } from '../engine/core/stopwatch';
import { droppedByExport, exportGlb } from '../engine/document/export';
import type { ExportedBody } from '../engine/document/export';
import { listLost } from '../engine/document/write/lost';
import { shapeTargets } from '../engine/document/shapes';
import { modesReport } from '../engine/report/modes_report';
import { startReport } from '../engine/report/report';
import type { Report } from '../engine/report/report';
import { resolveModes } from '../engine/settings/options';
import type { Settings } from '../engine/settings/options';
import type { FileRun } from '../engine/stages/file_run';
import { modesOfFile, sizeWarnings } from '../engine/stages/file_warnings';
import { STAGES } from '../engine/stages/stages';
import { exportedMesh } from '../engine/stages/written';
import type { Arguments } from './arguments';
import { EXIT, flagOf, inFlags } from './failure';
import { finish, openFile, prepareFile, save, startSession } from './session';
import type { Session } from './session';
import { shownName, shownOutput } from './standard';
import { counted } from '../engine/core/words';
import { table } from './words';

export async function runModes(args: Arguments): Promise<number> {
  const total = startStopwatch();
  const stopwatch = startStopwatch();
  const session = await startSession(args);
  const { settings } = args;
  const model = await openFile(session);
  const load = stopwatch();
  const file = prepareFile(session, model);
  const prepared = file.prepared(settings);
  session.warnings.push(...sizeWarnings(file, settings, flagOf));
  const weld = stopwatch();
  const { sets, warnings } = modesOfFile(file, settings);
  session.warnings.push(...warnings);
  const solved = stopwatch();
  if (args.shapes !== null) await writeShapes(session, file, args.shapes);
  const report = startReport(session.core, 'modes', optionsAsUsed(args), prepared);
  Object.assign(report, modesReport(sets));
  session.warnings.push(...describeSolve(report.modes!, report.solve!.coarseVertices ?? 0).map(inFlags));
  report.timings = { load, weld, modes: solved, export: stopwatch(), total: total() };
  finish(session, report, modesText(args, report));
  return EXIT.done;
}

function optionsAsUsed({ settings }: Arguments): object {
  const used: Partial<Settings> = { ...settings };
  delete used.method; // it only keeps `auto` from meaning the paper's model
  return used;
}

/** Writes the model with the shapes of the modes as morph targets. */
async function writeShapes(session: Session, file: FileRun, path: string): Promise<void> {
  const { args, warnings } = session;
  const { model, runs } = file;
  const shown = runs.map((run) => {
    if (!run) return null;
    const { settings } = args;
    return shapesOf(settings, run.get(STAGES.prepared, settings), run.get(STAGES.modes, settings));
  });
  save(session, path, await exportGlb(model, shown, { fields: false }));
  const dropped = droppedByExport(model, true);
  if (dropped.length > 0) warnings.push(`${shownOutput(path)} leaves out ${listLost(dropped)}`);
}

function shapesOf(settings: Settings, prepared: PreparedBody, modes: ModeSet): ExportedBody {
  const ordinals = resolveModes(settings).map((mode) => mode - 1);
  const targets = shapeTargets(prepared.mesh, modes, ordinals, prepared.diagonal);
  return { ...exportedMesh(prepared), targets };
}

function modesText(
  { operands, shapes }: Arguments,
  { modes, components, zeroModes, model, timings }: Report,
): string {
  const isNominal = model === 'laplacian';
  const isAlong = modes!.some(({ along }) => along !== undefined);
  const many = components!.length > 1;
  const header = [
    'mode',
    'name',
    ...(isAlong ? ['along'] : []),
    'frequency',
    'omega',
    'residual',
    ...(many ? ['part'] : []),
  ];
  const rows = modes!.map(({ name, along, frequency, omega, residual, component }, i) => [
    String(i + 1),
    name,
    ...(isAlong ? [`${along} axis`] : []),
    `${frequency.toPrecision(4)} Hz`,
    `${omega.toPrecision(4)} rad/s`,
    residual.toExponential(1),
    ...(many ? [String(component + 1)] : []),
  ]);
  const parts = many ? `, ${counted(components!.length, 'part')}` : '';
  const zero = `${zeroModes!.found} of ${zeroModes!.expected} zero modes found`;
  const heading = `${shownName(operands[0])}: ${model} model${parts}, ${zero}, ${timings.modes.toFixed(1)} s`;
  const nominal = isNominal
    ? ['Frequencies of the laplacian model are nominal: only their ratios are meaningful.']
    : [];
  return [
    heading,
    table([header, ...rows]),
    ...nominal,
    ...(shapes !== null ? [`-> ${shownOutput(shapes)}`] : []),
  ].join('\n');
}
