/** Vertex values stored as those of the input were. */

import type { Accessor } from '@gltf-transform/core';
import { emptyLike, unitOf } from '../blend';

/**
 * Gives the floats of an accessor the component type of `old`: rounded to its steps and kept in its range. A position so differs from
 * the float by half a step of the input's own grid at most, but where it has moved out of that grid.
 */
export function likeStored(accessor: Accessor, old: Accessor): Accessor {
  const [values, stored] = [accessor.getArray()!, old.getArray()!];
  const array = emptyLike(stored, values.length);
  if (array instanceof Float32Array) return accessor;
  const scale = 1 / unitOf(old);
  const bits = 8 * array.BYTES_PER_ELEMENT;
  const isSigned = array instanceof Int8Array || array instanceof Int16Array;
  const most = 2 ** (isSigned ? bits - 1 : bits) - 1;
  const least = isSigned ? -most - (old.getNormalized() ? 0 : 1) : 0;
  for (let i = 0; i < values.length; ++i)
    array[i] = Math.min(most, Math.max(least, Math.round(scale * values[i])));
  return accessor.setArray(array).setNormalized(old.getNormalized());
}
