/** Vertex attributes at surface points, interpolated from the corners of a triangle with barycentric weights. */

import type { Accessor } from '@gltf-transform/core';
import { length3 } from '../core/exact_math';

/** The vertices of the primitive that each written vertex is interpolated from. */
export interface VertexSources {
  /** vertices[3 * i + c]: vertex numbers in the primitive */
  vertices: Uint32Array;
  /** shares[3 * i + c]: barycentric weights with sum 1; a copy of a single vertex has the weights 1, 0, 0 */
  shares: Float32Array;
}

export type Values = NonNullable<ReturnType<Accessor['getArray']>>;

/** Component types that an exported attribute keeps; others (16- and 64-bit floats) become float32. */
const KEPT_TYPES = [Int8Array, Uint8Array, Int16Array, Uint16Array, Uint32Array, Float32Array] as const;

/** The integer that stands for 1 in a normalized accessor of each type. */
const ONE: Record<string, number> = {
  Int8Array: 127,
  Uint8Array: 255,
  Int16Array: 32767,
  Uint16Array: 65535,
};

/** `length` zeros of the type in which an accessor that has `array` is written. */
export function emptyLike(array: Values, length: number): Values {
  const kept = KEPT_TYPES.find((type) => array instanceof type) ?? Float32Array;
  return new kept(length) as Values;
}

/** The value that the stored number 1 stands for: 1 itself, or 1 / 255 and the like for normalized integers. */
export function unitOf(accessor: Accessor): number {
  return accessor.getNormalized() ? 1 / (ONE[accessor.getArray()!.constructor.name] ?? 1) : 1;
}

/** Interpolates each component on its own and rounds the values of integer accessors. */
export function blendLinear(accessor: Accessor, { vertices, shares }: VertexSources): Values {
  const array = accessor.getArray()!;
  const size = accessor.getElementSize();
  const count = vertices.length / 3;
  const blended = emptyLike(array, size * count);
  const isFloat = blended instanceof Float32Array;
  for (let i = 0; i < count; ++i)
    for (let c = 0; c < size; ++c) {
      let value = array[size * vertices[3 * i] + c];
      if (shares[3 * i] !== 1) {
        value *= shares[3 * i];
        for (let k = 1; k < 3; ++k) value += shares[3 * i + k] * array[size * vertices[3 * i + k] + c];
        if (!isFloat) value = Math.round(value);
      }
      blended[size * i + c] = value;
    }
  return blended;
}

/** The value of the corner with the largest share, for identifiers, which cannot be interpolated. */
export function takeNearest(accessor: Accessor, { vertices, shares }: VertexSources): Values {
  const array = accessor.getArray()!;
  const size = accessor.getElementSize();
  const taken = emptyLike(array, (size * vertices.length) / 3);
  for (let i = 0; i < vertices.length / 3; ++i) {
    const from = size * vertices[3 * i + largestOf(shares, i)];
    for (let c = 0; c < size; ++c) taken[size * i + c] = array[from + c];
  }
  return taken;
}

/**
 * Interpolates unit vectors: the first three components are mixed and normalised; a fourth (the handedness of a tangent)
 * comes from the corner with the largest share. `fallback` gives the direction of vertex i where the mix vanishes.
 */
export function blendDirections(
  accessor: Accessor,
  sources: VertexSources,
  fallback: (i: number) => ArrayLike<number>,
): Values {
  const { vertices, shares } = sources;
  const array = accessor.getArray()!;
  const size = accessor.getElementSize();
  const blended = takeNearest(accessor, sources);
  const scale = blended instanceof Float32Array ? 1 : 1 / unitOf(accessor);
  const mixed = [0, 0, 0];
  for (let i = 0; i < vertices.length / 3; ++i) {
    if (shares[3 * i] === 1) continue;
    for (let c = 0; c < 3; ++c) {
      mixed[c] = 0;
      for (let k = 0; k < 3; ++k) mixed[c] += shares[3 * i + k] * array[size * vertices[3 * i + k] + c];
    }
    const length = length3(mixed[0], mixed[1], mixed[2]);
    // Opposite vectors cancel to mere rounding errors.
    const direction = length > 1e-3 * scale ? mixed.map((value) => value / length) : fallback(i);
    for (let c = 0; c < 3; ++c)
      blended[size * i + c] = scale === 1 ? direction[c] : Math.round(scale * direction[c]);
  }
  return blended;
}

function largestOf(shares: Float32Array, i: number): number {
  let largest = 0;
  for (let k = 1; k < 3; ++k) if (shares[3 * i + k] > shares[3 * i + largest]) largest = k;
  return largest;
}
