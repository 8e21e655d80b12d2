/** The settings file: what a solver needs to move an optimized mesh as it moves the original. See docs/formats.md. */

import type { EngineMaterial } from '../body/material';
import type { Fidelity, MassRule, TunedFrequencies, TunedMotion, TuneKind } from '../core/core';
import { VERSION } from '../core/version';
import type { ExportedSettings } from '../document/export';
import type { OwnSpace } from '../document/model';
import { engineValues } from '../settings/engine_text';
import type { Settings } from '../settings/options';
import { totalMass, valueOfRole } from '../solvers/profile';
import type { NativeValues, Role } from '../solvers/profile';
import { profileOf } from '../solvers/profiles';
import type { SolverName } from '../solvers/profiles';
import type { TunedBody } from '../solvers/tuned_body';

export const SETTINGS_SCHEMA = 'limber-settings/1';

/** The stiffness of constraint c is constant * factors[c]; factor 1 where there are none. */
interface ConstraintSettings {
  constant: number;
  /** i, j for each spring */
  pairs?: number[];
  factors?: number[];
}

export interface StretchSettings extends ConstraintSettings {
  /** Lame's lambda times the thickness; `constant` then is mu times the thickness */
  second?: number;
  /** the constraints are the triangles of `mesh` */
  triangles?: true;
}

export interface BendSettings extends ConstraintSettings {
  /** i, j, k, l for each hinge: its edge, then the opposite corners */
  hinges?: number[];
}

type RoleValues = Partial<Record<Role, number>>;

export interface BodySettings extends RoleValues {
  name: string;
  /** 0, or the number of the further level */
  level: number;
  /** the index of the mesh in the glTF file that contains it, for a further level its own file or that of the first level; absent in files of the first versions */
  meshNumber?: number;
  /** metres per unit of the mesh */
  unit: number;
  mesh: { positions: number[]; triangles: number[] };
  /** per vertex of each primitive of the file, in order: the vertex of `mesh`; -1 where no usable face has it */
  renderVertices: number[];
  /** `original`: the mass rule of the original; absent in files of the first versions */
  mass: { rule: MassRule; original?: MassRule; perVertex: number[] };
  /** factors per vertex */
  vertex?: { stretch: number[]; bend: number[] };
  stretch: StretchSettings;
  bend: BendSettings;
  pins: number[];
  /** values to type into the engine for this mesh */
  engine: NativeValues;
  original: OriginalSettings;
  frequencies: Partial<TunedFrequencies>;
  motion?: TunedMotion;
}

/** The values typed in for the original, and the constants that follow from them. */
export type OriginalSettings = {
  vertices: number;
  faces: number;
  totalMass: number;
  stretch: number;
  bend: number;
} & NativeValues;

export interface SettingsFile {
  schema: typeof SETTINGS_SCHEMA;
  version: string;
  solver: SolverName;
  /** how well the solver model has been checked against the engine: generic, verified or derived */
  status: string;
  tune: TuneKind;
  /** `length`: metres per unit of the first body */
  units: { length: number };
  /** of the first body, like everything outside of `bodies` */
  engine: NativeValues;
  original: OriginalSettings;
  /** as set; `thickness` in % of each body's diagonal. Absent in files of the first versions */
  material?: EngineMaterial;
  /** names of the parameters of `original` that the user gave; the others were derived. Absent in files of the first versions */
  given?: string[];
  bodies: BodySettings[];
  /** of the first-level body with the largest frequency error */
  frequencies: Partial<TunedFrequencies>;
  motion?: TunedMotion;
}

/** A tuned body of a written file. */
export interface TunedEntry {
  name: string;
  level: number;
  /** see BodySettings */
  meshNumber: number;
  renderVertices: number[];
  tuned: TunedBody;
  /** of a mesh that was tuned in the space of another one: its original space, that of its file */
  own?: OwnSpace;
}

/** The content of the file; `bodies` are those of the first level, then those of the others; there must be at least one. */
export function settingsFile(
  bodies: TunedEntry[],
  settings: EngineMaterial & Pick<Settings, 'engine'>,
): SettingsFile {
  const { young, poisson, density, thickness, bendRatio } = settings;
  const { solver, tune } = bodies[0].tuned;
  const entries = bodies.map(bodySettings);
  const [{ engine, original, unit }] = entries;
  const worst = worstTuned(firstLevel(bodies).map((body) => body.tuned));
  return {
    schema: SETTINGS_SCHEMA,
    version: VERSION,
    solver,
    status: profileOf(solver).status,
    tune,
    units: { length: unit },
    engine,
    original,
    material: { young, poisson, density, thickness, bendRatio },
    given: Object.keys(engineValues(solver, settings.engine)),
    bodies: entries,
    frequencies: shortened(knownErrors(worst.tuned.frequencies)),
    ...motionOf(worst),
  };
}

/** The bodies of the first level. */
export const firstLevel = <Body extends { level: number }>(bodies: Body[]): Body[] =>
  bodies.filter(({ level }) => level === bodies[0].level);

/** The body with the largest tuned frequency error, the first of equal ones. */
export const worstTuned = (bodies: TunedBody[]): TunedBody =>
  bodies.reduce((worst, one) => (tunedError(one) > tunedError(worst) ? one : worst));

/** The tuned frequency error; a body without modes has the smallest. */
const tunedError = ({ tuned }: TunedBody): number =>
  Number.isFinite(tuned.frequencies.errorTuned) ? tuned.frequencies.errorTuned : -1;

const motionOf = ({ tuned: { motion } }: TunedBody): { motion?: TunedMotion } =>
  motion ? { motion: shortened(motion) } : {};

