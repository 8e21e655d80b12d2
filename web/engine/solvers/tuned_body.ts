/** Tunes a coarse mesh to its original in a solver: finds the values to type in for the original and for the coarse mesh. */

import type {
  Core,
  MassRule,
  SolverConstants,
  SolverModel,
  TriangleMesh,
  Tuned,
  TuneKind,
} from '../core/core';
import { meshFacts } from './mesh_facts';
import { completeValues, nativeValues, totalMass, valueOfRole } from './profile';
import type { NativeValues, SolverMaterial, SolverProfile, SolverState } from './profile';
import { profileOf } from './profiles';
import type { SolverName } from './profiles';
import { substepsNeeded } from './substeps';

export interface TuneRequest {
  solver: SolverName;
  tune: TuneKind;
  /** the user's own parameters for the original; the others follow from `material` */
  given: NativeValues;
  material: SolverMaterial;
  /** 'auto': the engine's own rule */
  massRule: MassRule | 'auto';
  /** whether a motion trial decides between tuned and untouched */
  runsTrial: boolean;
}

/** An original and a coarse mesh of it, both welded, with the vertices that are pinned. */
export interface TunedPair {
  original: TriangleMesh;
  result: TriangleMesh;
  /** ascending; both empty where nothing is pinned */
  pinnedOriginal: Uint32Array;
  pinnedResult: Uint32Array;
  /** metres per unit of both meshes */
  unit: number;
}

export interface TunedBody {
  solver: SolverName;
  tune: TuneKind;
  model: SolverModel;
  /** how the masses of the coarse mesh are distributed: carried over from the original by area, or equal */
  massRule: MassRule;
  original: SolverState;
  /** the coarse mesh; its constants contain the tuned factors */
  result: SolverState;
  mesh: TriangleMesh;
  pins: Uint32Array;
  tuned: Tuned;
  /** substeps of a step of 1/60 s, or the engine's equivalent, at which the motion converges; null: unknown */
  substeps: number | null;
}

/** Tunes a body. Throws the core's Error where the meshes do not belong together. */
export function tuneBody(core: Core, pair: TunedPair, request: TuneRequest): TunedBody {
  const profile = profileOf(request.solver);
  const { original, untouched } = statesOf(profile, pair, request);
  const model = modelOf(profile, request.massRule);
  const massRule = profile.takes.vertexMasses ? 'area' : 'vertex';
  const tuned = core.tuneSolver(pair.original, pair.result, {
    model,
    original: original.constants,
    result: untouched.constants,
    pinnedOriginal: pair.pinnedOriginal,
    pinnedResult: pair.pinnedResult,
    tune: request.tune,
    tunedMass: massRule,
    runsTrial: request.runsTrial,
  });
  const constants = tunedConstants(original, untouched, tuned);
  const values = nativeValues(profile, original, { constants, facts: untouched.facts });
  return {
    ...{ solver: request.solver, tune: request.tune, model, massRule, original },
    result: { values, constants, facts: untouched.facts },
    mesh: pair.result,
    pins: pair.pinnedResult,
    tuned,
    substeps: substepsOf(profile, values, { mesh: pair.result, model, constants, tuned }),
  };
}

export const modelOf = (
  { stretch, bend, mass }: SolverProfile,
  rule: TuneRequest['massRule'],
): SolverModel => ({
  stretch,
  bend,
  mass: rule === 'auto' ? mass : rule,
});

/** The original with the user's parameters, and the untouched coarse mesh with the same numbers. */
export function statesOf(
  profile: SolverProfile,
  pair: Pick<TunedPair, 'original' | 'result' | 'unit'>,
  { material, given }: Pick<TuneRequest, 'material' | 'given'>,
): { original: SolverState; untouched: SolverState } {
  const facts = meshFacts(pair.original, pair.unit);
  const values = completeValues(profile, { material, original: facts, given });
  const coarse = meshFacts(pair.result, pair.unit);
  return {
    original: { values, facts, constants: profile.constants(values, facts) },
    untouched: { values, facts: coarse, constants: profile.constants(values, coarse) },
  };
}

/** The constants of the coarse mesh with the tuned factors and the total mass of the original. */
export function tunedConstants(
  original: SolverState,
  untouched: SolverState,
  { stretchFactor, bendFactor }: Pick<Tuned, 'stretchFactor' | 'bendFactor'>,
): SolverConstants {
  const { constants, facts } = untouched;
  return {
    ...constants,
    stretch: stretchFactor * constants.stretch,
    secondStretch: stretchFactor * constants.secondStretch,
    bend: bendFactor * constants.bend,
    surfaceDensity: totalMass(original.constants, original.facts) / facts.area,
  };
}

function substepsOf(
  profile: SolverProfile,
  values: NativeValues,
  mesh: Parameters<typeof substepsNeeded>[0],
): number | null {
  return profile.isLocal ? substepsNeeded(mesh) : (valueOfRole(profile, values, 'substeps') ?? null);
}
