/** The parameters of an engine that the original of a settings file had, to tune the same model with them again. */

import type { NativeValues } from '../solvers/profile';
import type { SettingsFile } from './settings_file';

/**
 * By their names in the engine. A parameter in which bodies differ was a default, which follows from each body's own mesh: it
 * is left out, so that each has its own again.
 */
export function originalParameters({ bodies }: SettingsFile): NativeValues {
  const first = bodies.filter(({ level }) => level === bodies[0].level);
  const { engine, original } = first[0];
  const isShared = (name: string): boolean =>
    name in engine && first.every((body) => body.original[name] === original[name]);
  return Object.fromEntries(Object.entries(original).filter(([name]) => isShared(name)));
}
