// Primitives of a mesh stay together where Draco rounds their positions.

import { KHRDracoMeshCompression } from '@gltf-transform/extensions';
import { expect, it } from 'vitest';
import { createGltfIo, createGltfWriter, DRACO } from '../../web/engine/document/gltf_io';
import { addMesh, primitiveOf, startDocument } from './support/gltf';
import { torus } from './support/shapes';

/** The distinct positions of all primitives. */
const positionsOf = (arrays: Float32Array[]): Set<string> =>
  new Set(
    arrays.flatMap((array) =>
      Array.from({ length: array.length / 3 }, (_, v) => array.slice(3 * v, 3 * v + 3).join(' ')),
    ),
  );

it('keeps vertices that primitives share at one position, in every mesh that has one of them', async () => {
  const { positions, triangles } = torus();
  const document = startDocument();
  const parts = [0.15, 0.5, 1].map((end, i, ends) => {
    const [from, to] = [ends[i - 1] ?? 0, end].map((share) => 3 * Math.floor((share * triangles.length) / 3));
    const own = [...new Set(triangles.slice(from, to))];
    const numbers = new Map(own.map((vertex, number) => [vertex, number]));
    return primitiveOf(document, {
      positions: Float32Array.from(own.flatMap((v) => [...positions.slice(3 * v, 3 * v + 3)])),
      triangles: triangles.slice(from, to).map((v) => numbers.get(v)!),
    });
  });
  addMesh(document, 'one', parts.slice(0, 2));
  addMesh(document, 'two', parts.slice(1));
  document.createExtension(KHRDracoMeshCompression).setRequired(true);
  const bytes = await (await createGltfWriter(document)).writeBinary(document);
  const read = await (await createGltfIo([DRACO])).readBinary(bytes);
  const primitives = read
    .getRoot()
    .listMeshes()
    .flatMap((mesh) => mesh.listPrimitives());
  expect(primitives).toHaveLength(4);
  const arrays = primitives.map((one) => one.getAttribute('POSITION')!.getArray() as Float32Array);
  expect(positionsOf(arrays).size).toBe(positions.length / 3);
});
