/** limber simulate A [B]: A is the original. */

import { basename } from 'node:path';
import type { MotionComparison } from '../engine/core';
import { startStopwatch } from '../engine/pipeline';
import type { PreparedBody } from '../engine/pipeline';
import { findPins } from '../engine/pins';
import { meshReport, simulationReport, startReport } from '../engine/report';
import type { Report, RunReport, SimulationReport } from '../engine/report';
import { simulationOptions } from '../engine/simulation';
import type { Arguments } from './arguments';
import { checkPairs } from './compare';
import { EXIT } from './failure';
import { finish, openFile, prepareBodies, startSession, usable } from './session';
import { count, list } from './words';

export async function runSimulate(args: Arguments): Promise<number> {
  const total = startStopwatch();
  const stopwatch = startStopwatch();
  const session = await startSession(args);
  const { settings, operands } = args;
  const first = await openFile(session, operands[0]);
  const second = operands.length > 1 ? await openFile(session, operands[1]) : null;
  const load = stopwatch();
  const originals = usable(prepareBodies(session, first));
  const others = second ? usable(prepareBodies(session, second)) : null;
  if (others) checkPairs(args, originals, others);
  const weld = stopwatch();
  const motions = originals.map((original, i): MotionComparison => {
    session.activity = original.body.name;
    const pinned = settings.pins === '' ? null : findPins(settings.pins, first.document, original);
    const options = { ...simulationOptions(original, settings, pinned), records: false };
    return session.core.compareMotion(original.mesh, others ? others[i].mesh : null, options);
  });
  const report = startReport(session.core, 'simulate', optionsAsUsed(args), originals);
  if (others) report.output = meshReport(others);
  report.simulation = simulationReport(motions, settings);
  report.timings = { load, weld, simulate: stopwatch(), total: total() };
  finish(session, report, simulateText(args, report, originals));
  return EXIT.done;
}

function optionsAsUsed({ settings, mesh }: Arguments): object {
  const { scenario, material, seconds, substeps, damping, pins } = settings;
  const { young, poisson, density, thickness, unit, weld, threads } = settings;
  const motion = { scenario, material, seconds, substeps, damping, ...(pins === '' ? {} : { pins }) };
  const used = { ...motion, young, poisson, density, thickness, unit, weld, threads };
  return mesh === null ? used : { ...used, mesh };
}

function simulateText(
  { operands, settings }: Arguments,
  { simulation }: Report,
  bodies: PreparedBody[],
): string {
  const { material, scenario, substeps, original, optimized } = simulation!;
  const what = bodies.length > 1 ? `${bodies.length} bodies` : bodies[0].body.name;
  return list([
    ['scenario', `${scenario}, ${settings.seconds} s, ${material}, ${substeps} substeps, ${what}`],
    [basename(operands[0]), cost(original)],
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
