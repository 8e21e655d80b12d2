/** limber simulate A [B]: A is the original. */

import { basename } from 'node:path';
import { readBinding } from '../engine/report/binding_file';
import type { BodyBinding } from '../engine/body/body_binding';
import type { MotionComparison, SimulationModel } from '../engine/core/core';
import { recordingGlb } from '../engine/document/recording';
import type { RecordedBody } from '../engine/document/recording';
import type { PinnedVertices } from '../engine/body/pins';
import type { PreparedBody } from '../engine/body/prepared_body';
import type { OpenModel } from '../engine/document/open';
import { startStopwatch } from '../engine/core/stopwatch';
import { checkBesideTuning, motionModel, solversOf } from '../engine/stages/simulated_solvers';
import { describeConvergence } from '../engine/motion/convergence';
import { describePinProblem, findPinProblem } from '../engine/motion/pin_problems';
import { bindingBetween, calibrationOf, simulationOptions, STEP_SECONDS } from '../engine/motion/simulation';
import { meshReport } from '../engine/report/mesh_report';
import { calibrationReport, simulationReport, worstMotion } from '../engine/report/motion_report';
import type { RunReport, SimulationReport } from '../engine/report/motion_report';
import type { SettingsFile } from '../engine/report/settings_file';
import { readSettingsFile } from '../engine/report/settings_reader';
import { settingsOfCommand, startReport } from '../engine/report/report';
import type { Report } from '../engine/report/report';
import { ofBody } from '../engine/report/warnings';
import { sizeWarnings } from '../engine/stages/file_warnings';
import { profileOf } from '../engine/solvers/profiles';
import { STAGES } from '../engine/stages/stages';
import type { Arguments } from './arguments';
import { preparePairs } from './compare';
import type { Pairs } from './compare';
import { EXIT, flagOf, UsageError } from './failure';
import { readText } from './input_files/read_file';
import { finish, openFile, prepareFile, save, startSession, warnOf } from './session';
import type { Session } from './session';
import { shownNames } from './standard';
import { grouped } from '../engine/core/words';
import { list } from './words';

/** The bodies of A and, where it is named, of B, in the order of their files. `others` is null where only A is simulated. */
type Sides = Omit<Pairs, 'others'> & { others: PreparedBody[] | null };

export async function runSimulate(args: Arguments): Promise<number> {
  const total = startStopwatch();
  const stopwatch = startStopwatch();
  const carried = readCarried(args);
  const session = await startSession(args);
  const first = await openFile(session);
  const second = args.operands.length > 1 ? await openFile(session, 1) : null;
  const load = stopwatch();
  const sides = prepareSides(session, first, second);
  const { originals, others } = sides;
  if (carried.tuning === null) warnOf(session, 0, sizeWarnings(sides.file, args.settings, flagOf));
  const setups = setUpMotions(session, sides, carried);
  const weld = stopwatch();
  const factors = calibrationFactors(session, sides);
  const calibration = stopwatch();
  const motions = compareMotions(session, sides, { setups, factors });
  const simulated = stopwatch();
  if (args.record !== null)
    save(session, args.record, await recordingGlb(recorded(motions, originals, others), STEP_SECONDS));
  const report = startReport(
    session.core,
    'simulate',
    settingsOfCommand('simulate', args.settings),
    originals,
  );
  if (others) report.output = meshReport(others);
  report.simulation = simulationReport(motions, motionModel(args.settings, carried.tuning, others !== null));
  if (factors) report.calibration = calibrationReport(originals, factors);
  report.timings = {
    load,
    weld,
    ...(factors ? { calibration } : {}),
    simulate: simulated,
    export: stopwatch(),
    total: total(),
  };
  finish(session, report, simulateText(args, report, originals) + (others ? convergenceText(motions) : ''));
  return EXIT.done;
}

/** What is read besides models. */
interface Carried {
  bindings: BodyBinding[] | null;
  tuning: SettingsFile | null;
}

/** Throws UsageError for contradictory arguments, before any work. */
export function readCarried(args: Arguments): Carried {
  checkArguments(args);
  const bindings = args.bind === null ? null : readBinding(basename(args.bind), readText(args.bind));
  return { bindings, tuning: readTuning(args) };
}

function checkArguments(args: Arguments): void {
  if (args.bind !== null && args.operands.length < 2)
    throw new UsageError('--bind transfers pins to B, which is missing: name both files.');
  if (args.settingsFile !== null && args.operands.length < 2)
    throw new UsageError('--settings applies to B, which is missing: name both files.');
  if (args.settingsFile !== null) checkBesideTuning(args.settings);
  checkCalibration(args);
}

function checkCalibration({ settings, operands, settingsFile }: Arguments): void {
  if (!settings.calibrate) return;
  if (operands.length < 2) throw new UsageError('--calibrate matches B to A: name both files.');
  if (settings.solver !== 'none')
    throw new UsageError(
      '--calibrate cannot be combined with --solver: use --settings to simulate a tuned B.',
    );
  if (settingsFile !== null)
    throw new UsageError(
      '--calibrate cannot be combined with --settings, which is tuned for a solver: leave one of them out.',
    );
  if (settings.material === 'springs')
    throw new UsageError(
      '--calibrate does not work with --material springs, which has no bending stiffness to scale: give --material shell.',
    );
}

/** The settings that B was tuned with; null: B is simulated untouched. */
function readTuning({ settingsFile, settings }: Arguments): SettingsFile | null {
  if (settingsFile === null) return null;
  const name = basename(settingsFile);
  const file = readSettingsFile(name, readText(settingsFile));
  if (settings.solver !== 'none' && settings.solver !== file.solver)
    throw new UsageError(
      `${name} is for --solver ${file.solver}, not ${settings.solver}: give --solver ${file.solver}.`,
    );
  return file;
}

