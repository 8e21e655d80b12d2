/**
 * The one place of every setting: its default, range, unit, words and flag. Sliders, command-line flags and range checks
 * are made from it.
 */

import type { Method, Model, SimulationOptions } from '../core/core';
import { describeScenarios, SCENARIO_NAMES } from '../core/scenarios';
import { counted } from '../core/words';
import { checkOption } from './option_check';

/** Settings of a simulation that go to the core as they are. */
type SimulationSetting = 'material' | 'scenario' | 'seconds' | 'substeps' | 'damping' | 'selfCollision';

/** Everything the user wants, in the words of the flags; plain data that can be stored and sent. */
export interface Settings extends Pick<SimulationOptions, SimulationSetting> {
  method: Method;
  /** 'auto': what suits the method, see `resolveModel` */
  model: 'auto' | Model;
  /** elastic modes computed per component */
  modeCount: number;
  /** which elastic modes guide, from 1; 'auto': see `resolveModes` */
  modes: 'auto' | 'all' | number[];
  /** w_k of Eq. 6, one per guiding mode; empty: 1 / omega_k^2 */
  modeWeights: number[];
  /** p of Eq. 6, in [1, Infinity] */
  p: number;
  strainThreshold: number;
  /** laplacian: the axis that modes move along; 'all': each principal axis in turn */
  direction: 'all' | 'x' | 'y' | 'z';
  /** what is held in place, see pins.ts; '' for nothing */
  pins: string;
  /** solve large shells as they are, not on a decimated copy */
  exact: boolean;
  /** alpha of Eq. 11; w of limber */
  strainWeight: number;
  /** beta of Eq. 11 */
  curvatureWeight: number;
  /** gamma of Eq. 11; g of limber */
  qualityWeight: number;
  /** s of limber, and beside E_QEM in qem */
  sizeWeight: number;
  /** limber: move vertices after the collapses so that frequencies are kept */
  fit: 'on' | 'off';
  /** how far the surface may move, % of the diagonal; 0: no limit */
  maxDeviation: number;
  /** degrees; 0: no limit */
  minAngle: number;
  /** of each of the first six modes, in %; 0: no limit */
  maxFrequencyError: number;
  /** shares of the faces, in (0, 1], of further levels; empty: none */
  lods: number[];
  borders: 'free' | 'fixed';
  /** whether collapses go across texture seams and hard edges */
  seams: 'keep' | 'cross';
  /** the axis across which the mesh is mirrored; 'on': whichever it is */
  symmetry: 'off' | 'on' | 'x' | 'y' | 'z';
  /** edges that bend more stay, degrees; 0: none */
  creases: number;
  /** the attribute whose first component, in [0, 1], says where triangles are kept; '' for none */
  keep: string;
  /** which vertices stay as they are, in the words of pins.ts; '' for none */
  lock: string;
  /** keep weights and locks that a brush has painted, see paint.ts; '' for none */
  paint: string;
  /** Pa */
  young: number;
  poisson: number;
  /** kg/m3 */
  density: number;
  /** % of the body's bounding-box diagonal */
  thickness: number;
  /** metres per unit of the file */
  unit: number;
  /** see colliders.ts; '': what the scenario has by itself */
  colliders: string;
  friction: number;
  /** give the optimized body the Young's modulus that matches the original's first frequencies */
  calibrate: boolean;
  /** welding distance, % of the diagonal; 0: bitwise equal positions only */
  weld: number;
  /** 0: as many as there are cores, at most 8 */
  threads: number;
}

export type OptionGroup = 'target' | 'method' | 'motion' | 'material' | 'simulation' | 'common';

/**
 * How a setting is written: `choice` one of `choices`; `integer` and `number` within [min, max]; `modes` auto, all or a
 * list of integers; `numbers` a list within [min, max] each; `pins` as pins.ts says; `paint` as paint.ts says; `colliders`
 * as colliders.ts says; `name` any text; `switch` on or off.
 */
export type OptionKind =
  'choice' | 'integer' | 'number' | 'modes' | 'numbers' | 'pins' | 'paint' | 'colliders' | 'name' | 'switch';

