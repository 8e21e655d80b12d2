/** What simulations have cost, and how results are calibrated for them. */

import type { MotionComparison, MotionRun, SimulationModel } from '../core/core';
import type { ScenarioName } from '../core/scenarios';
import { sum } from '../core/mesh';

/** The factor on Young's modulus that gives a result the first ten frequencies of its original. */
export interface CalibrationReport {
  /** name of the body */
  body: string;
  factor: number;
}

export interface SimulationReport {
  material: SimulationModel;
  scenario: ScenarioName;
  substeps: number;
  original: RunReport;
  optimized?: RunReport;
  /** seconds per step of the originals over those of the results */
  speedup?: number;
  /** edges of the originals over those of the results */
  edgeRatio?: number;
  /** motion deviation of the worst body, in % of its diagonal */
  deviation?: { mean: number; max: number; noiseFloor: number };
}

/** The cost of simulating all originals together, or all results. */
export interface RunReport {
  constraints: number;
  edges: number;
  /** the shortest step, including all its work */
  secondsPerStep: number;
  /** secondsPerStep / (substeps x constraints) */
  nanosecondsPerConstraint: number;
}

/** factors[i] belongs to bodies[i]. */
export function calibrationReport(
  bodies: { body: { name: string } }[],
  factors: number[],
): CalibrationReport[] {
  return bodies.map(({ body }, i) => ({ body: body.name, factor: factors[i] }));
}

/** The cost of all bodies together, and the deviation of the worst one. */
export function simulationReport(
  motions: MotionComparison[],
  { material, scenario, substeps }: Pick<SimulationReport, 'material' | 'scenario' | 'substeps'>,
): SimulationReport {
  const others = motions.map(({ other }) => other).filter((other) => other !== null);
  const original = runReport(
    motions.map((motion) => motion.original),
    substeps,
  );
  const alone = { material, scenario, substeps, original };
  if (others.length < motions.length) return alone;
  const optimized = runReport(others, substeps);
  const worst = motions.reduce((most, one) => (one.deviationMean > most.deviationMean ? one : most));
  return {
    ...alone,
    optimized,
    speedup: original.secondsPerStep / optimized.secondsPerStep,
    edgeRatio: original.edges / optimized.edges,
    deviation: { mean: worst.deviationMean, max: worst.deviationMax, noiseFloor: worst.noiseFloor },
  };
}

function runReport(runs: MotionRun[], substeps: number): RunReport {
  const [constraints, edges, secondsPerStep] = (['constraints', 'edges', 'secondsPerStep'] as const).map(
    (key) => sum(runs.map((run) => run[key])),
  );
  const nanosecondsPerConstraint = (1e9 * secondsPerStep) / (substeps * constraints);
  return { constraints, edges, secondsPerStep, nanosecondsPerConstraint };
}
