/** Textures without a readable image: materials are shown without them. */

import type { GLTF } from '@gltf-transform/core';
import { counted } from '../../core/words';
import { hasImage, imageOf } from '../extensions/foreign';

/**
 * The JSON without references to textures that have no image, as the reader expects, and a note on those references. Images that are
 * neither in a file nor in a view get an empty address, which the reader takes for an image without bytes.
 */
export function withoutImageless(json: GLTF.IGLTF): { json: GLTF.IGLTF; notes: string[] } {
  const isNowhere = (json.images ?? []).map(({ uri, bufferView }) => !uri && bufferView === undefined);
  const images = json.images?.map((image, i) => (isNowhere[i] ? { ...image, uri: '' } : image));
  const given = isNowhere.includes(true) ? { ...json, images } : json;
  const isImageless = (json.textures ?? []).map(
    (texture) => !hasImage(texture) || isNowhere[imageOf(texture) ?? -1] === true,
  );
  if (!json.materials || !isImageless.includes(true)) return { json: given, notes: [] };
  const named = new Set<number>();
  const materials = json.materials.map((material) => without(material, isImageless, named));
  return { json: { ...given, materials }, notes: describe(named.size) };
}

/** A copy of a value in which objects such as "normalTexture": { "index": 3 } are left out where texture 3 has no image. */
function without<T>(value: T, isImageless: boolean[], named: Set<number>): T {
  if (typeof value !== 'object' || value === null) return value;
  if (Array.isArray(value)) return value.map((entry) => without<unknown>(entry, isImageless, named)) as T;
  const kept = Object.entries(value).filter(([key, child]) => {
    const index = /texture$/i.test(key) ? (child as { index?: number } | null)?.index : undefined;
    const isLeftOut = index !== undefined && isImageless[index];
    if (isLeftOut) named.add(index);
    return !isLeftOut;
  });
  return Object.fromEntries(
    kept.map(([key, child]) => [key, without<unknown>(child, isImageless, named)]),
  ) as T;
}

function describe(count: number): string[] {
  if (count === 0) return [];
  const has = count === 1 ? 'has' : 'have';
  return [
    `${counted(count, 'texture')} ${has} no image that can be read: the result is without ${count === 1 ? 'it' : 'them'}`,
  ];
}
