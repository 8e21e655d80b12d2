/** The cost of simulations, and the calibration of results for them. */

import type { MotionComparison, SimulationModel } from '../core/core';
import type { ScenarioName } from '../core/scenarios';
import { sum } from '../core/mesh';
import type { SolverName } from '../solvers/profiles';

/** The factor on Young's modulus that gives a result the first ten frequencies of its original. */
export interface CalibrationReport {
  /** name of the body */
  body: string;
  factor: number;
}

export interface SimulationReport {
  material: SimulationModel;
  scenario: ScenarioName;
  /** the solver of an engine or family, used instead of `material` */
  solver?: SolverName;
  /** whether results had the settings of a tuning; absent without a solver or without results */
  tuned?: boolean;
  /** as used */
  substeps: number;
  original: RunReport;
  optimized?: RunReport;
  /** seconds per step of the originals over those of the results */
  speedup?: number;
  /** edges of the originals over those of the results */
  edgeRatio?: number;
  /** motion deviation of the worst body, in % of its diagonal */
  deviation?: DeviationReport;
}

export interface DeviationReport {
  mean: number;
  max: number;
  noiseFloor: number;
  /** the deviation of the original from itself with twice the substeps */
  substeps: number;
  /** whether that is at most a quarter of `mean` */
  converged: boolean;
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
  { material, scenario, solver, tuned }: Pick<SimulationReport, 'material' | 'scenario' | 'solver' | 'tuned'>,
): SimulationReport {
  const others = motions.map(({ other }) => other).filter((other) => other !== null);
  const substeps = Math.max(...motions.map((motion) => motion.substeps));
  const inSolver = { ...(solver ? { solver } : {}), ...(tuned === undefined ? {} : { tuned }) };
  const alone = { material, scenario, ...inSolver, substeps, original: runReport(motions, 'original') };
  if (others.length < motions.length) return alone;
  const optimized = runReport(motions, 'other');
  const worst = worstMotion(motions);
  return {
    ...alone,
    optimized,
    speedup: alone.original.secondsPerStep / optimized.secondsPerStep,
    edgeRatio: alone.original.edges / optimized.edges,
    deviation: {
      mean: worst.deviationMean,
      max: worst.deviationMax,
      noiseFloor: worst.noiseFloor,
      substeps: worst.substepDeviation,
      converged: worst.isConverged,
    },
  };
}

/** The body whose result deviates most. */
export const worstMotion = (motions: MotionComparison[]): MotionComparison =>
  motions.reduce((most, one) => (one.deviationMean > most.deviationMean ? one : most));

function runReport(motions: MotionComparison[], body: 'original' | 'other'): RunReport {
  const runs = motions.map((motion) => motion[body]!);
  const [constraints, edges, secondsPerStep] = (['constraints', 'edges', 'secondsPerStep'] as const).map(
    (key) => sum(runs.map((run) => run[key])),
  );
  const solved = sum(motions.map((motion, i) => motion.substeps * runs[i].constraints));
  return { constraints, edges, secondsPerStep, nanosecondsPerConstraint: (1e9 * secondsPerStep) / solved };
}