/** Per body the factor on the stiffness of B; null where none is asked for. */
function calibrationFactors({ core, args }: Session, { originals, others }: Sides): number[] | null {
  if (!others || !args.settings.calibrate) return null;
  return originals.map((original, i) => calibrationOf(core, original, others[i].mesh, args.settings));
}

export function prepareSides(session: Session, first: OpenModel, second: OpenModel | null): Sides {
  if (second) return preparePairs(session, first, second);
  const file = prepareFile(session, first);
  return { file, originals: file.prepared(session.args.settings), others: null };
}

/** What a body is simulated with. */
interface MotionSetup {
  /** null: nothing is pinned */
  pinned: PinnedVertices | null;
  /** null: closest points */
  binding: ReturnType<typeof bindingBetween> | null;
  /** null: no solver is named */
  solvers: ReturnType<typeof solversOf>;
}

/** By body; all that is known before anything moves. Throws where what was asked for or read is not of these bodies. */
export function setUpMotions(
  session: Session,
  { file, originals, others }: Sides,
  { bindings, tuning }: Carried,
): MotionSetup[] {
  const { settings } = session.args;
  return file.usable.map(({ run }, i) => {
    const original = originals[i];
    const pinned = settings.pins === '' ? null : run.get(STAGES.pinned, settings);
    const trouble = findPinProblem(settings.scenario, original.mesh, pinned);
    if (trouble) {
      const told = describePinProblem(trouble, settings.scenario, flagText);
      warnOf(session, 0, [ofBody(original.body.name, told, originals.length > 1)]);
    }
    const binding = others && bindings ? bindingBetween(original, others[i], bindings) : null;
    return { pinned, binding, solvers: solversOf(settings, original, others?.[i] ?? null, tuning) };
  });
}

interface MotionRequest {
  setups: MotionSetup[];
  factors: number[] | null;
}

function compareMotions(
  session: Session,
  { file, originals, others }: Sides,
  { setups, factors }: MotionRequest,
): MotionComparison[] {
  const { settings, record } = session.args;
  return file.usable.map(({ run }, i) => {
    const original = originals[i];
    const { pinned, binding, solvers } = setups[i];
    file.announce(run);
    return session.core.compareMotion(original.mesh, others?.[i].mesh ?? null, {
      ...simulationOptions(original, settings, pinned),
      records: record !== null,
      binding,
      calibration: factors?.[i] ?? 1,
      solver: solvers?.original ?? null,
      otherSolver: solvers?.result ?? null,
      doublesSubsteps: settings.converge,
    });
  });
}

const flagText = (name: string, value?: string): string => `--${name}${value ? ` ${value}` : ''}`;

/** Originals at their own coordinates, the others beside them. */
function recorded(
  motions: MotionComparison[],
  originals: PreparedBody[],
  others: PreparedBody[] | null,
): RecordedBody[] {
  const offset = 1.2 * Math.max(...originals.map(({ diagonal }) => diagonal));
  return motions.flatMap(({ original, other }, i) => {
    const { body, mesh } = originals[i];
    const first = { name: body.name, mesh, positions: original.positions, offset: 0 };
    if (!other) return [first];
    return [
      first,
      { name: `${body.name} optimized`, mesh: others![i].mesh, positions: other.positions, offset },
    ];
  });
}

const MATERIAL_WORDS: Record<SimulationModel, string> = {
  solid: 'solid where closed',
  shell: 'shell',
  springs: 'springs',
};

function simulateText(
  { operands, settings }: Arguments,
  { simulation, calibration }: Report,
  bodies: PreparedBody[],
): string {
  const { material, solver, tuned, scenario, substeps, original, optimized } = simulation!;
  const tuning = tuned === undefined ? '' : tuned ? ', tuned' : ', untuned';
  const made = solver ? `${profileOf(solver).label}${tuning}` : MATERIAL_WORDS[material];
  const [first, second] = shownNames(operands);
  const what = bodies.length > 1 ? `${bodies.length} bodies` : bodies[0].body.name;
  return list([
    ['scenario', `${scenario}, ${settings.seconds} s, ${made}, ${substeps} substeps, ${what}`],
    [first, cost(original)],
    ...(calibration ?? []).map(({ body, factor }): [string, string] => [
      'calibrated stiffness',
      `x ${factor.toFixed(4)}${bodies.length > 1 ? `, ${body}` : ''}`,
    ]),
    ...(optimized ? pairRows(second, optimized, simulation!) : []),
  ]);
}

/** A line where the original of the body that deviates most has not converged; else nothing. */
function convergenceText(motions: MotionComparison[]): string {
  const sentence = describeConvergence(worstMotion(motions), (substeps) => `take --substeps ${substeps}`);
  return sentence ? `\n${sentence}` : '';
}

function cost({ constraints, edges, secondsPerStep, nanosecondsPerConstraint }: RunReport): string {
  const step = `${(1000 * secondsPerStep).toPrecision(3)} ms a step`;
  return `${grouped(constraints)} constraints, ${grouped(edges)} edges, ${step}, ${nanosecondsPerConstraint.toFixed(1)} ns a constraint`;
}

function pairRows(
  name: string,
  optimized: RunReport,
  { speedup, edgeRatio, deviation }: SimulationReport,
): [string, string][] {
  const { mean, max, noiseFloor } = deviation!;
  return [
    [name, cost(optimized)],
    ['speedup', `x ${speedup!.toFixed(2)} (edges x ${edgeRatio!.toFixed(2)})`],
    [
      'deviation of the motion',
      `mean ${mean.toFixed(3)} % of the diagonal, largest ${max.toFixed(2)} %, noise floor ${noiseFloor.toFixed(3)} %`,
    ],
  ];
}