export interface OptionSpec {
  /** without the dashes */
  flag: string;
  label: string;
  unit?: string;
  /** smallest value that is accepted; of a list, of each entry */
  min: number;
  max: number;
  /** a slider's step, and its span where the whole range would be useless */
  step: number;
  slider?: { min: number; max: number };
  default: Settings[keyof Settings];
  /** of a list: what it stands for while it is empty, where that is not nothing */
  emptyMeans?: string;
  /** one sentence */
  help: string;
  group: OptionGroup;
  kind: OptionKind;
  choices?: readonly string[];
}

const none = { min: 0, max: 0, step: 0 };

export const OPTIONS: Record<keyof Settings, OptionSpec> = {
  method: {
    flag: 'method',
    label: 'Method',
    ...none,
    default: 'limber',
    help: 'How the next edge is chosen: limber (shape, size, quality and strain, then a fit to the modes), paper (strain, curvature and shape, Eq. 11) or qem (area-weighted quadrics alone).',
    group: 'method',
    kind: 'choice',
    choices: ['limber', 'paper', 'qem'],
  },
  strainWeight: {
    flag: 'strain-weight',
    label: 'Keep where it bends',
    min: 0,
    max: 1000,
    step: 0.01,
    slider: { min: 0, max: 10 },
    default: 1,
    help: 'Weight of the strain rank in the cost of an edge (for paper alpha of Eq. 11: 0.05).',
    group: 'method',
    kind: 'number',
  },
  curvatureWeight: {
    flag: 'curvature-weight',
    label: 'Keep the shape',
    min: 0,
    max: 1000,
    step: 0.05,
    slider: { min: 0, max: 5 },
    default: 1,
    help: 'Paper only: weight of the curvature in the cost of an edge (beta of Eq. 11).',
    group: 'method',
    kind: 'number',
  },
  qualityWeight: {
    flag: 'quality-weight',
    label: 'Even triangles',
    min: 0,
    max: 1000,
    step: 0.005,
    slider: { min: 0, max: 0.5 },
    default: 0.1,
    help: 'Weight of the triangle shape in the cost of an edge (for paper gamma of Eq. 11: 0.01).',
    group: 'method',
    kind: 'number',
  },
  sizeWeight: {
    flag: 'size-weight',
    label: 'Even sizes',
    min: 0,
    max: 1000,
    step: 0.001,
    slider: { min: 0, max: 0.1 },
    default: 0.01,
    help: 'Weight of the squared length of an edge in its cost (not for paper; 0 for qem).',
    group: 'method',
    kind: 'number',
  },
  fit: {
    flag: 'fit',
    label: 'Fit to the modes',
    ...none,
    default: 'on',
    help: 'Limber only: after the collapses, move vertices a little so that the result vibrates like the original.',
    group: 'method',
    kind: 'choice',
    choices: ['on', 'off'],
  },
  maxDeviation: {
    flag: 'max-deviation',
    label: 'Largest deviation',
    unit: '% of the diagonal',
    min: 0,
    max: 100,
    step: 0.01,
    slider: { min: 0, max: 5 },
    default: 0,
    help: 'Stop before collapses take the surface farther than this from the original, in % of the diagonal; 0 sets no limit.',
    group: 'target',
    kind: 'number',
  },
  minAngle: {
    flag: 'min-angle',
    label: 'Smallest angle',
    unit: 'degrees',
    min: 0,
    max: 60,
    step: 1,
    slider: { min: 0, max: 40 },
    default: 0,
    help: 'Stop before collapses make an angle smaller than this, where the input has none; 0 sets no limit.',
    group: 'target',
    kind: 'number',
  },
  maxFrequencyError: {
    flag: 'max-frequency-error',
    label: 'Largest frequency error',
    unit: '%',
    min: 0,
    max: 100,
    step: 0.1,
    slider: { min: 0, max: 10 },
    default: 0,
    help: 'Keep as few faces as leave each of the first six frequencies within this of the original, in %; 0 sets no limit.',
    group: 'target',
    kind: 'number',
  },
  lods: {
    flag: 'lods',
    label: 'Further levels',
    min: 0.0001,
    max: 1,
    step: 0.01,
    default: [],
    help: 'Further levels of detail, one file each (OUT_lod1.glb, ...), with these shares of the faces of each body.',
    group: 'target',
    kind: 'numbers',
  },
  borders: {
    flag: 'borders',
    label: 'Open borders',
    ...none,
    default: 'free',
    help: 'Vertices of open borders slide along them (free) or stay where they are (fixed).',
    group: 'method',
    kind: 'choice',
    choices: ['free', 'fixed'],
  },
  seams: {
    flag: 'seams',
    label: 'Seams',
    ...none,
    default: 'keep',
    help: 'Texture seams and hard edges stay closed and in place (keep), or collapses go across them (cross): for meshes whose every face has a piece of the texture to itself, at the cost of breaks in it. Not for paper, which always crosses them.',
    group: 'method',
    kind: 'choice',
    choices: ['keep', 'cross'],
  },
  symmetry: {
    flag: 'symmetry',
    label: 'Symmetry',
    ...none,
    default: 'off',
    help: 'Keep the mirror symmetry of a mesh across x, y or z, through its centre, or whichever it has (on).',
    group: 'method',
    kind: 'choice',
    choices: ['off', 'on', 'x', 'y', 'z'],
  },
  creases: {
    flag: 'creases',
    label: 'Creases',
    unit: 'degrees',
    min: 0,
    max: 180,
    step: 1,
    slider: { min: 0, max: 90 },
    default: 0,
    help: 'Edges that bend by more than this stay edges, in degrees; 0 keeps none.',
    group: 'method',
    kind: 'number',
  },
  keep: {
    flag: 'keep',
    label: 'Keep triangles where',
    ...none,
    default: '',
    help: 'Name of an attribute whose first component (0 to 1) says where triangles are kept: a collapse costs up to 100 times as much.',
    group: 'method',
    kind: 'name',
  },
  lock: {
    flag: 'lock',
    label: 'Locked vertices',
    ...none,
    default: '',
    help: 'Vertices that stay as they are, in the words of --pins.',
    group: 'method',
    kind: 'pins',
  },
  paint: {
    flag: 'paint',
    label: 'Painted',
    ...none,
    default: '',
    help: 'Where triangles are kept and vertices locked, as the brush of the page writes it.',
    group: 'method',
    kind: 'paint',
  },
  model: {
    flag: 'model',
    label: 'Model',
    ...none,
    default: 'auto',
    help: 'What resists deformation: shell (membrane and bending), solid (the inside), laplacian (unit springs), or auto: solid where a part is closed, shell where it is open; laplacian for the paper.',
    group: 'motion',
    kind: 'choice',
    choices: ['auto', 'shell', 'solid', 'laplacian'],
  },
  modeCount: {
    flag: 'modes',
    label: 'Modes to compute',
    min: 1,
    max: 100,
    step: 1,
    slider: { min: 1, max: 30 },
    default: 12,
    help: 'How many elastic modes are computed for each part.',
    group: 'motion',
    kind: 'integer',
  },
  modes: {
    flag: 'mode',
    label: 'Modes that guide',
    min: 1,
    max: 100,
    step: 1,
    default: 'auto',
    help: 'Which elastic modes guide: numbers from 1 with commas, all, or auto (the first six; for the paper the first).',
    group: 'motion',
    kind: 'modes',
  },
  modeWeights: {
    flag: 'mode-weights',
    label: 'Weights of the modes',
    min: 0,
    max: 1e6,
    step: 0.01,
    default: [],
    emptyMeans: '1 / omega^2',
    help: 'One weight for each guiding mode (w of Eq. 6); without it 1 / omega^2.',
    group: 'motion',
    kind: 'numbers',
  },
  p: {
    flag: 'p',
    label: 'Norm over the modes',
    min: 1,
    max: Infinity,
    step: 1,
    slider: { min: 1, max: 16 },
    default: 2,
    help: 'How the modes add up (p of Eq. 6): 1 sums, 2 is Euclidean, inf takes the largest.',
    group: 'motion',
    kind: 'number',
  },
  strainThreshold: {
    flag: 'strain-threshold',
    label: 'Strain that counts',
    min: 0,
    max: 1,
    step: 0.01,
    default: 0,
    help: 'Strain ranks below this do not count.',
    group: 'motion',
    kind: 'number',
  },
  direction: {
    flag: 'direction',
    label: 'Direction',
    ...none,
    default: 'all',
    help: 'Laplacian only: the axis that the modes move along, x, y or z; all takes each principal axis in turn.',
    group: 'motion',
    kind: 'choice',
    choices: ['all', 'x', 'y', 'z'],
  },
  pins: {
    flag: 'pins',
    label: 'Held in place',
    ...none,
    default: '',
    help: 'What is held in place: low:PCT, high:PCT (ends of the longest axis), box:x0,y0,z0,x1,y1,z1, attribute:NAME, vertices:i,j, joined by +.',
    group: 'motion',
    kind: 'pins',
  },
  exact: {
    flag: 'exact',
    label: 'Solve the mesh itself',
    ...none,
    default: false,
    help: 'Solve shells of more than 8,000 vertices as they are, not by way of a decimated copy.',
    group: 'motion',
    kind: 'switch',
  },
  young: {
    flag: 'young',
    label: "Young's modulus",
    unit: 'Pa',
    min: 1,
    max: 1e12,
    step: 1e5,
    slider: { min: 1e4, max: 1e10 },
    default: 1e6,
    help: 'Stiffness of the material.',
    group: 'material',
    kind: 'number',
  },
  poisson: {
    flag: 'poisson',
    label: "Poisson's ratio",
    min: -0.99,
    max: 0.49,
    step: 0.01,
    slider: { min: 0, max: 0.49 },
    default: 0.3,
    help: 'How much the material narrows when it is stretched.',
    group: 'material',
    kind: 'number',
  },
  density: {
    flag: 'density',
    label: 'Density',
    unit: 'kg/m3',
    min: 1e-3,
    max: 1e5,
    step: 10,
    slider: { min: 10, max: 8000 },
    default: 1000,
    help: 'Mass of a cubic metre of the material.',
    group: 'material',
    kind: 'number',
  },
  thickness: {
    flag: 'thickness',
    label: 'Thickness',
    unit: '% of the diagonal',
    min: 0.001,
    max: 50,
    step: 0.1,
    slider: { min: 0.01, max: 10 },
    default: 2,
    help: 'Thickness of the shell in % of the diagonal of the body.',
    group: 'material',
    kind: 'number',
  },
  unit: {
    flag: 'unit',
    label: 'One unit of the file',
    unit: 'm',
    min: 1e-6,
    max: 1e6,
    step: 0.001,
    slider: { min: 0.001, max: 1 },
    default: 1,
    help: 'Length of one unit of the file in metres; it changes frequencies, not the mesh.',
    group: 'material',
    kind: 'number',
  },
  scenario: {
    flag: 'scenario',
    label: 'Scenario',
    ...none,
    default: 'twist',
    help: `What happens: ${describeScenarios()}.`,
    group: 'simulation',
    kind: 'choice',
    choices: [...SCENARIO_NAMES],
  },
  material: {
    flag: 'material',
    label: 'Simulated as',
    ...none,
    default: 'shell',
    help: 'What the simulation is made of: shell (membrane and bending, the same on any mesh) or springs (the edges, as in the paper).',
    group: 'simulation',
    kind: 'choice',
    choices: ['shell', 'springs'],
  },
  seconds: {
    flag: 'seconds',
    label: 'Duration',
    unit: 's',
    min: 0.02,
    max: 600,
    step: 0.1,
    slider: { min: 0.5, max: 10 },
    default: 2,
    help: 'Length of the simulated motion.',
    group: 'simulation',
    kind: 'number',
  },
  substeps: {
    flag: 'substeps',
    label: 'Substeps',
    min: 1,
    max: 10000,
    step: 1,
    slider: { min: 1, max: 2000 },
    default: 20,
    help: 'Substeps of a step of 1/60 s; more make stiff or fine meshes more exact (the paper takes 2,000).',
    group: 'simulation',
    kind: 'integer',
  },
  damping: {
    flag: 'damping',
    label: 'Damping',
    unit: '1/s',
    min: 0,
    max: 100,
    step: 0.1,
    slider: { min: 0, max: 10 },
    default: 0.5,
    help: 'How fast motion dies away by itself.',
    group: 'simulation',
    kind: 'number',
  },
  selfCollision: {
    flag: 'self-collision',
    label: 'Touches itself',
    ...none,
    default: false,
    help: 'Sheets push each other away where they meet, for cloth of even triangles; slower.',
    group: 'simulation',
    kind: 'switch',
  },
  colliders: {
    flag: 'colliders',
    label: 'Can touch',
    ...none,
    default: '',
    help: 'What both bodies can touch besides what the scenario has, in units of the body: ground:HEIGHT (across y), ball:x,y,z,R, capsule:x0,y0,z0,x1,y1,z1,R, joined by +.',
    group: 'simulation',
    kind: 'colliders',
  },
  friction: {
    flag: 'friction',
    label: 'Friction',
    min: 0,
    max: 10,
    step: 0.05,
    slider: { min: 0, max: 1 },
    default: 0.5,
    help: 'Against the ground and colliders: the share of the pressing force that holds what slides.',
    group: 'simulation',
    kind: 'number',
  },
  calibrate: {
    flag: 'calibrate',
    label: 'Calibrated',
    ...none,
    default: false,
    help: 'Measure the one factor on the stiffness of the optimized mesh that gives it the first ten frequencies of the original (as shells), and use it.',
    group: 'simulation',
    kind: 'switch',
  },
  weld: {
    flag: 'weld',
    label: 'Weld distance',
    unit: '% of the diagonal',
    min: 0,
    max: 10,
    step: 0.001,
    slider: { min: 0, max: 0.1 },
    default: 0,
    help: 'Vertices closer than this become one, in % of the diagonal; 0 joins equal positions only.',
    group: 'common',
    kind: 'number',
  },
  threads: {
    flag: 'threads',
    label: 'Threads',
    min: 0,
    max: 32,
    step: 1,
    slider: { min: 0, max: 8 },
    default: 0,
    help: 'Threads to use; 0 takes all cores, at most 8. The result does not depend on it.',
    group: 'common',
    kind: 'integer',
  },
};

