/** Data shared by several primitives: a geometry with many materials has one list of positions for all of them. */

import type { Accessor, Document, Primitive, PrimitiveTarget } from '@gltf-transform/core';

/** An accessor of a primitive and its role there. */
interface Use {
  /** `indices`, a semantic, or a semantic behind the number of a morph target */
  name: string;
  accessor: Accessor;
  put: (other: Accessor) => unknown;
}

/** The attribute whose sharing decides for new attributes, such as masses, that the primitive did not have before. */
const STAND_IN = 'POSITION';

/**
 * To be called before primitives of the document are replaced. The function that it returns is given those that were, each with accessors
 * of its own, and lets them have equal ones in common where their originals had one in common. Others stay apart: the owner of a
 * document may mean to change one of them. The time is that of comparing the bytes.
 */
export function rememberShared(document: Document): (replaced: ReadonlySet<Primitive>) => void {
  const root = document.getRoot();
  const numbers = new Map(root.listAccessors().map((accessor, i) => [accessor, i]));
  const primitives = root.listMeshes().flatMap((mesh) => mesh.listPrimitives());
  const numbersOf = (primitive: Primitive) =>
    new Map(usesOf(primitive).map(({ name, accessor }) => [name, numbers.get(accessor)]));
  const originals = new Map(primitives.map((primitive) => [primitive, numbersOf(primitive)]));
  return (replaced) => {
    const groups = new Map<string, Accessor[]>();
    for (const primitive of replaced)
      for (const use of usesOf(primitive)) {
        const own = originals.get(primitive);
        const original = own?.get(use.name) ?? own?.get(STAND_IN);
        const key = `${original} ${use.name} ${kindOf(primitive, use.accessor)}`;
        const group = groups.get(key) ?? [];
        groups.set(key, group);
        const equal = group.find((other) => haveEqualBytes(other, use.accessor));
        if (!equal) group.push(use.accessor);
        else if (equal !== use.accessor) replaceAccessor(document, use, equal);
      }
  };
}

function usesOf(primitive: Primitive): Use[] {
  const indices = primitive.getIndices();
  const own = indices
    ? [{ name: 'indices', accessor: indices, put: (other: Accessor) => primitive.setIndices(other) }]
    : [];
  const ofTargets = primitive.listTargets().flatMap((target, i) => attributesOf(target, `${i} `));
  return [...own, ...attributesOf(primitive, ''), ...ofTargets];
}

const attributesOf = (holder: Primitive | PrimitiveTarget, prefix: string): Use[] =>
  holder.listSemantics().map((semantic) => ({
    name: prefix + semantic,
    accessor: holder.getAttribute(semantic)!,
    put: (other) => holder.setAttribute(semantic, other),
  }));

/** What equal accessors share besides their bytes. Draco packs primitives with morph targets in another vertex order. */
function kindOf(primitive: Primitive, accessor: Accessor): string {
  const { length } = bytesOf(accessor);
  const form = [accessor.getType(), accessor.getComponentType(), accessor.getNormalized(), length];
  return [...form, accessor.getSparse(), primitive.listTargets().length > 0].join(' ');
}

function bytesOf(accessor: Accessor): Uint8Array {
  const { buffer, byteOffset, byteLength } = accessor.getArray()!;
  return new Uint8Array(buffer, byteOffset, byteLength);
}

/** Of accessors of the same length. */
function haveEqualBytes(a: Accessor, b: Accessor): boolean {
  const [own, others] = [bytesOf(a), bytesOf(b)];
  return a === b || own.every((byte, i) => byte === others[i]);
}

function replaceAccessor(document: Document, { accessor, put }: Use, equal: Accessor): void {
  put(equal);
  if (accessor.listParents().every((parent) => parent === document.getRoot())) accessor.dispose();
}
