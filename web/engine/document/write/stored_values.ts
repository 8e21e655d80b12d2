/** Vertex values stored as those of the input were. */

import type { Accessor } from '@gltf-transform/core';
import { emptyLike, unitOf } from '../blend';

/** The range of an accessor's integers, and the integer that stands for 1. */
interface Grid {
  scale: number;
  least: number;
  most: number;
}

/** null where the accessor is written in floats. */
function gridOf(old: Accessor): Grid | null {
  const array = emptyLike(old.getArray()!, 0);
  if (array instanceof Float32Array) return null;
  const bits = 8 * array.BYTES_PER_ELEMENT;
  const isSigned = array instanceof Int8Array || array instanceof Int16Array;
  const most = 2 ** (isSigned ? bits - 1 : bits) - 1;
  const least = isSigned ? -most - (old.getNormalized() ? 0 : 1) : 0;
  return { scale: 1 / unitOf(old), least, most };
}

/** Whether all values, rounded to the steps of an accessor, are in the range of its component type. */
function fitsStoredType(values: Float32Array, old: Accessor): boolean {
  const grid = gridOf(old);
  if (!grid) return true;
  const { scale, least, most } = grid;
  return values.every((value) => {
    const rounded = Math.round(scale * value);
    return rounded >= least && rounded <= most;
  });
}

/**
 * Gives the floats of an accessor the component type of `old`: rounded to its steps and kept in its range. What `fitsStoredType` differs
 * from the float by half a step of the input's own grid at most.
 */
export function withStoredType(accessor: Accessor, old: Accessor): Accessor {
  const grid = gridOf(old);
  if (!grid) return accessor;
  const { scale, least, most } = grid;
  const values = accessor.getArray()!;
  const array = emptyLike(old.getArray()!, values.length);
  for (let i = 0; i < values.length; ++i)
    array[i] = Math.min(most, Math.max(least, Math.round(scale * values[i])));
  return accessor.setArray(array).setNormalized(old.getNormalized());
}

/**
 * Which attributes of a mesh stay integers. Positions of all its primitives do or none, so that these meet where they met before.
 * `before`: the positions that the primitives had.
 */
export function staysStored(
  keepsStored: boolean,
  positions: Float32Array,
  before: Accessor[],
): (semantic: string) => boolean {
  const fits = before.every((old) => fitsStoredType(positions, old));
  return (semantic) => keepsStored && (fits || semantic !== 'POSITION');
}
