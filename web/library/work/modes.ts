/** Finds the modes of a model, and inspects it. */

import { describeSolve } from '../../engine/body/health';
import { droppedByExport, exportGlb } from '../../engine/document/export';
import { shapeTargets } from '../../engine/document/shapes';
import { modesReport } from '../../engine/report/modes_report';
import { settingsOfCommand, startReport } from '../../engine/report/report';
import type { Report } from '../../engine/report/report';
import { resolveModes } from '../../engine/settings/options';
import type { Settings } from '../../engine/settings/options';
import type { FileRun } from '../../engine/stages/file_run';
import { modesOfFile, sizeWarnings } from '../../engine/stages/file_warnings';
import { inspectBody } from '../../engine/stages/prepared';
import { STAGES } from '../../engine/stages/stages';
import { exportedMesh } from '../../engine/stages/written';
import type { ModesOptions, ModesReport, ModesResult, Reported } from '../options';
import type { ModelFiles } from '../protocol';
import { finished } from './optimize';
import { resultBytes } from './result_bytes';
import { inNames, nameOf } from './session';
import type { WorkSession } from './session';

export async function findModes(
  session: WorkSession,
  [files]: ModelFiles[],
  { writesShapes = false }: ModesOptions,
): Promise<ModesResult> {
  const { core, settings, notes } = session;
  const model = await session.open(files);
  const load = session.lap();
  const file = session.prepare(model);
  const prepared = file.prepared(settings);
  session.warn(sizeWarnings(file, settings, nameOf));
  const weld = session.lap();
  const { sets, warnings } = modesOfFile(file, settings);
  session.warn(warnings);
  const modes = session.lap();
  const shapes = writesShapes ? resultBytes(await shapesGlb(session, file)) : null;
  const report: ModesReport = {
    ...startReport(core, 'modes', optionsAsUsed(settings), prepared),
    ...modesReport(sets),
    timings: { load, weld, modes, export: session.lap(), total: session.total() },
  };
  notes.push(...describeSolve(report.modes, report.solve.coarseVertices ?? 0).map(inNames));
  return { shapes, report: finished(session, report), notes };
}

function optionsAsUsed(settings: Settings): object {
  const used: Partial<Settings> = { ...settings };
  delete used.method; // it only keeps `auto` from meaning the paper's model
  return used;
}

/** The model with the shapes of the modes as morph targets. */
function shapesGlb({ settings, notes }: WorkSession, { model, runs }: FileRun): Promise<Uint8Array> {
  const dropped = droppedByExport(model, true);
  if (dropped.length > 0) notes.push(`the shapes leave out ${dropped.join(', ')}`);
  const ordinals = resolveModes(settings).map((mode) => mode - 1);
  const shown = runs.map((run) => {
    if (!run) return null;
    const prepared = run.get(STAGES.prepared, settings);
    const modes = run.get(STAGES.modes, settings);
    return {
      ...exportedMesh(prepared),
      targets: shapeTargets(prepared.mesh, modes, ordinals, prepared.diagonal),
    };
  });
  return exportGlb(model, shown, { fields: false });
}

export async function inspectModel(session: WorkSession, [files]: ModelFiles[]): Promise<Reported> {
  const { core, settings, notes } = session;
  const model = await session.open(files);
  const load = session.lap();
  const bodies = session.chosen(model).map((i) => model.bodies[i]);
  const inspected = bodies.map((body) => inspectBody(core, body, settings));
  const report: Report = {
    ...startReport(core, 'inspect', settingsOfCommand('inspect', settings), inspected),
    timings: { load, inspect: session.lap(), total: session.total() },
  };
  return { report: finished(session, report), notes };
}
