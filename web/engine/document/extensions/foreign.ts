/**
 * Extensions that the reader does not support. Their JSON is copied unchanged, since scenes, nodes, meshes, cameras,
 * skins, animations, materials and images keep their indices; extensions that may refer to anything else are refused by name.
 */

import type { GLTF } from '@gltf-transform/core';
import { SUPPORTED_EXTENSIONS } from '../gltf_io';
import { isObject } from './json';
import type { Json } from './json';

/** The JSON of one extension on one object of a file. */
export interface ForeignExtension {
  name: string;
  /** keys from the root of the JSON to the object that has the extension */
  path: (string | number)[];
  value: unknown;
  /** why it cannot be carried, as a clause; null: it can be unless the mesh that it is on changes */
  obstacle: string | null;
}

/** The content of a file that its document lacks. */
export interface Foreign {
  extensions: ForeignExtension[];
  /** names that are listed as used, supported or not */
  listed: { used: string[]; required: string[] };
  /** the textures and samplers of the file, which extensions can refer to */
  textures: GLTF.ITexture[];
  samplers: GLTF.ISampler[];
}

/** Extensions that do not change how vertices are stored, so that a file may require them. */
const HARMLESS = /^(KHR_animation_pointer|KHR_interactivity|VRM.*|MSFT_lod)$/;

/** Whether a file that requires the extension can still be read. */
export const canBeCarried = (name: string): boolean => HARMLESS.test(name);

/** Collections whose entries are renumbered when a document is written. */
const RENUMBERED = new Set(['accessors', 'bufferViews', 'buffers', 'samplers']);
/** Keys under which extensions refer to entries of these collections by index. */
const NAMES_DATA = /^(accessors?|bufferViews?|buffers?|samplers?|indices|attributes)$/i;

export function foreignOf(json: GLTF.IGLTF): Foreign | null {
  const extensions: ForeignExtension[] = [];
  collect(json as unknown as Json, [], extensions);
  const used = (json.extensionsUsed ?? []).filter(isForeign);
  if (extensions.length === 0 && used.length === 0) return null;
  const required = (json.extensionsRequired ?? []).filter(isForeign);
  const { textures = [], samplers = [] } = json;
  return { extensions, listed: { used, required }, textures, samplers };
}

const isForeign = (name: string): boolean => !SUPPORTED_EXTENSIONS.has(name);

function collect(value: Json, path: (string | number)[], found: ForeignExtension[]): void {
  for (const [key, child] of Object.entries(value)) {
    if (key === 'extras' || !isObject(child)) continue;
    const step = Array.isArray(value) ? Number(key) : key;
    if (key !== 'extensions' || Array.isArray(value)) collect(child, [...path, step], found);
    else
      for (const [name, own] of Object.entries(child)) {
        if (isForeign(name)) found.push({ name, path, value: own, obstacle: obstacleTo(path, value, own) });
        else if (isObject(own)) collect(own, [...path, 'extensions', name], found);
      }
  }
}

function obstacleTo(path: (string | number)[], holder: Json, value: unknown): string | null {
  if (RENUMBERED.has(String(path[0]))) return 'which is written anew';
  if (path[0] === 'textures' && path.length === 2 && !hasImage(holder))
    return 'which has no other image that can be read';
  const key = dataKeyIn(value);
  return key === null ? null : `and its "${key}" refers to data that is written anew`;
}

/** Whether a texture has an image besides that of an unknown extension. */
export const hasImage = ({ source, extensions }: GLTF.ITexture): boolean =>
  source !== undefined || Object.keys(extensions ?? {}).some((name) => !isForeign(name));

/** The number of the image that the reader takes: that of an extension that it knows comes first. */
export function imageOf({ source, extensions }: GLTF.ITexture): number | undefined {
  const known = Object.entries(extensions ?? {}).filter(([name]) => !isForeign(name));
  return known.map(([, own]) => (own as { source?: number } | null)?.source).find(Number.isInteger) ?? source;
}

/** The first key that refers to accessors and the like by index; null without one. */
function dataKeyIn(value: unknown): string | null {
  if (!isObject(value)) return null;
  for (const [key, child] of Object.entries(value)) {
    if (!Array.isArray(value) && NAMES_DATA.test(key) && hasIndices(child)) return key;
    const inside = dataKeyIn(child);
    if (inside !== null) return inside;
  }
  return null;
}

const hasIndices = (value: unknown): boolean =>
  Number.isInteger(value) || (isObject(value) && Object.values(value).some((one) => Number.isInteger(one)));

/** "mesh 3, primitive 0" */
export function describePath(path: (string | number)[]): string {
  const words = path
    .slice(0, 4)
    .flatMap((step, i) =>
      typeof path[i + 1] === 'number' ? [`${singular(String(step))} ${path[i + 1]}`] : [],
    );
  return words.length > 0 ? words.join(', ') : 'the file';
}

const singular = (list: string): string => (list === 'meshes' ? 'mesh' : list.replace(/s$/, ''));

/** The number of the mesh whose vertices the extension is about; null where it is about none. */
export const meshOfForeign = ({ path }: ForeignExtension): number | null =>
  path[0] === 'meshes' && path[2] === 'primitives' ? Number(path[1]) : null;