export function bodySettings(entry: TunedEntry): BodySettings {
  const { name, level, meshNumber, renderVertices, tuned: body, own } = entry;
  const { tuned, result } = body;
  const { positions, scale } = own ?? { positions: body.mesh.positions, scale: 1 };
  const hasMaps = tuned.stretchField.length > 0;
  return {
    ...{ name, level, meshNumber, unit: scale * result.constants.unit },
    mesh: { positions: list(positions), triangles: [...body.mesh.triangles] },
    renderVertices,
    mass: { rule: body.massRule, original: body.model.mass, perVertex: list(tuned.masses) },
    ...(hasMaps ? { vertex: { stretch: list(tuned.stretchField), bend: list(tuned.bendField) } } : {}),
    stretch: stretchSettings(body),
    bend: bendSettings(body),
    pins: [...body.pins],
    ...roleValues(body),
    engine: shortened(result.values),
    original: originalSettings(body),
    frequencies: shortened(knownErrors(tuned.frequencies)),
    ...motionOf(body),
  };
}

function stretchSettings({ tuned, model, result: { constants } }: TunedBody): StretchSettings {
  const isNet = model.stretch === 'edge-springs';
  return {
    constant: short(constants.stretch),
    ...(isNet ? {} : { second: short(constants.secondStretch) }),
    ...(isNet ? { pairs: [...tuned.stretchVertices] } : { triangles: true as const }),
    ...factorsOf(tuned.stretchFactors),
  };
}

function bendSettings({ tuned, model, result: { constants } }: TunedBody): BendSettings {
  const vertices = [...tuned.bendVertices];
  return {
    constant: short(constants.bend),
    ...(model.bend === 'cross-springs' ? { pairs: vertices } : { hinges: vertices }),
    ...factorsOf(tuned.bendFactors),
  };
}

const factorsOf = (factors: Float64Array): { factors?: number[] } =>
  factors.length > 0 ? { factors: list(factors) } : {};

const ROLES = ['damping', 'air', 'collisionThickness', 'friction', 'selfCollisionDistance'] as const;

/** Damping, contacts and substeps, if the engine has them. */
function roleValues({ solver, substeps, result: { values } }: TunedBody): RoleValues {
  const profile = profileOf(solver);
  const found = ROLES.map((role) => [role, valueOfRole(profile, values, role)] as const);
  const entries = [['substeps', substeps ?? undefined] as const, ...found];
  return Object.fromEntries(
    entries.flatMap(([role, value]) => (value === undefined ? [] : [[role, short(value)]])),
  );
}

function originalSettings({ original: { facts, constants, values } }: TunedBody): OriginalSettings {
  return shortened({
    vertices: facts.vertices,
    faces: facts.faces,
    totalMass: totalMass(constants, facts),
    stretch: constants.stretch,
    bend: constants.bend,
    ...values,
  });
}

/** Nine digits: enough to give a float32 back, and few enough to read. */
const short = (value: number): number => Number(value.toPrecision(9));
const list = (values: Float32Array | Float64Array): number[] => Array.from(values, short);
const shortened = <T extends object>(values: T): T =>
  Object.fromEntries(
    Object.entries(values).map(([key, value]) => [key, typeof value === 'number' ? short(value) : value]),
  ) as T;

/** Errors without those of modes that a body does not have. */
export const knownErrors = <Errors extends TunedFrequencies | Partial<Fidelity>>(
  errors: Errors,
): Partial<Errors> =>
  Object.fromEntries(Object.entries(errors).filter(([, error]) => Number.isFinite(error))) as Partial<Errors>;

/** The settings of a body as a GLB stores them: numbers in the extras of its mesh, values per vertex as attributes. */
export function exportedSettings(tuned: TunedBody): ExportedSettings {
  const { masses, stretchField, bendField } = tuned.tuned;
  const maps = { _LIMBER_STRETCH: stretchField, _LIMBER_BEND: bendField };
  return {
    extras: settingsExtras(tuned),
    attributes: {
      _LIMBER_MASS: Float32Array.from(masses),
      ...Object.fromEntries(
        Object.entries(maps)
          .filter(([, field]) => field.length > 0)
          .map(([semantic, field]) => [semantic, Float32Array.from(field)]),
      ),
    },
  };
}

/** The settings of a body without lists. */
function settingsExtras(tuned: TunedBody): object {
  const { solver, tune, massRule, model, result } = tuned;
  const { stretch, secondStretch, bend, unit } = result.constants;
  const isNet = model.stretch === 'edge-springs';
  return {
    ...{ schema: SETTINGS_SCHEMA, version: VERSION, solver, tune, unit },
    mass: { rule: massRule },
    stretch: { constant: short(stretch), ...(isNet ? {} : { second: short(secondStretch) }) },
    bend: { constant: short(bend) },
    ...roleValues(tuned),
    engine: shortened(result.values),
    original: originalSettings(tuned),
    frequencies: shortened(knownErrors(tuned.tuned.frequencies)),
    ...motionOf(tuned),
  };
}

/** The text of the file: an entry a line, lists of numbers in one. */
export const writeSettings = (file: SettingsFile): string => `${spell(file, '')}\n`;

function spell(value: unknown, indent: string): string {
  if (value === null || typeof value !== 'object') return JSON.stringify(value);
  const deeper = `${indent} `;
  if (Array.isArray(value)) {
    if (value.every((entry) => typeof entry === 'number')) return `[${value.join(',')}]`;
    return `[\n${value.map((entry) => deeper + spell(entry, deeper)).join(',\n')}\n${indent}]`;
  }
  const lines = Object.entries(value).map(
    ([key, inner]) => `${deeper}${JSON.stringify(key)}: ${spell(inner, deeper)}`,
  );
  return lines.length === 0 ? '{}' : `{\n${lines.join(',\n')}\n${indent}}`;
}
