/** Simulates a model, and an optimized one for comparison. */

import type { BodyBinding } from '../../engine/body/body_binding';
import type { PreparedBody } from '../../engine/body/prepared_body';
import type { MotionComparison } from '../../engine/core/core';
import { recordingGlb } from '../../engine/document/recording';
import type { RecordedBody } from '../../engine/document/recording';
import { motionModel, checkBesideTuning, solversOf } from '../../engine/stages/simulated_solvers';
import {
  bindingBetween,
  calibrationOf,
  simulationOptions,
  STEP_SECONDS,
} from '../../engine/motion/simulation';
import { describePinProblem, findPinProblem } from '../../engine/motion/pin_problems';
import { readBinding } from '../../engine/report/binding_file';
import { meshReport } from '../../engine/report/mesh_report';
import { calibrationReport, simulationReport } from '../../engine/report/motion_report';
import { ofBody } from '../../engine/report/warnings';
import { settingsOfCommand, startReport } from '../../engine/report/report';
import type { SettingsFile } from '../../engine/report/settings_file';
import { readSettingsFile } from '../../engine/report/settings_reader';
import type { FileRun } from '../../engine/stages/file_run';
import { sizeWarnings } from '../../engine/stages/file_warnings';
import { STAGES } from '../../engine/stages/stages';
import type { SimulateOptions, SimulateReport, SimulateResult } from '../options';
import type { ModelFiles } from '../protocol';
import { finished } from './optimize';
import { checkPairs } from './pairs';
import { resultBytes } from './result_bytes';
import { nameOf } from './session';
import type { WorkSession } from './session';

/** The bodies of the original and, where there is one, of the other model, in the order of their files. */
interface Sides {
  file: FileRun;
  originals: PreparedBody[];
  others: PreparedBody[] | null;
}

/** What the simulation of the other model uses besides its mesh. */
interface Carried {
  bindings: BodyBinding[] | null;
  tuning: SettingsFile | null;
  /** factors on the stiffness per body */
  factors: number[] | null;
}

export async function simulateModels(
  session: WorkSession,
  [first, second]: ModelFiles[],
  options: SimulateOptions,
): Promise<SimulateResult> {
  const { core, settings, notes } = session;
  checkCarried(options, settings, second !== undefined);
  const which = second ? 'first ' : '';
  const original = await session.open(first, which);
  const other = second ? await session.open(second, 'second ') : null;
  const load = session.lap();
  const file = session.prepare(original, { which });
  const originals = file.prepared(settings);
  const others = other && session.preparePartners(original, other).prepared(settings);
  if (others) checkPairs(originals, others);
  const sides = { file, originals, others };
  const weld = session.lap();
  const carried = readCarried(session, sides, options);
  if (carried.tuning === null) session.warn(sizeWarnings(file, settings, nameOf), which);
  const calibration = session.lap();
  const motions = moveBodies(session, sides, { ...carried, records: options.records ?? false });
  const simulate = session.lap();
  const recording = options.records
    ? resultBytes(await recordingGlb(recorded(motions, sides), STEP_SECONDS))
    : null;
  const { factors, tuning } = carried;
  const used = settingsOfCommand('simulate', settings);
  const report: SimulateReport = {
    ...startReport(core, 'simulate', used, originals),
    ...(others ? { output: meshReport(others) } : {}),
    simulation: simulationReport(motions, motionModel(settings, tuning, others !== null)),
    ...(factors ? { calibration: calibrationReport(originals, factors) } : {}),
    timings: { load, weld, ...(factors ? { calibration } : {}), simulate, export: session.lap() },
  };
  report.timings.total = session.total();
  return { recording, report: finished(session, report), notes };
}

/** Refuses contradictory options before any work. */
function checkCarried(
  { binding = null, settingsFile = null }: SimulateOptions,
  settings: WorkSession['settings'],
  isPair: boolean,
): void {
  const lonely = binding !== null ? 'binding' : settingsFile !== null ? 'settingsFile' : null;
  if (lonely && !isPair) throw new Error(`${lonely} is for the other model, which is missing: give both.`);
  if (settingsFile !== null) checkBesideTuning(settings);
  if (!settings.calibrate) return;
  if (!isPair) throw new Error('calibrate matches the other model to the original: give both.');
  if (settingsFile !== null)
    throw new Error(
      'calibrate is for no solver, and a settingsFile is tuned for one: leave one of them out.',
    );
  if (settings.solver !== 'none' || settings.material === 'springs')
    throw new Error('calibrate is for material "shell" and no solver: leave the others out.');
}

const CURES = {
  binding: 'give the binding that optimize returns with bind: true',
  settingsFile: 'give the settingsFile that tune, or optimize with a solver, returns',
};

function readCarried(
  { core, settings }: WorkSession,
  { originals, others }: Sides,
  { binding = null, settingsFile = null }: SimulateOptions,
): Carried {
  const tuning =
    settingsFile === null ? null : readSettingsFile('settingsFile', settingsFile, CURES.settingsFile);
  if (tuning && settings.solver !== 'none' && settings.solver !== tuning.solver)
    throw new Error(`settingsFile is for solver ${tuning.solver}, not ${settings.solver}: give that.`);
  const factors = others && settings.calibrate;
  return {
    bindings: binding === null ? null : readBinding('binding', binding, CURES.binding),
    tuning,
    factors: factors
      ? originals.map((original, i) => calibrationOf(core, original, others[i].mesh, settings))
      : null,
  };
}

function moveBodies(
  session: WorkSession,
  { file, originals, others }: Sides,
  { bindings, factors, tuning, records }: Carried & { records: boolean },
): MotionComparison[] {
  const { core, settings } = session;
  return file.usable.map(({ run }, i) => {
    const original = originals[i];
    file.announce(run);
    const pinned = settings.pins === '' ? null : run.get(STAGES.pinned, settings);
    const trouble = findPinProblem(settings.scenario, original.mesh, pinned);
    if (trouble) {
      const told = describePinProblem(trouble, settings.scenario, settingText);
      session.warn([ofBody(original.body.name, told)], others ? 'first ' : '');
    }
    const solvers = solversOf(session.settings, original, others?.[i] ?? null, tuning);
    return core.compareMotion(original.mesh, others?.[i].mesh ?? null, {
      ...simulationOptions(original, settings, pinned),
      records,
      binding: others && bindings ? bindingBetween(original, others[i], bindings) : null,
      calibration: factors?.[i] ?? 1,
      solver: solvers?.original ?? null,
      otherSolver: solvers?.result ?? null,
      doublesSubsteps: settings.converge,
    });
  });
}

/** Originals at their own coordinates, the others beside them. */
function recorded(motions: MotionComparison[], { originals, others }: Sides): RecordedBody[] {
  const offset = 1.2 * Math.max(...originals.map(({ diagonal }) => diagonal));
  return motions.flatMap(({ original, other }, i) => {
    const { body, mesh } = originals[i];
    const first = { name: body.name, mesh, positions: original.positions, offset: 0 };
    if (!other) return [first];
    const name = `${body.name} optimized`;
    return [first, { name, mesh: others![i].mesh, positions: other.positions, offset }];
  });
}

const settingText = (name: string, value?: string): string => `${name}${value ? ` "${value}"` : ''}`;
