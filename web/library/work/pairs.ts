/** Two models of the same bodies: comparing them, and tuning the second. */

import type { PreparedBody } from '../../engine/body/prepared_body';
import { faceCount } from '../../engine/core/mesh';
import { counted } from '../../engine/core/words';
import { fidelityReport } from '../../engine/report/fidelity_report';
import { meshReport } from '../../engine/report/mesh_report';
import { settingsOfCommand, startReport } from '../../engine/report/report';
import { worstSurface } from '../../engine/report/result_report';
import { settingsFile, writeSettings } from '../../engine/report/settings_file';
import { solverReport } from '../../engine/report/solver_report';
import type { TunedBody } from '../../engine/solvers/tuned_body';
import type { FileRun } from '../../engine/stages/file_run';
import { comparedWarnings, sizeWarnings } from '../../engine/stages/file_warnings';
import { bodyFidelity, measureDistance } from '../../engine/stages/measure';
import { STAGES } from '../../engine/stages/stages';
import { withBodyName, tunedEntry, tuneMesh, tuneSettings } from '../../engine/stages/tune';
import type { CompareReport, Reported, TuneResult } from '../options';
import type { ModelFiles } from '../protocol';
import { finished } from './optimize';
import { nameOf } from './session';
import type { WorkSession } from './session';

/** Throws an Error where the models have different numbers of bodies: they are compared in the order of their files. */
export function checkPairs(originals: PreparedBody[], others: PreparedBody[]): void {
  if (originals.length === others.length) return;
  const first = counted(originals.length, 'body', 'bodies');
  throw new Error(
    `The original has ${first} and the other model ${others.length}: name one of each with "mesh".`,
  );
}

export async function compareModels(
  session: WorkSession,
  [first, second]: ModelFiles[],
): Promise<Reported<CompareReport>> {
  const { core, settings, notes } = session;
  const models = [await session.open(first, 'first '), await session.open(second, 'second ')];
  const load = session.lap();
  const originals = session.prepare(models[0], { which: 'first ' }).prepared(settings);
  const others = session.preparePartners(models[0], models[1]).prepared(settings);
  checkPairs(originals, others);
  session.warn(comparedWarnings(originals), 'first ');
  const weld = session.lap();
  const distances = originals.map((original, i) => measureDistance(core, original, others[i].mesh));
  const measure = session.lap();
  const fidelities = originals.map((original, i) => bodyFidelity(core, original, others[i].mesh, settings));
  const names = originals.map(({ body }) => body.name);
  const used = { model: 'shell', ...settingsOfCommand('compare', settings) };
  const report = {
    ...startReport(core, 'compare', used, originals),
    output: meshReport(others),
    surface: worstSurface(distances),
    fidelity: fidelityReport(fidelities, names),
    timings: { load, weld, measure, modes: session.lap(), total: session.total() },
  };
  return { report: finished(session, report), notes };
}

export async function tuneModel(session: WorkSession, [first, second]: ModelFiles[]): Promise<TuneResult> {
  const { core, settings, notes } = session;
  const [original, coarse] = [await session.open(first, 'first '), await session.open(second, 'second ')];
  const load = session.lap();
  const file = session.prepare(original, { which: 'first ' });
  const originals = file.prepared(settings);
  const others = session.preparePartners(original, coarse).prepared(settings);
  checkPairs(originals, others);
  session.warn(sizeWarnings(file, settings, nameOf), 'first ');
  const weld = session.lap();
  const tuned = tuneFile(session, file, others);
  const tune = session.lap();
  const bodies = others.map((other, i) => tunedEntry(other, tuned[i]));
  const text = writeSettings(settingsFile(bodies, settings));
  const report = {
    ...startReport(core, 'tune', settingsOfCommand('tune', settings), originals),
    ...solverReport(tuned),
    output: meshReport(others),
    timings: { load, weld, tune, export: session.lap(), total: session.total() },
  };
  return { settingsFile: text, report: finished(session, report), notes };
}

function tuneFile({ core, settings }: WorkSession, file: FileRun, others: PreparedBody[]): TunedBody[] {
  const asked = tuneSettings(settings)!; // the settings are checked
  return file.usable.map(({ run }, i) => {
    file.announce(run);
    const prepared = run.get(STAGES.prepared, settings);
    checkFaces(prepared, others[i]);
    const { mesh } = others[i];
    const pinnedOriginal = run.get(STAGES.pinned, settings);
    const pinned = core.carryPins(prepared.mesh, pinnedOriginal, mesh);
    return withBodyName(prepared.body, file.usable.length > 1, () =>
      tuneMesh(core, prepared, { mesh, pinned, pinnedOriginal }, asked),
    );
  });
}

function checkFaces({ mesh, body }: PreparedBody, other: PreparedBody): void {
  const [before, after] = [faceCount(mesh), faceCount(other.mesh)];
  if (after > before)
    throw new Error(
      `"${body.name}" has ${counted(before, 'face')} in the first model and ${after} in the second: name the original first.`,
    );
}
