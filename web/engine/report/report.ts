/**
 * The JSON report that every command gives. Lengths in % of the bounding-box diagonal, angles in degrees, times in
 * seconds, errors in %, MAC in 0..1. A key that a command does not produce is absent.
 *
 * Several bodies: counts are summed, angles are the smallest and the mean over all faces, components are numbered through
 * and modes sorted together, distances and fidelity are those of the worst body.
 */

import type {
  Core,
  Fidelity,
  History,
  Inspection,
  Model,
  ModeName,
  ModeSet,
  MotionComparison,
  MotionRun,
  Quality,
  Refused,
  SimulationModel,
  SurfaceDistance,
  WeldResult,
} from '../core/core';
import type { ScenarioName } from '../core/scenarios';
import type { FrequencyFinding, Tried } from '../stages/frequency_target';
import { coarseVerticesOf } from '../core/mode_set';
import type { FittedResult } from '../stages/pipeline';
import { VERSION } from '../core/version';

export interface Report {
  schema: 'limber-report/1';
  version: string;
  command: string;
  /** as used: `auto` is resolved; p may be "inf" */
  options: Record<string, unknown>;
  threads: number;
  /** size of the wasm memory */
  peakHeapBytes: number;
  input: MeshReport;
  output?: MeshReport;
  model?: Model | 'mixed';
  components?: ComponentReport[];
  zeroModes?: ZeroModes;
  /** elastic ones, ascending */
  modes?: ModeReport[];
  solve?: SolveReport;
  fit?: FitReport;
  surface?: SurfaceDistance;
  fidelity?: Fidelity;
  simulation?: SimulationReport;
  calibration?: CalibrationReport[];
  stop?: StopReport;
  levels?: LevelReport[];
  timings: Record<string, number>;
}

/** How far the frequencies of a fitted part are off: the one that is off most, in %. */
export interface FitReport {
  before: number;
  after: number;
  /** why bodies, or parts of them, are not fitted */
  unfitted?: string[];
}

/** What fitReport wants to know of a body: errors of its fitted parts. */
export type FitOfBody = Pick<FittedResult, 'errorBefore' | 'errorAfter' | 'unfitted'>;

/** Young's modulus of an optimized body over the original's, for the original's first ten frequencies. */
export interface CalibrationReport {
  /** its name */
  body: string;
  factor: number;
}

export interface SimulationReport {
  material: SimulationModel;
  scenario: ScenarioName;
  substeps: number;
  original: RunReport;
  optimized?: RunReport;
  /** seconds per step of the original over those of the optimized mesh */
  speedup?: number;
  /** edges of the original over those of the optimized mesh */
  edgeRatio?: number;
  /** of the worst body, in % of its diagonal */
  deviation?: { mean: number; max: number; noiseFloor: number };
}

/** What simulating one side has cost, all its bodies together. */
export interface RunReport {
  constraints: number;
  edges: number;
  /** the shortest step, all work included */
  secondsPerStep: number;
  /** secondsPerStep / (substeps x constraints) */
  nanosecondsPerConstraint: number;
}

export interface SolveReport {
  /** no part was solved by way of a coarse copy */
  exact: boolean;
  /** of the largest coarse copy; absent where exact */
  coarseVertices?: number;
  /** of the largest factor L */
  factorNonzeros: number;
}

export interface MeshReport {
  /** welded, without degenerate faces; duplicate faces still there */
  vertices: number;
  faces: number;
  components: number;
  boundaryLoops: number;
  genus: number | null;
  eulerCharacteristic: number;
  nonManifoldEdges: number;
  nonManifoldVertices: number;
  degenerateFaces: number;
  duplicateFaces: number;
  /** turned so that neighbours agree */
  flippedFaces: number;
  weldedVertices: number;
  /** degrees; absent where there is no usable face */
  minAngle?: number;
  meanMinAngle?: number;
}

export interface ZeroModes {
  expected: number;
  found: number;
}

export interface ComponentReport {
  faces: number;
  model: Model;
  zeroModes: ZeroModes;
}

export interface ModeReport {
  /** rad/s */
  omega: number;
  /** Hz */
  frequency: number;
  residual: number;
  name: ModeName;
  component: number;
  /** laplacian: which principal axis it moves along */
  along?: string;
  /** the model has no physical frequencies: these are only in proportion */
  nominal?: true;
}

export interface StopReport {
  reason: 'target' | 'deviation' | 'angle' | 'frequency' | 'exhausted';
  /** edges left at the floor of the history, each under its first reason */
  refused: Refused;
  /** where frequencies were a target: of the body with the largest error */
  frequency?: FrequencyReport;
}

/** The largest error of the first six frequencies, in %. */
export interface FrequencyReport {
  /** that was asked for */
  limit: number;
  /** that was found */
  error: number;
  /** of the most faces below those found that were over the limit; absent where none were */
  beyond?: Tried;
  /** numbers of faces that were tried, in all bodies */
  tried: number;
}