const keys = Object.keys(OPTIONS) as (keyof Settings)[];

/** The weights that a method starts with; those of limber are the defaults of OPTIONS. */
const METHOD_WEIGHTS: Record<Exclude<Method, 'limber'>, Partial<Settings>> = {
  paper: { strainWeight: 0.05, curvatureWeight: 1, qualityWeight: 0.01, sizeWeight: 0 },
  qem: { sizeWeight: 0 },
};

/** A fresh copy of a method's defaults. */
export function defaultSettings(method: Method = 'limber'): Settings {
  const entries = keys.map((key) => [key, structuredClone(OPTIONS[key].default)]);
  const settings = Object.fromEntries(entries) as unknown as Settings;
  return { ...settings, method, ...(method === 'limber' ? {} : METHOD_WEIGHTS[method]) };
}

/** What changes with the method: itself, and its weights. */
export function methodChange(method: Method): Partial<Settings> {
  const { strainWeight, curvatureWeight, qualityWeight, sizeWeight } = defaultSettings(method);
  return { method, strainWeight, curvatureWeight, qualityWeight, sizeWeight };
}

/** Whether results are fitted to the original's modes. */
export const isFitted = ({ method, fit }: Settings): boolean => method === 'limber' && fit === 'on';

/** Throws one sentence that names the flag, its range and the cure. */
export function checkSettings(settings: Settings): void {
  for (const key of keys) checkOption(OPTIONS[key], settings[key]);
  const { modes, modeCount, modeWeights } = settings;
  const highest = Array.isArray(modes) ? Math.max(...modes) : 0;
  if (highest > modeCount) {
    const cure = `raise --modes to ${highest} or name lower modes`;
    throw new Error(`--mode names mode ${highest}, but --modes computes only ${modeCount}: ${cure}.`);
  }
  const guiding = resolveModes(settings).length;
  if (modeWeights.length > 0 && modeWeights.length !== guiding)
    throw new Error(
      `--mode-weights has ${counted(modeWeights.length, 'number')} for ${counted(guiding, 'guiding mode')}: give one for each mode of --mode.`,
    );
}

/** The model that guides: as asked; otherwise the paper's own for the paper's method, and what suits each part. */
export function resolveModel(settings: Settings): 'auto' | Model {
  if (settings.model !== 'auto') return settings.model;
  return settings.method === 'paper' ? 'laplacian' : 'auto';
}

/** The elastic modes that guide, from 1: `auto` is the first for the paper's method and otherwise the first six. */
export function resolveModes(settings: Settings): number[] {
  const { modes, modeCount, method } = settings;
  if (Array.isArray(modes)) return modes;
  const auto = method === 'paper' ? 1 : Math.min(6, modeCount);
  return Array.from({ length: modes === 'all' ? modeCount : auto }, (_, index) => index + 1);
}
