/** The parameters and material of the original in a settings file, to tune the same model with them again. */

import { ENGINE_MATERIAL } from '../body/material';
import type { EngineMaterial } from '../body/material';
import { OPTIONS } from '../settings/table';
import type { NativeValues } from '../solvers/profile';
import { firstLevel } from './settings_file';
import type { SettingsFile } from './settings_file';

/**
 * The parameters that the user gave, by their names in the engine: the others are derived again from each body's own mesh and the material of the
 * file. If a file does not list them, all parameters that are equal in all bodies, since one that differs was derived.
 */
export function originalParameters({ bodies, given }: SettingsFile): NativeValues {
  const first = firstLevel(bodies);
  const { engine, original } = first[0];
  const isShared = (name: string): boolean =>
    name in engine && first.every((body) => body.original[name] === original[name]);
  const isGiven = (name: string): boolean => given?.includes(name) ?? isShared(name);
  return Object.fromEntries(Object.entries(original).filter(([name]) => isGiven(name)));
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
