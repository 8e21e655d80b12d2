/**
 * Checks of glTF's JSON against the size of the data, before anything is read: a few bytes of a damaged or hostile file can
 * ask for gigabytes. The bounds are multiples of the file's own size, far above what real files reach.
 */

import type { GLTF, JSONDocument } from '@gltf-transform/core';
import { isCount } from '../../core/count';

/** The most elements without data of their own (sparse or Draco), and the most repeated bytes, per byte of a file. */
const PER_BYTE = 64;
/** What a file may ask for whatever its size. */
const ALWAYS = 1 << 20;
/** meshopt stores at best two bits for a byte of each of 256 elements. */
const MESHOPT_PER_BYTE = 4096;
const MESHOPT = 'EXT_meshopt_compression';
/** glTF-Transform's name for the buffer inside a GLB. */
export const GLB_BUFFER = '@glb.bin';

const COMPONENT_BYTES: Record<number, number> = {
  5120: 1,
  5121: 1,
  5122: 2,
  5123: 2,
  5125: 4,
  5126: 4,
  5130: 8,
  5131: 2,
};
const COMPONENTS: Record<string, number> = {
  SCALAR: 1,
  VEC2: 2,
  VEC3: 3,
  VEC4: 4,
  MAT2: 4,
  MAT3: 9,
  MAT4: 16,
};
const LISTS =
  'accessors bufferViews buffers meshes nodes scenes materials textures images samplers skins animations cameras'.split(
    ' ',
  );
const NAME_LISTS = ['extensionsUsed', 'extensionsRequired'];

interface MeshoptView {
  buffer: number;
  byteOffset?: number;
  byteLength: number;
  byteStride: number;
  count: number;
}

type Checked = Pick<JSONDocument, 'json' | 'resources'>;

/** The most vertices, and the most corners, per byte of a file whose meshes share data. */
const CORNERS_PER_BYTE = 16;

/** The most vertices, and the most corners, that all bodies of a file of `size` bytes may have. */
export const mostCorners = (size: number): number => CORNERS_PER_BYTE * size + ALWAYS;

/** The most elements without data of their own, and the most faces of Draco's, that a file of `size` bytes may have. */
export const mostElements = (size: number): number => PER_BYTE * size + ALWAYS;

/** The bytes of the JSON and of all buffers; data URIs are part of the JSON. */
export function sizeOf(jsonBytes: number, { resources }: JSONDocument): number {
  return Object.values(resources).reduce((sum, bytes) => sum + bytes.byteLength, jsonBytes);
}

/** Throws a plain Error whose message is a clause: what is wrong, and where. */
export function checkBounds(checked: JSONDocument, size: number): void {
  const { json } = checked;
  let [withData, without] = [imageBytes(json), 0];
  if (withData > mostElements(size)) throw new Error('its images read the same data over and over');
  (json.accessors ?? []).forEach((accessor, number) => {
    const bytes = elementBytes(accessor, number) * accessor.count;
    if (accessor.bufferView === undefined) without += accessor.count;
    else withData += bytes;
    checkAccessor(checked, accessor, number);
    if (without > mostElements(size))
      throw new Error(
        `accessor ${number} declares ${accessor.count} elements, for which the file has no data`,
      );
    if (withData > mostElements(size))
      throw new Error(`accessor ${number} and those before it read the same data over and over`);
  });
}

/** The bytes of images that are in buffers. */
function imageBytes({ images, bufferViews }: GLTF.IGLTF): number {
  const views = (images ?? []).map(({ bufferView }) => bufferViews?.[bufferView ?? -1]?.byteLength ?? 0);
  return views.reduce((sum, bytes) => sum + bytes, 0);
}

/** A clause on the first property that should be a list of objects or of names and is not; null if all are. */
export function findWrongList(json: GLTF.IGLTF): string | null {
  const lists = json as unknown as Record<string, unknown>;
  for (const name of NAME_LISTS) {
    const list = lists[name] ?? [];
    if (!Array.isArray(list) || list.some((entry) => typeof entry !== 'string'))
      return `"${name}" is not a list of names`;
  }
  for (const name of LISTS) {
    const list = lists[name] ?? [];
    if (!Array.isArray(list)) return `"${name}" is not a list`;
    const wrong = list.findIndex((entry) => typeof entry !== 'object' || entry === null);
    if (wrong >= 0) return `entry ${wrong} of "${name}" is not an object`;
  }
  return null;
}

