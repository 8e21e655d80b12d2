/** Vertices with their morph targets at the default weights: the scene before any animation. */

import type { Accessor, Node, Primitive } from '@gltf-transform/core';

/**
 * values[3 * v + c] of an attribute of three components, with the displacements of the targets that have it; null where the primitive has no
 * such attribute. Weights of the node override those of its mesh.
 */
export function posed(primitive: Primitive, node: Node, name: 'POSITION' | 'NORMAL'): Float32Array | null {
  const accessor = primitive.getAttribute(name);
  if (!accessor) return null;
  const values = new Float64Array(3 * accessor.getCount());
  addTo(values, accessor, 1);
  const own = node.getWeights();
  const weights = own.length > 0 ? own : (node.getMesh()?.getWeights() ?? []);
  primitive.listTargets().forEach((target, i) => {
    const displacements = target.getAttribute(name);
    if (displacements && weights[i]) addTo(values, displacements, weights[i]);
  });
  return Float32Array.from(values);
}

function addTo(values: Float64Array, accessor: Accessor, weight: number): void {
  const element: number[] = [];
  const count = Math.min(values.length / 3, accessor.getCount());
  for (let v = 0; v < count; ++v) {
    accessor.getElement(v, element);
    for (let c = 0; c < 3; ++c) values[3 * v + c] += weight * element[c];
  }
}
