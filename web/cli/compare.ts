/** limber compare A B: A is the original. */

import type { PreparedBody } from '../engine/body/prepared_body';
import type { SurfaceDistance } from '../engine/core/core';
import { startStopwatch } from '../engine/core/stopwatch';
import type { OpenModel } from '../engine/document/open';
import { fidelityReport } from '../engine/report/fidelity_report';
import type { VibrationReport } from '../engine/report/fidelity_report';
import { meshReport } from '../engine/report/mesh_report';
import { settingsOfCommand, startReport } from '../engine/report/report';
import type { Report } from '../engine/report/report';
import { worstSurface } from '../engine/report/result_report';
import type { FileRun } from '../engine/stages/file_run';
import { comparedWarnings } from '../engine/stages/file_warnings';
import { bodyFidelity, compareTopology, measureDistance } from '../engine/stages/measure';
import type { Arguments } from './arguments';
import { EXIT, UsageError } from './failure';
import { finish, openFile, prepareFile, preparePartners, startSession, warnOf } from './session';
import type { Session } from './session';
import { shownNames } from './standard';
import { counted } from '../engine/core/words';
import { facesChange, list } from './words';

export async function runCompare(args: Arguments): Promise<number> {
  const total = startStopwatch();
  const stopwatch = startStopwatch();
  const session = await startSession(args);
  const [first, second] = [await openFile(session), await openFile(session, 1)];
  const load = stopwatch();
  const { originals, others } = preparePairs(session, first, second);
  warnOf(session, 0, comparedWarnings(originals));
  const weld = stopwatch();
  const pairs = originals.map((original, i) => ({ original, other: others[i] }));
  const distances = pairs.map(({ original, other }) => measureDistance(session.core, original, other.mesh));
  const measured = stopwatch();
  const fidelities = pairs.map(({ original, other }) =>
    bodyFidelity(session.core, original, other.mesh, args.settings),
  );
  const report = startReport(session.core, 'compare', optionsAsUsed(args), originals);
  report.output = meshReport(others);
  report.surface = worstSurface(distances);
  const fidelity = fidelityReport(
    fidelities,
    originals.map(({ body }) => body.name),
  );
  report.fidelity = fidelity;
  report.timings = { load, weld, measure: measured, modes: stopwatch(), total: total() };
  finish(session, report, compareText(args, report, fidelity, pairs));
  return EXIT.done;
}

/** Only the settings that a comparison reads; its elastic model is always the shell. */
function optionsAsUsed({ settings }: Arguments): object {
  return { model: 'shell', ...settingsOfCommand('compare', settings) };
}

/** The bodies of A and of B, each beside its own. */
export interface Pairs {
  /** the run of A */
  file: FileRun;
  originals: PreparedBody[];
  others: PreparedBody[];
}

/** Throws UsageError where one of the models has more bodies than the other. */
export function preparePairs(session: Session, first: OpenModel, second: OpenModel): Pairs {
  const { args } = session;
  const file = prepareFile(session, first);
  const originals = file.prepared(args.settings);
  const others = preparePartners(session, first, second).prepared(args.settings);
  checkPairs(args, originals, others);
  return { file, originals, others };
}

function checkPairs(
  { command, operands }: Arguments,
  originals: PreparedBody[],
  others: PreparedBody[],
): void {
  if (originals.length === others.length) return;
  const [a, b] = shownNames(operands);
  throw new UsageError(
    `${a} has ${counted(originals.length, 'body', 'bodies')} and ${b} has ${others.length}: ${command} one with --mesh NAME.`,
  );
}

function compareText(
  { operands }: Arguments,
  report: Report,
  fidelity: VibrationReport,
  pairs: { original: PreparedBody; other: PreparedBody }[],
) {
  const { input, output } = report;
  const isKept = pairs.every(
    ({ original, other }) => compareTopology(original.inspection, other.inspection).kept,
  );
  const [a, b] = shownNames(operands);
  return list([
    [`${a} -> ${b}`, facesChange(input.faces, output!.faces)],
    ['topology', isKept ? 'the same' : 'different'],
    ...surfaceRows(report.surface!),
    ...fidelityRows(fidelity, Number(report.options.modeCount)),
  ]);
}

const percentOf = (value: number): string => `${value.toFixed(value < 0.1 ? 3 : 2)} %`;

function surfaceRows({ hausdorff, mean, vertexHausdorff }: SurfaceDistance): [string, string][] {
  return [
    ['surface deviation', `${percentOf(hausdorff)} of the diagonal, mean ${percentOf(mean)}`],
    [
      '  vertex to nearest vertex',
      `${percentOf(vertexHausdorff)}, about an edge length, as measured in the paper`,
    ],
  ];
}

/** What is absent from the report has no row, but missing frequencies have one that says why. */
function fidelityRows({ failure, ...fidelity }: VibrationReport, modeCount: number): [string, string][] {
  const title = `frequency error, modes 1-${modeCount}`;
  const unknown: [string, string][] = failure === undefined ? [] : [[title, `unknown: ${failure}`]];
  const { frequencyErrorHigh: high } = fidelity;
  if (!isKnown(fidelity)) return unknown;
  return [
    ...unknown,
    [
      title,
      `mean ${percentOf(fidelity.frequencyErrorMean)}, largest ${percentOf(fidelity.frequencyErrorMax)}`,
    ],
    [
      '  after one factor on E',
      `mean ${percentOf(fidelity.frequencyErrorCalibrated)} (factor ${fidelity.calibrationFactor.toFixed(3)})`,
    ],
    ['  at half the thickness', `mean ${percentOf(fidelity.frequencyErrorThin)}`],
    ['  at twice the thickness', `mean ${percentOf(fidelity.frequencyErrorThick)}`],
    ...(high === undefined ? [] : [['  of the next modes', `mean ${percentOf(high)}`] as [string, string]]),
    ['shape agreement (MAC)', `mean ${fidelity.macMean.toFixed(3)}, smallest ${fidelity.macMin.toFixed(3)}`],
  ];
}

type KnownFidelity = Required<Omit<VibrationReport, 'frequencyErrorHigh' | 'failure'>>;

const isKnown = (fidelity: Partial<KnownFidelity>): fidelity is KnownFidelity =>
  fidelity.frequencyErrorMean !== undefined;
