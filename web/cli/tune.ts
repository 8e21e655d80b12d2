/** limber tune A B: A is the original, B any coarse mesh of it. */

import type { PreparedBody } from '../engine/body/prepared_body';
import { faceCount } from '../engine/core/mesh';
import { startStopwatch } from '../engine/core/stopwatch';
import type { OpenModel } from '../engine/document/open';
import { meshReport } from '../engine/report/mesh_report';
import { settingsOfCommand, startReport } from '../engine/report/report';
import { settingsFile, writeSettings } from '../engine/report/settings_file';
import { describeTuning, solverReport } from '../engine/report/solver_report';
import type { SolverName } from '../engine/solvers/profiles';
import type { TunedBody } from '../engine/solvers/tuned_body';
import { sizeWarnings } from '../engine/stages/file_warnings';
import { STAGES } from '../engine/stages/stages';
import { withBodyName, tunedEntry, tuneMesh, tuneSettings } from '../engine/stages/tune';
import type { Arguments } from './arguments';
import { preparePairs } from './compare';
import type { Pairs } from './compare';
import { EXIT, flagOf, UsageError } from './failure';
import { finish, openFile, save, startSession, warnOf } from './session';
import type { Session } from './session';
import { shownNames, shownOutput } from './standard';
import { counted, grouped } from '../engine/core/words';

export async function runTune(args: Arguments): Promise<number> {
  const path = args.settingsFile!;
  const [total, stopwatch] = [startStopwatch(), startStopwatch()];
  const session = await startSession(args);
  const [first, second] = [await openFile(session), await openFile(session, 1)];
  const load = stopwatch();
  const pairs = prepareTuning(session, first, second);
  const { originals, others } = pairs;
  warnOf(session, 0, sizeWarnings(pairs.file, args.settings, flagOf));
  const weld = stopwatch();
  const tuned = tuneFile(session, pairs);
  const tune = stopwatch();
  const bodies = others.map((other, i) => tunedEntry(other, tuned[i]));
  save(session, path, writeSettings(settingsFile(bodies, args.settings)));
  const found = solverReport(tuned);
  const report = {
    ...startReport(session.core, 'tune', settingsOfCommand('tune', args.settings), originals),
    ...found,
    output: meshReport(others),
    timings: { load, weld, tune, export: stopwatch(), total: total() },
  };
  const solver = args.settings.solver as SolverName;
  const [errors, ...motion] = describeTuning(solver, found.fidelity.solvers[solver]!);
  const seconds = `${report.timings.total.toFixed(1)} s -> ${shownOutput(path)}`;
  finish(session, report, [`${shownNames(args.operands)[1]}: ${errors}`, ...motion, seconds].join('\n'));
  return EXIT.done;
}

/** The bodies, with their pins found. Throws UsageError where a body of B is finer than that of A, or is missing. */
export function prepareTuning(session: Session, first: OpenModel, second: OpenModel): Pairs {
  const { args } = session;
  const pairs = preparePairs(session, first, second);
  pairs.file.usable.forEach(({ run }, i) => {
    checkFaces(args, pairs.originals[i], pairs.others[i]);
    run.get(STAGES.pinned, args.settings);
  });
  return pairs;
}

function tuneFile({ core, args }: Session, { file, others }: Pairs): TunedBody[] {
  const settings = tuneSettings(args.settings)!;
  return file.usable.map(({ run }, i) => {
    file.announce(run);
    const prepared = run.get(STAGES.prepared, args.settings);
    const { mesh } = others[i];
    const pinnedOriginal = run.get(STAGES.pinned, args.settings);
    const pinned = core.carryPins(prepared.mesh, pinnedOriginal, mesh);
    return withBodyName(prepared.body, file.usable.length > 1, () =>
      tuneMesh(core, prepared, { mesh, pinned, pinnedOriginal }, settings),
    );
  });
}

function checkFaces({ operands }: Arguments, { mesh, body }: PreparedBody, other: PreparedBody): void {
  const [before, after] = [faceCount(mesh), faceCount(other.mesh)];
  if (after <= before) return;
  const [a, b] = shownNames(operands);
  throw new UsageError(
    `"${body.name}" has ${counted(before, 'face')} in ${a} and ${grouped(after)} in ${b}: name the original first.`,
  );
}