/** A further level of detail. */
export interface LevelReport {
  /** where it was written */
  file: string;
  /** of the faces of each body, as asked */
  ratio: number;
  output: MeshReport;
  surface: SurfaceDistance;
  stop: StopReport;
}

/** What a mesh report needs to know of one body. */
export interface InspectedBody {
  weld: WeldResult;
  /** of weld.mesh, the usable part */
  inspection: Inspection;
  /** null where no face is usable */
  quality: Quality | null;
}

const AXES = ['shortest', 'middle', 'longest'];

/** The keys that every report has. */
export function startReport(core: Core, command: string, options: object, bodies: InspectedBody[]): Report {
  return {
    schema: 'limber-report/1',
    version: VERSION,
    command,
    options: Object.fromEntries(Object.entries(options).map(([key, value]) => [key, spellInfinity(value)])),
    threads: core.threads,
    peakHeapBytes: core.peakHeapBytes(),
    input: meshReport(bodies),
    timings: {},
  };
}

/** JSON has no infinity. */
const spellInfinity = (value: unknown): unknown => (value === Infinity ? 'inf' : value);

export function meshReport(bodies: InspectedBody[]): MeshReport {
  const sumOf = (key: Exclude<keyof Inspection, 'genus'>) =>
    sum(bodies.map(({ weld }) => weld.inspection[key]));
  const counted = (key: 'degenerateFaces' | 'duplicateFaces' | 'flippedFaces' | 'weldedVertices') =>
    sum(bodies.map(({ weld }) => weld[key]));
  const genera = bodies.map(({ weld }) => weld.inspection.genus);
  return {
    vertices: sumOf('vertices'),
    faces: sumOf('faces'),
    components: sumOf('components'),
    boundaryLoops: sumOf('boundaryLoops'),
    genus: genera.includes(null) ? null : sum(genera as number[]),
    eulerCharacteristic: sumOf('eulerCharacteristic'),
    nonManifoldEdges: sumOf('nonManifoldEdges'),
    nonManifoldVertices: sumOf('nonManifoldVertices'),
    degenerateFaces: counted('degenerateFaces'),
    duplicateFaces: counted('duplicateFaces'),
    flippedFaces: counted('flippedFaces'),
    weldedVertices: counted('weldedVertices'),
    ...angles(bodies),
  };
}

function angles(bodies: InspectedBody[]): Pick<MeshReport, 'minAngle' | 'meanMinAngle'> {
  const usable = bodies.filter(({ quality }) => quality !== null);
  if (usable.length === 0) return {};
  const faces = usable.map(({ weld }) => weld.mesh.triangles.length / 3);
  const weighted = usable.map(({ quality }, i) => quality!.meanMinAngle * faces[i]);
  return {
    minAngle: Math.min(...usable.map(({ quality }) => quality!.minAngle)),
    meanMinAngle: sum(weighted) / sum(faces),
  };
}

/** The keys about vibration: model, components, zeroModes, modes, solve. */
export function modesReport(sets: ModeSet[]) {
  const components: ComponentReport[] = [];
  const modes: ModeReport[] = [];
  // One by one: a file may have more parts than a call can take arguments.
  for (const set of sets) {
    const first = components.length;
    for (const mode of set.modes) modes.push(modeReport(mode, set.components[mode.component].model, first));
    for (const { faces, model, zeroModesExpected, zeroModesFound } of set.components)
      components.push({ faces, model, zeroModes: { expected: zeroModesExpected, found: zeroModesFound } });
  }
  modes.sort((a, b) => a.omega - b.omega || a.component - b.component);
  const models = new Set(components.map(({ model }) => model));
  return {
    model: models.size === 1 ? components[0].model : ('mixed' as const),
    components,
    zeroModes: {
      expected: sum(components.map(({ zeroModes }) => zeroModes.expected)),
      found: sum(components.map(({ zeroModes }) => zeroModes.found)),
    },
    modes,
    solve: solveReport(sets),
  };
}

function solveReport(sets: ModeSet[]): SolveReport {
  const largest = (values: number[]) => values.reduce((most, value) => Math.max(most, value), 0);
  const coarseVertices = largest(sets.map(coarseVerticesOf));
  const factorNonzeros = largest(sets.map((set) => set.factorNonzeros));
  return coarseVertices > 0
    ? { exact: false, coarseVertices, factorNonzeros }
    : { exact: true, factorNonzeros };
}

function modeReport(mode: ModeSet['modes'][number], model: Model, firstComponent: number): ModeReport {
  const { omega, residual, component, axis, name } = mode;
  return {
    omega,
    frequency: omega / (2 * Math.PI),
    residual,
    name,
    component: firstComponent + component,
    ...(axis >= 0 ? { along: AXES[axis] } : {}),
    ...(model === 'laplacian' ? { nominal: true as const } : {}),
  };
}