function elementBytes({ componentType, type, count }: GLTF.IAccessor, number: number): number {
  const [bytes, components] = [COMPONENT_BYTES[componentType], COMPONENTS[type]];
  if (!bytes || !components) throw new Error(`accessor ${number} has an unknown type`);
  if (!isCount(count)) throw new Error(`accessor ${number} has no valid count`);
  return bytes * components;
}

function checkAccessor(checked: Checked, accessor: GLTF.IAccessor, number: number): void {
  const { count, bufferView, byteOffset, sparse } = accessor;
  const size = elementBytes(accessor, number);
  if (bufferView !== undefined) checkRange(checked, number, { bufferView, byteOffset, count, size });
  if (sparse === undefined) return;
  const { indices, values } = sparse;
  const indexSize = COMPONENT_BYTES[indices?.componentType];
  if (!values || !indexSize || !isCount(sparse.count) || sparse.count > count)
    throw new Error(`the sparse values of accessor ${number} are incomplete`);
  checkRange(checked, number, { ...indices, count: sparse.count, size: indexSize });
  checkRange(checked, number, { ...values, count: sparse.count, size });
}

interface Range {
  bufferView: number;
  byteOffset?: number;
  count: number;
  /** bytes of an element */
  size: number;
}

/** Throws an Error unless the elements lie within the bytes. They may reach beyond their view, as some exporters write them. */
function checkRange(
  checked: Checked,
  number: number,
  { bufferView, byteOffset = 0, count, size }: Range,
): void {
  const view = checked.json.bufferViews?.[bufferView];
  if (!view) throw new Error(`accessor ${number} refers to a buffer view that does not exist`);
  if (!isCount(byteOffset)) throw new Error(`accessor ${number} has an invalid byte offset`);
  const { start, end } = rangeOf(checked, view, bufferView);
  const stride = view.byteStride ?? size;
  if (!isCount(stride) || stride === 0) throw new Error(`buffer view ${bufferView} has an invalid stride`);
  const available = end - start - byteOffset;
  const there = available < size ? 0 : Math.floor((available - size) / stride) + 1;
  if (there < count)
    throw new Error(`accessor ${number} declares ${count} elements but has data for ${there}`);
}

/** Where the view starts in its buffer, and where the buffer ends. */
function rangeOf(checked: Checked, view: GLTF.IBufferView, number: number): { start: number; end: number } {
  const packed = view.extensions?.[MESHOPT] as MeshoptView | undefined;
  if (packed) return { start: 0, end: unpackedBytes(checked, packed, number) };
  const { byteOffset: start = 0 } = view;
  if (!isCount(start)) throw new Error(`buffer view ${number} has an invalid byte offset`);
  return { start, end: bufferBytes(checked, view.buffer, number) };
}

/** The number of bytes that a buffer really has. */
function bufferBytes({ json, resources }: Checked, buffer: number, view: number): number {
  const definition = json.buffers?.[buffer];
  if (!definition) throw new Error(`buffer view ${view} refers to a buffer that does not exist`);
  const { uri } = definition;
  const bytes = resources[uri ?? GLB_BUFFER];
  if (bytes) return bytes.byteLength;
  return typeof uri === 'string' && /^data:/i.test(uri) ? dataBytes(uri) : 0;
}

/** The number of bytes in a data URI; an upper bound where it is not in base64. */
function dataBytes(uri: string): number {
  const comma = uri.indexOf(',');
  const letters = uri.length - comma - 1;
  if (!/;base64$/i.test(uri.slice(0, comma))) return letters;
  const padding = uri.endsWith('==') ? 2 : Number(uri.endsWith('='));
  return Math.floor((letters - padding) * 0.75);
}

function unpackedBytes(checked: Checked, packed: MeshoptView, number: number): number {
  const { buffer, byteOffset = 0, byteLength, byteStride, count } = packed;
  const isPlausible =
    [byteOffset, byteLength, byteStride, count].every(isCount) &&
    count * byteStride <= MESHOPT_PER_BYTE * byteLength &&
    byteOffset + byteLength <= bufferBytes(checked, buffer, number);
  if (!isPlausible)
    throw new Error(`buffer view ${number} declares more data than its compressed bytes can contain`);
  return count * byteStride;
}
