/** Documents in memory have what files have not: meshes that share primitives, and what nothing uses yet. */

import type { Document } from '@gltf-transform/core';
import { KHRLightsPunctual } from '@gltf-transform/extensions';
import { expect, it } from 'vitest';
import { applyBodies, filesOf } from '../../web/library/models';
import type { OptimizeReply, WorkMessage } from '../../web/library/protocol';
import { Server } from '../../web/library/work/serve';
import { addMesh, primitiveOf, startDocument } from '../engine/support/gltf';
import { torus } from '../engine/support/shapes';

const wasmFolder = new URL('../../public/wasm/', import.meta.url).href;

async function halve(document: Document): Promise<void> {
  const messages: WorkMessage[] = [];
  await new Server((message) => messages.push(message)).answer({
    command: 'optimize',
    models: [await filesOf(document)],
    options: { threads: 1, wantsBodies: true, ratio: 0.5 },
    core: { wasmFolder },
  });
  const { bodies } = (messages.at(-1) as { value: OptimizeReply }).value;
  await applyBodies(document, bodies, false);
}

it('each mesh gets its own result', async () => {
  const document = startDocument();
  const first = primitiveOf(document, torus());
  first.addTarget(
    document.createPrimitiveTarget().setAttribute('POSITION', first.getAttribute('POSITION')!.clone()),
  );
  const mesh = addMesh(document, 'ring', [first]);
  mesh.addPrimitive(first.clone());
  const copy = mesh.clone().setName('copy');
  document.getRoot().getDefaultScene()!.addChild(document.createNode('copy').setMesh(copy));
  const faces = first.getIndices()!.getCount() / 3;

  await halve(document);

  const primitives = document
    .getRoot()
    .listMeshes()
    .flatMap((one) => one.listPrimitives());
  expect(new Set(primitives).size).toBe(4);
  expect(new Set(primitives.flatMap((one) => one.listTargets())).size).toBe(4);
  for (const primitive of primitives) {
    const positions = primitive.getAttribute('POSITION')!;
    const indices = primitive.getIndices()!.getArray()!;
    expect(positions.getArray()!.every(Number.isFinite)).toBe(true);
    expect(Math.max(...indices)).toBeLessThan(positions.getCount());
    expect(indices.length / 3).toBeLessThan(0.75 * faces);
  }
});

it('what nothing uses yet stays, and what the result needs no more is gone', async () => {
  const document = startDocument();
  const primitive = primitiveOf(document, torus());
  addMesh(document, 'ring', [primitive]);
  const kept = [
    document.createTexture('later'),
    document.createAccessor('later').setArray(new Float32Array(3)),
    document.createSkin('later'),
    document.createExtension(KHRLightsPunctual).createLight('later'),
  ];
  const [positions, indices] = [primitive.getAttribute('POSITION')!, primitive.getIndices()!];
  await halve(document);
  expect(kept.map((property) => property.isDisposed())).toEqual(kept.map(() => false));
  expect([positions, indices].map((property) => property.isDisposed())).toEqual([true, true]);
});
