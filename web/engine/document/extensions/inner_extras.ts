/** Extras of objects inside others, such as "pbrMetallicRoughness" of a material, most of which the reader skips. */

import type { GLTF } from '@gltf-transform/core';
import { isObject } from './json';

export interface InnerExtras {
  /** keys from the root of the JSON to the object that has the extras */
  path: string[];
  extras: unknown;
}

/** Lists whose entries, and objects inside of these, keep their places in a written file. */
const LISTS = ['nodes', 'cameras', 'animations', 'materials'] as const;

/** The extras of all objects inside the entries of a file; those of an entry itself are the reader's. */
export function innerExtrasOf(json: GLTF.IGLTF): InnerExtras[] {
  const found: InnerExtras[] = [];
  for (const list of LISTS)
    for (const [i, entry] of (json[list] ?? []).entries())
      for (const [key, value] of Object.entries(entry)) collect(value, [list, String(i), key], found);
  return found;
}

function collect(value: unknown, path: string[], found: InnerExtras[]): void {
  if (!isObject(value) || path.at(-1) === 'extras') return;
  if (value.extras !== undefined && !Array.isArray(value)) found.push({ path, extras: value.extras });
  for (const [key, child] of Object.entries(value)) collect(child, [...path, key], found);
}

/** Gives the extras to the objects of a written file, which this changes, that are at the same places and have none. */
export function restoreInnerExtras(json: GLTF.IGLTF, all: readonly InnerExtras[]): void {
  for (const { path, extras } of all) {
    const holder = path.reduce<unknown>((value, key) => (isObject(value) ? value[key] : undefined), json);
    if (isObject(holder)) holder.extras ??= extras;
  }
}
