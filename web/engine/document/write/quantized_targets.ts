/** Quantizes morph targets, whose values are differences: signed, and possibly beyond 1. */

import type { Accessor, Document, Mesh, PrimitiveTarget } from '@gltf-transform/core';

/** Bits including the sign, as many as the attributes themselves have. */
const BITS: [RegExp, number][] = [
  [/^(NORMAL|TANGENT)$/, 10],
  [/^TEXCOORD_/, 12],
  [/^COLOR_/, 9],
];
/** The integer that stands for 1. */
const ONE = 32767;

/** Converts all differences but those of positions to signed integers if they lie in [-1, 1]; others stay floats. */
export function quantizeDifferences(document: Document): void {
  const known = new Map<Accessor, Accessor>();
  for (const target of new Set(document.getRoot().listMeshes().flatMap(targetsOf)))
    for (const semantic of target.listSemantics()) {
      const bits = BITS.find(([pattern]) => pattern.test(semantic))?.[1];
      const accessor = target.getAttribute(semantic)!;
      if (!bits || !isUnitFloat(accessor)) continue;
      const integers = known.get(accessor) ?? toIntegers(accessor, bits);
      target.setAttribute(semantic, known.set(accessor, integers).get(accessor)!);
    }
}

const targetsOf = (mesh: Mesh): PrimitiveTarget[] =>
  mesh.listPrimitives().flatMap((primitive) => primitive.listTargets());

function isUnitFloat(accessor: Accessor): boolean {
  const values = accessor.getArray();
  return values instanceof Float32Array && values.every((value) => Math.abs(value) <= 1);
}

function toIntegers(accessor: Accessor, bits: number): Accessor {
  const steps = 2 ** (bits - 1) - 1;
  const values = accessor.getArray() as Float32Array;
  const integers = Int16Array.from(values, (value) => Math.round((Math.round(steps * value) * ONE) / steps));
  return accessor.clone().setArray(integers).setNormalized(true);
}

/** Removes targets without displacement, which cannot be quantized with others, from their primitives; the returned function puts them back. */
export function detachRestingTargets(document: Document): () => void {
  const primitives = document
    .getRoot()
    .listMeshes()
    .flatMap((mesh) => mesh.listPrimitives())
    .filter((primitive) => primitive.listTargets().some(isUnmoving));
  const whole = primitives.map((primitive) => primitive.listTargets());
  for (const primitive of primitives)
    for (const target of primitive.listTargets()) if (isUnmoving(target)) primitive.removeTarget(target);
  return () =>
    primitives.forEach((primitive, i) => {
      for (const target of primitive.listTargets()) primitive.removeTarget(target);
      for (const target of whole[i]) primitive.addTarget(target);
    });
}

const isUnmoving = (target: PrimitiveTarget): boolean => target.getAttribute('POSITION') === null;
