/** limber simulate A [B]: A is the original. */

import { basename } from 'node:path';
import { readBinding } from '../engine/report/binding_file';
import type { MotionComparison } from '../engine/core/core';
import { recordingGlb } from '../engine/document/recording';
import type { RecordedBody } from '../engine/document/recording';
import { startStopwatch } from '../engine/stages/pipeline';
import type { PreparedBody } from '../engine/stages/pipeline';
import { findPins } from '../engine/body/pins';
import { calibrationReport, meshReport, simulationReport, startReport } from '../engine/report/report';
import type { Report, RunReport, SimulationReport } from '../engine/report/report';
import { bindingBetween, calibrationOf, simulationOptions, STEP_SECONDS } from '../engine/motion/simulation';
import type { Arguments } from './arguments';
import { checkPairs } from './compare';
import { EXIT, UsageError } from './failure';
import { settingsAsUsed } from './flags';
import { checkOutput, readText, writeWhole } from './files';
import { finish, openFile, prepareBodies, startSession, usable } from './session';
import { count, list } from './words';

export async function runSimulate(args: Arguments): Promise<number> {
  const total = startStopwatch();
  const stopwatch = startStopwatch();
  const { settings, operands } = args;
  if (args.bind !== null && operands.length < 2)
    throw new UsageError('--bind carries pins over to B, which is missing: name both files.');
  checkCalibration(args);
  if (args.record !== null) checkOutput(args.record, operands[0]);
  const session = await startSession(args);
  const first = await openFile(session, operands[0]);
  const second = operands.length > 1 ? await openFile(session, operands[1]) : null;
  const load = stopwatch();
  const originals = usable(prepareBodies(session, first));
  const others = second ? usable(prepareBodies(session, second)) : null;
  if (others) checkPairs(args, originals, others);
  const weld = stopwatch();
  const bindings = args.bind === null ? null : readBinding(basename(args.bind), readText(args.bind));
  const factors =
    others && settings.calibrate
      ? originals.map((original, i) => calibrationOf(session.core, original, others[i].mesh, settings))
      : null;
  const calibration = stopwatch();
  const motions = originals.map((original, i): MotionComparison => {
    session.activity = original.body.name;
    const pinned = settings.pins === '' ? null : findPins(settings.pins, first.document, original);
    const binding = others && bindings ? bindingBetween(original, others[i], bindings) : null;
    const options = simulationOptions(original, settings, pinned);
    const records = args.record !== null;
    return session.core.compareMotion(original.mesh, others?.[i].mesh ?? null, {
      ...options,
      records,
      binding,
      calibration: factors?.[i] ?? 1,
    });
  });
  const simulated = stopwatch();
  if (args.record !== null)
    writeWhole(args.record, await recordingGlb(recorded(motions, originals, others), STEP_SECONDS));
  const report = startReport(session.core, 'simulate', optionsAsUsed(args), originals);
  if (others) report.output = meshReport(others);
  report.simulation = simulationReport(motions, settings);
  if (factors) report.calibration = calibrationReport(originals, factors);
  report.timings = {
    load,
    weld,
    ...(factors ? { calibration } : {}),
    simulate: simulated,
    export: stopwatch(),
    total: total(),
  };
  finish(session, report, simulateText(args, report, originals));
  return EXIT.done;
}

function checkCalibration({ settings, operands }: Arguments): void {
  if (!settings.calibrate) return;
  if (operands.length < 2) throw new UsageError('--calibrate matches B to A: name both files.');
  if (settings.material === 'springs')
    throw new UsageError(
      '--calibrate is for --material shell: springs have no stiffness against bending that a factor could match.',
    );
}

/** Originals where they are, the others beside them. */
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

function optionsAsUsed({ settings, mesh }: Arguments): object {
  const used = settingsAsUsed('simulate', settings);
  return mesh === null ? used : { ...used, mesh };
}

function simulateText(
  { operands, settings }: Arguments,
  { simulation, calibration }: Report,
  bodies: PreparedBody[],
): string {
  const { material, scenario, substeps, original, optimized } = simulation!;
  const what = bodies.length > 1 ? `${bodies.length} bodies` : bodies[0].body.name;
  return list([
    ['scenario', `${scenario}, ${settings.seconds} s, ${material}, ${substeps} substeps, ${what}`],
    [basename(operands[0]), cost(original)],
    ...(calibration ?? []).map(({ body, factor }): [string, string] => [
      'calibrated stiffness',
      `x ${factor.toFixed(4)}${bodies.length > 1 ? `, ${body}` : ''}`,
    ]),
    ...(optimized ? pairRows(basename(operands[1]), optimized, simulation!) : []),
  ]);
}

function cost({ constraints, edges, secondsPerStep, nanosecondsPerConstraint }: RunReport): string {
  const step = `${(1000 * secondsPerStep).toPrecision(3)} ms a step`;
  return `${count(constraints)} constraints, ${count(edges)} edges, ${step}, ${nanosecondsPerConstraint.toFixed(1)} ns a constraint`;
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
