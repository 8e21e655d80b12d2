/** Tunes results by the settings. */

import { positionsInFile, weldedVerticesInFile } from '../body/file_vertices';
import { MATERIAL_SETTINGS, materialOf } from '../body/material';
import type { MaterialSettings } from '../body/material';
import type { PinnedVertices } from '../body/pins';
import type { PreparedBody } from '../body/prepared_body';
import type { Core, MeshAt, TriangleMesh } from '../core/core';
import type { TunedEntry } from '../report/settings_file';
import type { Body } from '../document/model';
import { engineValues } from '../settings/engine_text';
import { SettingError } from '../settings/options';
import type { Settings } from '../settings/options';
import type { SolverName } from '../solvers/profiles';
import { tuneBody } from '../solvers/tuned_body';
import type { TunedBody } from '../solvers/tuned_body';

export const TUNE_SETTINGS = [
  'solver',
  'tune',
  'engine',
  'bendRatio',
  'massRule',
  ...MATERIAL_SETTINGS,
] as const;

type AllSettings = Pick<Settings, (typeof TUNE_SETTINGS)[number]>;

/** The settings that a tuning depends on, with the parameters of the engine as text. */
export interface TuneSettings extends Omit<AllSettings, 'solver'> {
  solver: SolverName;
}

/** null: no solver is chosen. The bend ratio counts only if the solver derives its bend constant from it. */
export function tuneSettings(settings: AllSettings): TuneSettings | null {
  const { solver } = settings;
  if (solver === 'none') return null;
  return { ...settings, solver, bendRatio: readsBendRatio(settings) ? settings.bendRatio : 0 };
}

/** Whether the solver derives its bend constant from the bend ratio: a spring family without a given bend constant. */
function readsBendRatio({ solver, engine }: Pick<Settings, 'solver' | 'engine'>): boolean {
  if (solver !== 'springs' && solver !== 'dihedral') return false;
  return !('bend' in engineValues(solver, engine));
}

/** Throws SettingError where a given bend ratio has no effect in the solver. */
export function checkBendRatio(settings: Pick<Settings, 'solver' | 'engine'>): void {
  if (readsBendRatio(settings)) return;
  const engine = { setting: 'engine' } as const;
  throw new SettingError('bendRatio', [
    'is for springs and dihedral if no bend constant is given in ',
    engine,
    `: leave it out, and give ${settings.solver} its own numbers by `,
    engine,
    '.',
  ]);
}

/** A coarse mesh with its pins and those of its original. */
export interface PinnedMesh {
  mesh: TriangleMesh;
  pinned: PinnedVertices;
  pinnedOriginal: PinnedVertices;
}

/** Tunes `result`, a coarse mesh of the prepared body in the same units, in the solver of the settings. */
export function tuneMesh(
  core: Core,
  prepared: PreparedBody,
  result: PinnedMesh,
  { runsTrial = true, ...settings }: TuneSettings & { runsTrial?: boolean },
): TunedBody {
  const { solver, tune, engine, massRule, bendRatio } = settings;
  const { young, poisson, density, thickness, unit } = materialOf(
    prepared,
    settings satisfies MaterialSettings,
  );
  const pair = {
    original: prepared.mesh,
    result: result.mesh,
    pinnedOriginal: result.pinnedOriginal,
    pinnedResult: result.pinned,
    unit,
  };
  return tuneBody(core, pair, {
    ...{ solver, tune, massRule, runsTrial },
    given: engineValues(solver, engine),
    material: { young, poisson, density, thickness: thickness * unit, bendRatio },
  });
}

/**
 * The mean error of the first ten frequencies of a result in the solver of the settings, tuned, in %. Throws SettingError where
 * the original has no frequencies there.
 */
export function tunedErrorOf(
  core: Core,
  prepared: PreparedBody,
  { result, pinned }: { result: MeshAt; pinned: PinnedVertices },
  settings: TuneSettings,
): number {
  const coarse = { mesh: result.mesh, pinned: pinnedOfResult(pinned, result), pinnedOriginal: pinned };
  const { frequencies, frequencyStatus } = tuneMesh(core, prepared, coarse, {
    ...settings,
    runsTrial: false,
  }).tuned;
  if (Number.isFinite(frequencies.errorTuned)) return frequencies.errorTuned;
  const { name } = prepared.body;
  const why =
    frequencyStatus === 'noConvergence'
      ? `the modes of "${name}" do not converge`
      : `"${name}" bends without resistance`;
  throw new SettingError(
    'maxFrequencyError',
    `cannot be kept in ${settings.solver}, where ${why}: take another solver.`,
  );
}

/** The pinned vertices of a result: those that pinned vertices of the original survived as. Collapses keep their outline. */
export function pinnedOfResult(pinned: PinnedVertices, { inputOfVertex }: MeshAt): PinnedVertices {
  const isPinned = new Set(pinned);
  return Uint32Array.from([...inputOfVertex.keys()].filter((vertex) => isPinned.has(inputOfVertex[vertex])));
}

/** A coarse mesh that was tuned, for the settings file: in the space of its own file. */
export function tunedEntry(coarse: PreparedBody, tuned: TunedBody): TunedEntry {
  const { name, mesh: meshNumber, own } = coarse.body;
  const space = own && { positions: positionsInFile(coarse), scale: own.scale };
  const renderVertices = weldedVerticesInFile(coarse);
  return { name, level: 0, meshNumber, renderVertices, tuned, own: space };
}

/** Calls `work`; with several bodies, its errors are prefixed with the name of the body. */
export function withBodyName<T>({ name }: Body, isOneOfMany: boolean, work: () => T): T {
  try {
    return work();
  } catch (error) {
    const isSentence = error instanceof Error && error.constructor === Error;
    throw isOneOfMany && isSentence ? new Error(`"${name}": ${error.message}`) : error;
  }
}
