/** Writes a primitive's attributes and morph targets for new vertices by interpolating those of the old ones. */

import type { Accessor, Buffer, Document, Primitive } from '@gltf-transform/core';
import { length3 } from '../core/exact_math';
import { blendDirections, blendLinear, takeNearest } from './blend';
import type { Values, VertexSources } from './blend';
import { mergeInfluences } from './influences';

/** The document and buffer that new data are written to. */
export interface Destination {
  document: Document;
  buffer: Buffer;
}

/** Custom attributes that are identifiers, whatever their component type. */
const IDENTIFIERS = /^_(FEATURE_ID_\d+|BATCHID)$/;
const INFLUENCES = /^(JOINTS|WEIGHTS)_\d+$/;

/**
 * Replaces every attribute of `primitive` except POSITION by its values at `sources` and keeps its component type.
 * `normalOf` gives the direction of the new vertex i where the interpolated normals cancel out.
 */
export function carryAttributes(
  destination: Destination,
  primitive: Primitive,
  sources: VertexSources,
  normalOf: (i: number) => ArrayLike<number>,
): void {
  carryInfluences(destination, primitive, sources);
  for (const semantic of primitive.listSemantics()) {
    if (semantic === 'POSITION' || INFLUENCES.test(semantic)) continue;
    const accessor = primitive.getAttribute(semantic)!;
    const values = valuesAt(semantic, accessor, sources, normalOf);
    primitive.setAttribute(semantic, copyWith(destination, accessor, values));
  }
}

function valuesAt(
  semantic: string,
  accessor: Accessor,
  sources: VertexSources,
  normalOf: (i: number) => ArrayLike<number>,
): Values {
  if (semantic === 'NORMAL') return blendDirections(accessor, sources, normalOf);
  if (semantic === 'TANGENT') return blendDirections(accessor, sources, (i) => anyPerpendicular(normalOf(i)));
  if (semantic.startsWith('_') && hasNoBetween(semantic, accessor)) return takeNearest(accessor, sources);
  return blendLinear(accessor, sources);
}

/** Merges all sets that have both joints and weights; a set that lacks one is copied from the nearest corner. */
function carryInfluences(destination: Destination, primitive: Primitive, sources: VertexSources): void {
  const numbers = primitive
    .listSemantics()
    .filter((semantic) => INFLUENCES.test(semantic))
    .map((semantic) => semantic.split('_')[1]);
  const sets = [...new Set(numbers)]
    .sort((a, b) => Number(a) - Number(b))
    .map((number) => ({
      number,
      joints: primitive.getAttribute(`JOINTS_${number}`),
      weights: primitive.getAttribute(`WEIGHTS_${number}`),
    }));
  const whole = sets.flatMap(({ number, joints, weights }) =>
    joints && weights ? [{ number, joints, weights }] : [],
  );
  const merged = whole.length > 0 ? mergeInfluences(whole, sources) : [];
  whole.forEach(({ number, joints, weights }, n) => {
    primitive.setAttribute(`JOINTS_${number}`, copyWith(destination, joints, merged[n].joints));
    primitive.setAttribute(`WEIGHTS_${number}`, copyWith(destination, weights, merged[n].weights));
  });
  for (const { number, joints, weights } of sets) {
    if (joints && weights) continue;
    const semantic = joints ? `JOINTS_${number}` : `WEIGHTS_${number}`;
    const accessor = (joints ?? weights)!;
    primitive.setAttribute(semantic, copyWith(destination, accessor, takeNearest(accessor, sources)));
  }
}

/** Interpolates the displacements of every morph target linearly. */
export function carryTargets(destination: Destination, primitive: Primitive, sources: VertexSources): void {
  for (const target of primitive.listTargets()) {
    // A target may be shared between primitives whose vertices differ.
    const carried = target.clone();
    for (const semantic of target.listSemantics()) {
      const accessor = target.getAttribute(semantic)!;
      const values = blendLinear(accessor, sources);
      carried.setAttribute(semantic, copyWith(destination, accessor, values).setSparse(accessor.getSparse()));
    }
    primitive.removeTarget(target).addTarget(carried);
    if (target.listParents().length === 0) target.dispose();
  }
}

function copyWith({ document, buffer }: Destination, accessor: Accessor, values: Values): Accessor {
  return document
    .createAccessor(accessor.getName(), buffer)
    .setType(accessor.getType())
    .setNormalized(accessor.getNormalized() && !(values instanceof Float32Array))
    .setExtras(accessor.getExtras())
    .setArray(values);
}

/** Whether a custom attribute has only whole numbers: they are taken for identifiers, which must not be interpolated. */
function hasNoBetween(semantic: string, accessor: Accessor): boolean {
  return (
    IDENTIFIERS.test(semantic) || (!accessor.getNormalized() && accessor.getArray()!.every(Number.isInteger))
  );
}

function anyPerpendicular(normal: ArrayLike<number>): number[] {
  const isAlongX = Math.abs(normal[0]) > Math.abs(normal[1]);
  const [x, y, z] = isAlongX ? [-normal[2], 0, normal[0]] : [0, normal[2], -normal[1]];
  const length = length3(x, y, z);
  return length > 0 ? [x / length, y / length, z / length] : [1, 0, 0];
}
