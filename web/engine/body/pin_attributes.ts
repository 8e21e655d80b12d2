/** The attributes of a body that can say which vertices are pinned. */

import type { Document, Primitive } from '@gltf-transform/core';
import type { Body } from '../document/model';

/** Names that `attribute:NAME` can sensibly use, ascending: custom attributes, colours and plain numbers. */
export function pinAttributes(document: Document, body: Body): string[] {
  const primitives = document.getRoot().listMeshes()[body.mesh].listPrimitives();
  const names = body.spans.flatMap(({ primitive }) =>
    primitives[primitive]
      .listSemantics()
      .filter((name) => /^(_|COLOR_)/.test(name) || isScalar(primitives[primitive], name)),
  );
  return [...new Set(names)].sort();
}

const isScalar = (primitive: Primitive, name: string): boolean =>
  primitive.getAttribute(name)?.getType() === 'SCALAR';
