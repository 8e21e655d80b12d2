/** The parameters and material of the original in a settings file, to tune the same model with them again. */

import { ENGINE_MATERIAL } from '../body/material';
import type { EngineMaterial } from '../body/material';
import { OPTIONS } from '../settings/table';
import { meshFacts } from '../solvers/mesh_facts';
import type { NativeValues, SolverMaterial } from '../solvers/profile';
import { profileOf } from '../solvers/profiles';
import { firstLevel } from './settings_file';
import type { SettingsFile } from './settings_file';

/**
 * The parameters that the user gave, by their names in the engine: the others are derived again from each body's own mesh and the material of the
 * file. If a file does not list them, all parameters that are equal in all bodies, since one that differs was derived, besides those that
 * would be derived from the properties `replaced` of the material, which the user now gives.
 */
export function originalParameters(
  file: SettingsFile,
  replaced: readonly (keyof EngineMaterial)[] = [],
): NativeValues {
  const { bodies, given } = file;
  const first = firstLevel(bodies);
  const derived = given ? [] : replaced.flatMap((property) => parametersFrom(property, file));
  const { engine, original } = first[0];
  const isShared = (name: string): boolean =>
    name in engine &&
    !derived.includes(name) &&
    first.every((body) => body.original[name] === original[name]);
  const isGiven = (name: string): boolean => given?.includes(name) ?? isShared(name);
  return Object.fromEntries(Object.entries(original).filter(([name]) => isGiven(name)));
}

/** The parameters whose defaults depend on a property of the material: those that another value of it changes. */
function parametersFrom(property: keyof EngineMaterial, { solver, bodies }: SettingsFile): string[] {
  const [{ mesh, unit }] = bodies;
  const positions = Float32Array.from(mesh.positions);
  const facts = meshFacts({ positions, triangles: Uint32Array.from(mesh.triangles) }, unit);
  const usual = Object.fromEntries(ENGINE_MATERIAL.map((name) => [name, OPTIONS[name].default]));
  const defaultsOf = (change: Partial<SolverMaterial>): NativeValues =>
    profileOf(solver).defaults({ ...(usual as unknown as SolverMaterial), ...change }, facts, {});
  const [before, after] = [defaultsOf({}), defaultsOf({ [property]: OPTIONS[property].default / 2 })];
  return Object.keys(before).filter((name) => before[name] !== after[name]);
}

/** The material of the file, clamped to the ranges of the settings; empty for files that lack it. */
export function originalMaterial({ material }: SettingsFile): Partial<EngineMaterial> {
  if (!material) return {};
  const within = ENGINE_MATERIAL.map((name) => {
    const { min, max } = OPTIONS[name];
    return [name, Math.min(Math.max(material[name], min), max)];
  });
  return Object.fromEntries(within) as Partial<EngineMaterial>;
}
