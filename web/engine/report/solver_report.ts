/** How closely a result follows its original in a solver, untouched and tuned. */

import type { Fidelity, FrequencyStatus, TunedFrequencies, TunedMotion } from '../core/core';
import { hasFlatTriangles } from '../solvers/mesh_facts';
import { profileOf } from '../solvers/profiles';
import type { SolverName } from '../solvers/profiles';
import type { TunedBody } from '../solvers/tuned_body';
import { knownErrors, worstTuned } from './settings_file';

/** Errors in %, of the body with the largest frequency error; those of modes that it does not have are absent. */
export interface SolverReport {
  frequencies: Partial<TunedFrequencies>;
  /** why there are no frequencies; absent where they were found */
  frequencyStatus?: MissingFrequencies;
  /** present where frequencies alone have decided that the factors stay at 1, without a motion trial */
  kept?: 'untouched';
  /** absent without a motion trial */
  motion?: TunedMotion;
  /** why there was no motion trial, as a clause */
  motionRefusal?: string;
  /** the values of all bodies that the engine does not accept; absent where there are none */
  outOfRange?: OutOfRange[];
  /** the value, of all bodies, at which time steps of the engine become unstable; absent where there is none */
  blowsUp?: BlowsUp;
}

/** `noArea`: triangles of the result have no area. */
type MissingFrequencies = Exclude<FrequencyStatus, 'found'> | 'noArea';

interface OutOfRange {
  name: string;
  value: number;
  /** the range that the engine accepts */
  min: number;
  max: number;
}

interface BlowsUp {
  name: string;
  value: number;
  /** the largest stable value */
  max: number;
}

/** The fidelity part of a report: `compare` fills all of it except `solvers`, a tuning only `solvers`. */
export interface FidelityReport extends Partial<Fidelity> {
  /** why the frequencies of a body are missing, as a sentence; absent if they are known */
  failure?: string;
  solvers?: Partial<Record<SolverName, SolverReport>>;
}

/** The keys of a report about tuned bodies; there must be at least one. */
export function solverReport(bodies: TunedBody[]): {
  schema: 'limber-report/2';
  fidelity: { solvers: NonNullable<FidelityReport['solvers']> };
} {
  const worst = worstTuned(bodies);
  const { solver, tuned } = worst;
  const { frequencies, kept, motion, motionRefusal } = tuned;
  const moved = { ...(motion && { motion }), ...(motionRefusal && { motionRefusal }) };
  const outside = outOfRange(bodies);
  const unsteady = blowsUp(bodies);
  const missing = missingFrequencies(worst);
  const report = {
    frequencies: knownErrors(frequencies),
    ...(missing && { frequencyStatus: missing }),
    ...(!motion && kept === 'untouched' && { kept }),
    ...moved,
    ...(outside.length > 0 && { outOfRange: outside }),
    ...(unsteady && { blowsUp: unsteady }),
  };
  return { schema: 'limber-report/2', fidelity: { solvers: { [solver]: report } } };
}

/** undefined: there are frequencies. */
function missingFrequencies({ mesh, tuned }: TunedBody): MissingFrequencies | undefined {
  const { frequencyStatus } = tuned;
  if (frequencyStatus === 'found') return undefined;
  return frequencyStatus === 'noResistance' && hasFlatTriangles(mesh) ? 'noArea' : frequencyStatus;
}

/** Per parameter the value that is farthest out of range: a material can be stiffer than an engine allows. */
function outOfRange(bodies: TunedBody[]): OutOfRange[] {
  const { parameters } = profileOf(bodies[0].solver);
  return parameters.flatMap(({ name, min, max }): OutOfRange[] => {
    const values = bodies.flatMap(({ original, result }) => [original.values[name], result.values[name]]);
    const [least, most] = [Math.min(...values), Math.max(...values)];
    if (most > max) return [{ name, value: most, min, max }];
    return least < min ? [{ name, value: least, min, max }] : [];
  });
}