/** The largest of each distance. */
export function worstSurface(distances: SurfaceDistance[]): SurfaceDistance {
  const largest = (key: keyof SurfaceDistance) => Math.max(...distances.map((distance) => distance[key]));
  return {
    hausdorff: largest('hausdorff'),
    mean: largest('mean'),
    vertexHausdorff: largest('vertexHausdorff'),
  };
}

/** The worst body's fidelity: that with the largest mean frequency error. */
export function worstFidelity(fidelities: Fidelity[]): Fidelity {
  return fidelities.reduce((worst, one) => (one.frequencyErrorMean > worst.frequencyErrorMean ? one : worst));
}

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

/** What resultReport wants to know of a body. */
export interface ReportedBody {
  measured: InspectedBody & { distance: SurfaceDistance };
  /** those that guided it; null without */
  modes: ModeSet | null;
  fitted: FitOfBody;
  stopped: StoppedBody;
}

/** What has become of all bodies: output, the keys about vibration, fit, surface and stop. */
export function resultReport(bodies: ReportedBody[]) {
  const sets = bodies.flatMap(({ modes }) => modes ?? []);
  return {
    output: meshReport(bodies.map(({ measured }) => measured)),
    ...(sets.length > 0 ? modesReport(sets) : {}),
    ...fitReport(bodies.map(({ fitted }) => fitted)),
    surface: worstSurface(bodies.map(({ measured }) => measured.distance)),
    stop: stopReport(bodies.map(({ stopped }) => stopped)),
  };
}

/** Nothing where no body was to be fitted. */
export function fitReport(fits: FitOfBody[]): { fit?: FitReport } {
  const unfitted = [...new Set(fits.map((fit) => fit.unfitted).filter((why) => why !== ''))];
  const worst = (errors: Float64Array[]) => errors.reduce((most, own) => Math.max(most, ...own), 0);
  const [before, after] = [fits.map((fit) => fit.errorBefore), fits.map((fit) => fit.errorAfter)];
  if (unfitted.length === 0 && after.every((errors) => errors.length === 0)) return {};
  return {
    fit: {
      before: worst(before),
      after: worst(after),
      ...(unfitted.length > 0 ? { unfitted } : {}),
    },
  };
}

/** What stopReport wants to know of a body. */
export interface StoppedBody {
  faces: number;
  targetFaces: number;
  history: Pick<History, 'refused' | 'stop'>;
  frequency?: FrequencyFinding | null;
}

/** Why the bodies have as many faces as they have: that of the first one that stopped above its target, or `target`. */
export function stopReport(bodies: StoppedBody[]): StopReport {
  const total = (key: keyof Refused) => sum(bodies.map(({ history }) => history.refused[key]));
  const first = bodies.find(({ faces, targetFaces }) => faces > targetFaces);
  const findings = bodies.flatMap((body) => (body.frequency ? [{ ...body, frequency: body.frequency }] : []));
  return {
    reason: first ? (first.frequency?.isBinding ? 'frequency' : first.history.stop) : 'target',
    refused: {
      topology: total('topology'),
      flip: total('flip'),
      lock: total('lock'),
      angle: total('angle'),
      deviation: total('deviation'),
    },
    ...(findings.length > 0 ? { frequency: frequencyReport(findings) } : {}),
  };
}

function frequencyReport(bodies: { faces: number; frequency: FrequencyFinding }[]): FrequencyReport {
  const worst = bodies.reduce((most, one) => (one.frequency.error > most.frequency.error ? one : most));
  const { limit, error, tried } = worst.frequency;
  const below = tried.filter((one) => one.error > limit && one.faces < worst.faces);
  const beyond = below.reduce<Tried | null>(
    (most, one) => (most && most.faces >= one.faces ? most : one),
    null,
  );
  return {
    limit,
    error,
    ...(beyond ? { beyond } : {}),
    tried: sum(bodies.map(({ frequency }) => frequency.tried.length)),
  };
}

/** Why it stopped above the target, in words: the share of the edges left that each reason holds. */
export function describeRefused(refused: Refused): string {
  const { topology, flip, lock, angle, deviation } = refused;
  const all = topology + flip + lock + angle + deviation;
  if (all === 0) return 'no edge is left that could collapse';
  const share = (count: number) => `${Math.round((100 * count) / all)} %`;
  return [
    `of the remaining edges ${share(topology)} would change the topology`,
    `${share(flip)} flip a face`,
    `${share(lock)} break a seam, a border or a lock`,
    ...(angle > 0 ? [`${share(angle)} make an angle too small`] : []),
    ...(deviation > 0 ? [`${share(deviation)} go too far from the surface`] : []),
  ].join(', ');
}

function sum(values: number[]): number {
  return values.reduce((total, value) => total + value, 0);
}
