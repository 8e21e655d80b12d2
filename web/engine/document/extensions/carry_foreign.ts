/** Writes the JSON of unknown extensions into the JSON of a result. */

import type { GLTF } from '@gltf-transform/core';
import { meshOfForeign } from './foreign';
import type { Foreign, ForeignExtension } from './foreign';
import { isObject } from './json';
import type { Json } from './json';

/** Collections whose entries keep their indices; new entries are appended. */
const STABLE = 'scenes nodes meshes cameras skins animations materials images'.split(' ');

/**
 * Adds to `json`, which it changes, what can be carried. `source`: how many entries each list of the file had. `replaced`:
 * numbers of the meshes whose primitives have new vertices.
 */
export function carryForeign(json: GLTF.IGLTF, foreign: Foreign, replaced: ReadonlySet<number>): void {
  const written = new Set<string>();
  const textureOf = textureNumbers(json, foreign);
  for (const extension of foreign.extensions) {
    if (extension.obstacle !== null || replaced.has(meshOfForeign(extension) ?? -1)) continue;
    const holders = holdersOf(json, foreign, extension);
    if (holders.length === 0) continue;
    written.add(extension.name);
    const value = withTextures(extension.value, '', textureOf);
    for (const holder of holders)
      holder.extensions = { ...(holder.extensions as object), [extension.name]: value };
  }
  // A listed extension without any JSON applies to the whole file.
  const found = new Set(foreign.extensions.map(({ name }) => name));
  const isListed = (name: string) => written.has(name) || !found.has(name);
  addNames(json, 'extensionsUsed', foreign.listed.used.filter(isListed));
  addNames(json, 'extensionsRequired', foreign.listed.required.filter(isListed));
}

function addNames(json: GLTF.IGLTF, list: 'extensionsUsed' | 'extensionsRequired', names: string[]): void {
  if (names.length > 0) json[list] = [...new Set([...(json[list] ?? []), ...names])];
}

/** The objects of the result that the extension belongs to. */
function holdersOf(json: GLTF.IGLTF, { textures }: Foreign, { path }: ForeignExtension): Json[] {
  if (path[0] === 'textures' && path.length === 2) {
    const old = textures[Number(path[1])];
    return (json.textures ?? []).filter((texture) => texture.source === old.source) as unknown as Json[];
  }
  if (path.length > 0 && path[0] !== 'extensions' && !STABLE.includes(String(path[0]))) return [];
  let holder: unknown = json;
  for (const step of path) {
    if (!isObject(holder)) return [];
    holder = holder[step];
  }
  return isObject(holder) ? [holder] : [];
}

/** Returns a function from the index of a texture in the file to that in the result, which adds the texture on first use. */
function textureNumbers(json: GLTF.IGLTF, { textures, samplers }: Foreign): (old: number) => number {
  const known = new Map<number, number>();
  return (old) => {
    const number = known.get(old);
    if (number !== undefined || !textures[old]) return number ?? old;
    const { sampler, ...texture } = textures[old];
    json.textures ??= [];
    if (sampler !== undefined && samplers[sampler]) {
      json.samplers ??= [];
      json.samplers.push(samplers[sampler]);
      json.textures.push({ ...texture, sampler: json.samplers.length - 1 });
    } else json.textures.push(texture);
    known.set(old, json.textures.length - 1);
    return json.textures.length - 1;
  };
}

/**
 * A copy of the value with the numbers of textures as in the result: those of objects such as glTF's own infos on textures
 * ("shadeMultiplyTexture": { "index": 3 }), and those that VRM 0 has under "texture" and in "textureProperties".
 */
function withTextures(value: unknown, key: string, textureOf: (old: number) => number): unknown {
  if (Number.isInteger(value) && key === 'texture') return textureOf(value as number);
  if (typeof value !== 'object' || value === null) return value;
  if (Array.isArray(value)) return value.map((entry) => withTextures(entry, '', textureOf));
  const isInfo = /texture$/i.test(key);
  return Object.fromEntries(
    Object.entries(value).map(([name, child]) => {
      const isNumber =
        Number.isInteger(child) && ((isInfo && name === 'index') || key === 'textureProperties');
      return [name, isNumber ? textureOf(child as number) : withTextures(child, name, textureOf)];
    }),
  );
}
