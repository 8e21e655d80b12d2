/** The format of a model by the name of its file. */

import type { Format } from './model';

const FORMATS: readonly Format[] = ['glb', 'gltf', 'obj', 'stl', 'ply', 'off'];

/** The format that the ending stands for; null for other endings. */
export function formatOfName(name: string): Format | null {
  const ending = name.toLowerCase().split('.').pop()!;
  return FORMATS.find((format) => format === ending) ?? null;
}

/** Whether a file has the name of a model that can be read. */
export const isModelName = (name: string): boolean => formatOfName(name) !== null;
