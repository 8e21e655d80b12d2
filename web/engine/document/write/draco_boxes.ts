/**
 * Draco's encoder with one quantization grid for all primitives of a mesh. glTF-Transform asks for a separate grid for each
 * primitive, which would separate vertices that two of them share.
 */

import type { Document, Mesh } from '@gltf-transform/core';
import { boundsOf } from '../../core/mesh';

/** The cube of which a grid is made. */
interface Box {
  min: number[];
  /** the length of its sides */
  range: number;
}

interface MeshBuilder {
  /** Returns the number of the attribute. */
  AddFloatAttribute(mesh: unknown, kind: unknown, count: number, size: number, values: Float32Array): number;
}

interface ExpertEncoder {
  SetAttributeQuantization(attribute: number, bits: number): void;
  SetAttributeExplicitQuantization(
    ...all: [attribute: number, bits: number, size: number, origin: number[], range: number]
  ): void;
}

/** The part of Draco's encoder that is used here. */
export interface DracoEncoder {
  MeshBuilder: new () => MeshBuilder;
  ExpertEncoder: new (mesh: unknown) => ExpertEncoder;
}

/** The encoder for the present positions of this document. */
export function withMeshBoxes(encoder: DracoEncoder, document: Document): DracoEncoder {
  const boxes = boxesOf(document);
  /** of the attribute that was added last; its grid is asked for next */
  let last: { attribute: number; box: Box } | null = null;

  class BoxedBuilder extends encoder.MeshBuilder {
    override AddFloatAttribute(...all: Parameters<MeshBuilder['AddFloatAttribute']>): number {
      const attribute = super.AddFloatAttribute(...all);
      const box = boxes.get(all[4]);
      last = box ? { attribute, box } : null;
      return attribute;
    }
  }

  class BoxedEncoder extends encoder.ExpertEncoder {
    override SetAttributeQuantization(attribute: number, bits: number): void {
      if (last?.attribute !== attribute) super.SetAttributeQuantization(attribute, bits);
      else this.SetAttributeExplicitQuantization(attribute, bits, 3, last.box.min, last.box.range);
    }
  }

  const own = { MeshBuilder: BoxedBuilder, ExpertEncoder: BoxedEncoder };
  return Object.assign(Object.create(encoder) as DracoEncoder, own);
}

/** The box of each array of positions: that of its mesh, and of meshes that share an array with it. */
function boxesOf(document: Document): ReadonlyMap<unknown, Box> {
  const groups = new Map<Float32Array, Set<Float32Array>>();
  for (const mesh of document.getRoot().listMeshes()) {
    const own = positionsOf(mesh);
    const group = new Set(own.flatMap((array) => [array, ...(groups.get(array) ?? [])]));
    for (const array of group) groups.set(array, group);
  }
  return new Map(
    [...new Set(groups.values())].flatMap((group) => {
      const box = boxOf([...group]);
      return [...group].map((array) => [array, box] as const);
    }),
  );
}

const positionsOf = (mesh: Mesh): Float32Array[] =>
  mesh
    .listPrimitives()
    .map((primitive) => primitive.getAttribute('POSITION')?.getArray())
    .filter((array) => array instanceof Float32Array);

function boxOf(arrays: Float32Array[]): Box {
  const bounds = arrays.filter(({ length }) => length > 0).map((array) => boundsOf(array));
  const min = [0, 1, 2].map((c) => Math.min(...bounds.map(({ low }) => low[c])));
  const range = Math.max(...bounds.flatMap(({ high }) => high.map((value, c) => value - min[c])));
  return { min, range: range > 0 ? range : 1 };
}
