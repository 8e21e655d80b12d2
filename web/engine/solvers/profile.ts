/**
 * An engine profile: the parameters that a user types into an engine, and the constants that follow in a solver model
 * (wasm/elastic/solvers). A profile is one file in this folder and one row of profiles.ts.
 */

import type { MassRule, SolverConstants, SolverModel } from '../core/core';
import type { MeshFacts } from './mesh_facts';

/** Native parameters by name, as typed into the engine. */
export type NativeValues = Readonly<Record<string, number>>;

/** The change from the original to the coarse mesh; each field is the coarse mesh's value over the original's. */
export interface Change {
  /** of the mean edge */
  edge: number;
  /** of the number of vertices */
  vertices: number;
  /** of the constants of the solver, tuning included */
  stretch: number;
  bend: number;
}

/** The meaning of a native parameter, by which loaders find it without knowing the engine. */
export type Role =
  'damping' | 'air' | 'substeps' | 'collisionThickness' | 'friction' | 'selfCollisionDistance';

export interface NativeParameter {
  name: string;
  /** another name by which the engine's own scripts call it */
  alias?: string;
  /** '' where it has none */
  unit: string;
  min: number;
  max: number;
  /** one sentence without its end */
  words: string;
  role?: Role;
  /**
   * For a parameter that `elastic` does not give: the factor from the value on the original to the one on the coarse mesh. The
   * result is kept within the range. Absent: `elastic` gives the value.
   */
  scaling?: (change: Change) => number;
}

/** The stability limit of an explicit term. */
export interface StepLimit {
  /** name of the parameter */
  name: string;
  most(values: NativeValues): number;
  /** the formula of `most` in words, for messages */
  words: string;
}

/** The material from which the defaults of native parameters follow. */
export interface SolverMaterial {
  /** Young's modulus, Pa */
  young: number;
  /** Poisson's ratio */
  poisson: number;
  /** kg/m3 */
  density: number;
  /** m */
  thickness: number;
  /** bend constant over stretch constant, for families that have such a ratio */
  bendRatio: number;
}

/** What an engine accepts besides one number for the whole body. */
export interface Takes {
  /** a factor for every vertex, on stretching and on bending */
  vertexMaps: boolean;
  /** a value for every constraint */
  constraintValues: boolean;
  /** a mass for every vertex */
  vertexMasses: boolean;
}

export interface SolverProfile {
  name: string;
  label: string;
  /** a short description, for parentheses */
  words: string;
  stretch: SolverModel['stretch'];
  bend: SolverModel['bend'];
  /** how the engine distributes the mass of a body by itself */
  mass: MassRule;
  takes: Takes;
  /** verified: frequencies of the solver model agree with the engine's own (docs/engine-models.md); derived: from the engine's sources alone */
  status: 'generic' | 'verified' | 'derived';
  /** whether the stiffest constraint determines the number of substeps: explicit steps, XPBD and VBD */
  isLocal: boolean;
  parameters: readonly NativeParameter[];
  /** the parameter above whose limit the engine's time steps are unstable; the limit follows from other parameters */
  stepLimit?: StepLimit;
  /** Values of the parameters that the user has not `given`, from the material of the settings on the original. */
  defaults(material: SolverMaterial, original: MeshFacts, given: NativeValues): NativeValues;
  /** The constants of the solver on a mesh into whose settings these values are typed. */
  constants(values: NativeValues, facts: MeshFacts): SolverConstants;
  /** The elastic parameters and the mass that give a mesh these constants: the inverse of `constants`. */
  elastic(constants: SolverConstants, facts: MeshFacts): NativeValues;
}

/** The factor of parameters that do not depend on the mesh. */
export const meshIndependent = (): number => 1;
/** The factor of lengths in proportion to the edges, such as collision distances. */
export const withEdge = ({ edge }: Change): number => edge;
/** The factor of quantities per vertex whose sum must not change. */
export const perVertex = ({ vertices }: Change): number => 1 / vertices;

/** All native values: the user's own over the defaults. */
export const completeValues = (
  profile: SolverProfile,
  { material, original, given }: { material: SolverMaterial; original: MeshFacts; given: NativeValues },
): NativeValues => ({ ...profile.defaults(material, original, given), ...given });

/** A mesh with the values that are typed in for it and the constants that follow from them. */
export interface SolverState {
  values: NativeValues;
  constants: SolverConstants;
  facts: MeshFacts;
}

/**
 * The values to type in for the coarse mesh so that it has `constants`: elastic ones and the mass follow from these, all others
 * are those of the original, scaled as each parameter says.
 */
export function nativeValues(
  profile: SolverProfile,
  original: SolverState,
  { constants, facts }: Omit<SolverState, 'values'>,
): NativeValues {
  const ratio = (now: number, before: number): number => (before > 0 ? now / before : 1);
  const change: Change = {
    edge: ratio(facts.meanEdge, original.facts.meanEdge),
    vertices: facts.vertices / original.facts.vertices,
    stretch: ratio(constants.stretch, original.constants.stretch),
    bend: ratio(constants.bend, original.constants.bend),
  };
  const elastic = profile.elastic(constants, facts);
  return Object.fromEntries(
    profile.parameters.map((parameter) => {
      const { name, scaling, min, max } = parameter;
      if (!scaling) return [name, elastic[name]];
      const value = original.values[name] * scaling(change);
      return [name, Math.min(max, Math.max(min, value))];
    }),
  );
}

/** The parameter that plays a role; undefined where the engine has none. */
export const parameterOf = ({ parameters }: SolverProfile, role: Role): NativeParameter | undefined =>
  parameters.find((parameter) => parameter.role === role);

/** The value of a role; undefined where the engine has no such parameter. */
export function valueOfRole(profile: SolverProfile, values: NativeValues, role: Role): number | undefined {
  const parameter = parameterOf(profile, role);
  return parameter && values[parameter.name];
}

/** The total mass of a mesh with these constants, kg. */
export const totalMass = ({ surfaceDensity }: SolverConstants, { area }: MeshFacts): number =>
  surfaceDensity * area;
