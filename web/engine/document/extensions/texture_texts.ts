/** Names and extras of textures and samplers, which the reader skips: a document has images, and for each use of one how it is sampled. */

import type { GLTF } from '@gltf-transform/core';
import { isObject } from './json';
import type { Json } from './json';

/** What every glTF object may say about itself. */
type Texts = Pick<GLTF.IChildRootProperty, 'name' | 'extras'>;

/** The parts of a file that say which of its textures a material uses, and how they and their samplers are called. */
export type TextureTexts = Required<Pick<GLTF.IGLTF, 'materials' | 'textures' | 'samplers'>>;

/** Null where no texture and no sampler of the file has a name or extras. */
export function textureTextsOf(json: GLTF.IGLTF): TextureTexts | null {
  const { materials = [], textures = [], samplers = [] } = json;
  const hasTexts = [...textures, ...samplers].some((entry) => Object.keys(textsOf(entry)).length > 0);
  return hasTexts ? { materials, textures, samplers } : null;
}

/**
 * Gives the textures and samplers of a written file, which this changes, the names and extras of those that the same materials used
 * before. The writer makes one of those that are otherwise equal, so that they are told apart again.
 */
export function restoreTextureTexts(json: GLTF.IGLTF, old: TextureTexts): void {
  const textureNumber = numbered(json.textures ?? []);
  const samplerNumber = numbered(json.samplers ?? []);
  const samplerOfTexture = json.textures?.map(({ sampler }) => sampler) ?? [];
  const textureOf = (now: number, before: number): number => {
    const texture = old.textures[before];
    const sampler = old.samplers[texture?.sampler ?? -1];
    const number = textureNumber(now, textsOf(texture), textsOf(sampler));
    const written = samplerOfTexture[now];
    if (written !== undefined) json.textures![number].sampler = samplerNumber(written, textsOf(sampler));
    return number;
  };
  json.materials?.forEach((material, i) => {
    renumber(material as unknown as Json, old.materials[i] as unknown, textureOf);
  });
}

function textsOf(entry: Texts | null | undefined): Texts {
  const { name, extras } = entry ?? {};
  return { ...(name !== undefined ? { name } : {}), ...(extras !== undefined ? { extras } : {}) };
}

/**
 * Returns a function from the number of an entry and what it is to say about itself to the number of the entry that says this: the entry
 * itself for the first texts, a copy at the end of the list for others. `distinct` sets further copies apart.
 */
function numbered<Entry extends object>(
  entries: Entry[],
): (now: number, texts: Texts, distinct?: Texts) => number {
  const plain = [...entries];
  const numbers = plain.map(() => new Map<string, number>());
  return (now, texts, distinct = {}) => {
    const own = numbers[now];
    const key = JSON.stringify([texts, distinct]);
    const known = own.get(key);
    if (known !== undefined) return known;
    const number = own.size === 0 ? now : entries.length;
    entries[number] = { ...plain[now], ...texts };
    own.set(key, number);
    return number;
  };
}

/** Gives the infos on textures in a value, such as "normalTexture": { "index": 3 }, the numbers that follow from those that they had before. */
function renumber(value: Json, before: unknown, textureOf: (now: number, before: number) => number): void {
  if (!isObject(before)) return;
  for (const [key, child] of Object.entries(value)) {
    const old = before[key];
    if (key === 'extras' || !isObject(child) || !isObject(old)) continue;
    if (/texture$/i.test(key) && Number.isInteger(child.index) && Number.isInteger(old.index))
      child.index = textureOf(child.index as number, old.index as number);
    renumber(child, old, textureOf);
  }
}