/** For the mesh, original or result, that exceeds the largest stable value most; undefined where none does. */
function blowsUp(bodies: TunedBody[]): BlowsUp | undefined {
  const { stepLimit } = profileOf(bodies[0].solver);
  if (!stepLimit) return undefined;
  const { name, most } = stepLimit;
  const beyond = bodies
    .flatMap(({ original, result }) => [original.values, result.values])
    .map((values) => ({ name, value: values[name], max: most(values) }))
    .filter(({ value, max }) => value > max);
  return beyond.sort((a, b) => b.value / b.max - a.value / a.max)[0];
}

const percentOf = (value: number): string => `${value.toFixed(value < 0.1 ? 3 : 2)} %`;

/** Sentences without their full stops about the outcome of a tuning, for the terminal and the page. */
export function describeTuning(
  solver: SolverName,
  { frequencies, frequencyStatus, kept, motion, motionRefusal, outOfRange = [], blowsUp }: SolverReport,
): string[] {
  const why = motionRefusal === undefined ? '' : `: ${motionRefusal}`;
  const moved = motion ? describeMotion(motion) : `the motion itself was not tested${why}`;
  const beyond = outOfRange.map((parameter) => describeOutOfRange(solver, parameter));
  const errors = describeFrequencies(solver, frequencies, frequencyStatus);
  return [
    errors,
    ...(kept ? [WITHDRAWN] : []),
    moved,
    ...beyond,
    ...(blowsUp ? [describeBlowsUp(solver, blowsUp)] : []),
  ];
}

const WITHDRAWN =
  "a tuned stiffness would take the frequencies farther away on average, so the file keeps the original's and transfers its masses";

const MISSING: Record<MissingFrequencies, string> = {
  noResistance: 'this shape bends without resistance',
  noArea: 'this shape has no modes because of triangles without area',
  noConvergence: 'the modes of this shape do not converge',
};

function describeOutOfRange(solver: SolverName, { name, value, min, max }: OutOfRange): string {
  const limit = value > max ? `at most ${numberOf(max)}` : `at least ${numberOf(min)}`;
  return `${profileOf(solver).label} takes a ${name} of ${limit}, and this needs ${numberOf(value)}: choose another material or thickness, or give your own numbers`;
}

function describeBlowsUp(solver: SolverName, { name, value, max }: BlowsUp): string {
  const { label, stepLimit } = profileOf(solver);
  return `${label} can blow up with a ${name} of ${numberOf(value)}: keep it below ${numberOf(max)}, which is ${stepLimit!.words}`;
}

const numberOf = (value: number): string => value.toLocaleString('en-US', { maximumSignificantDigits: 3 });

function describeFrequencies(
  solver: SolverName,
  { errorUntouched, errorTuned, errorUnseen }: Partial<TunedFrequencies>,
  missing: MissingFrequencies = 'noResistance',
): string {
  const { label } = profileOf(solver);
  if (errorUntouched === undefined || errorTuned === undefined)
    return `in ${label} ${MISSING[missing]}, so there are no frequencies to tune: only masses are tuned, and the factors stay at 1`;
  const unseen = errorUnseen === undefined ? '' : ` (${percentOf(errorUnseen)} in modes that were not tuned)`;
  return `in ${label} the first ten frequencies are off by ${percentOf(errorTuned)} tuned${unseen}, by ${percentOf(errorUntouched)} with the original's numbers`;
}

const SCENES: Record<string, string> = {
  sway: 'when it sways,',
  hang: 'when it hangs,',
  'sway and hang': 'when it sways and hangs,',
};

function describeMotion({ scene, untouched, tuned, noiseFloor, kept }: TunedMotion): string {
  const told = `${SCENES[scene] ?? scene} it deviates from the original by ${percentOf(tuned)} of its size tuned, by ${percentOf(untouched)} with the original's stiffness and masses (noise ${percentOf(noiseFloor)})`;
  return kept === 'tuned'
    ? told
    : `${told}, so the file keeps the original's stiffness and transfers its masses`;
}
