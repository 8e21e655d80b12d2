/** What primitives of an input have in common, their results have in common where they are equal. */

import type { Accessor, Document, Mesh } from '@gltf-transform/core';
import { expect, it } from 'vitest';
import { openModel } from '../../web/engine/document/open';
import type { OpenModel } from '../../web/engine/document/open';
import { exportGlb } from '../../web/engine/document/export';
import type { ExportedBody } from '../../web/engine/document/export';
import { validateFiles } from '../../web/engine/document/validate';
import { exportFiles } from '../../web/engine/document/write/export_files';
import { applyBodies } from '../../web/library/models';
import { addMesh, floats, glbFile, primitiveOf, readGlb, startDocument } from './support/gltf';
import { asResult } from './support/results';
import { moved } from './support/scenes';
import { grid, torus } from './support/shapes';

/** Three meshes of one geometry, with materials of their own, and a mesh with an equal geometry of its own. */
function chairs(): Document {
  const document = startDocument();
  const { positions } = torus();
  const [first, own] = [0, 1].map(() =>
    primitiveOf(document, torus())
      .setAttribute('NORMAL', floats(document, 'VEC3', normalsOf(positions)))
      .addTarget(
        document.createPrimitiveTarget('fat').setAttribute('POSITION', floats(document, 'VEC3', positions)),
      ),
  );
  const copies = [first, first.clone(), first.clone()];
  [...copies, own].forEach((primitive, i) =>
    addMesh(document, ['a', 'b', 'c', 'own'][i], [primitive.setMaterial(document.createMaterial())]),
  );
  return document;
}

/** Some directions. */
const normalsOf = (positions: Float32Array): number[] =>
  Array.from({ length: positions.length / 3 }, (_, v) => [0, v % 2, 1 - (v % 2)]).flat();

function accessorsOf(mesh: Mesh): Accessor[] {
  const [primitive] = mesh.listPrimitives();
  const ofTargets = primitive.listTargets().flatMap((target) => target.listAttributes());
  const own = ['POSITION', 'NORMAL'].map((semantic) => primitive.getAttribute(semantic)!);
  return [primitive.getIndices()!, ...own, ...ofTargets];
}

const sharedBy = (a: Mesh, b: Mesh): boolean[] =>
  accessorsOf(a).map((accessor, i) => accessor === accessorsOf(b)[i]);

const ofAll = (model: OpenModel, resultOf: (i: number) => ExportedBody) =>
  model.bodies.map((_, i) => ({ first: resultOf(i), further: [] }));

async function written(model: OpenModel, compression: 'none' | 'quantized' | 'meshopt' | 'draco') {
  const bodies = ofAll(model, (i) => asResult(model.bodies[i]));
  const files = await exportFiles(model, bodies, {
    name: 'out.glb',
    form: { format: 'glb', isZipped: false },
    manner: { compression, style: 'files', keepsOrder: false },
    fields: false,
  });
  expect((await validateFiles(files))!.errors).toBe(0);
  return openModel(files);
}

it.each(['none', 'quantized', 'meshopt', 'draco'] as const)(
  'equal results of one geometry are written once, and not those of equal geometries: %s',
  async (compression) => {
    const model = await openModel([await glbFile(chairs())]);
    const again = await written(model, compression);
    const [a, b, c, own] = again.document.getRoot().listMeshes();
    expect([...sharedBy(a, b), ...sharedBy(a, c)]).toEqual(Array.from({ length: 8 }, () => true));
    expect(sharedBy(a, own)).toEqual([false, false, false, false]);
    for (const body of again.bodies) expect(body.positions).toEqual(again.bodies[0].positions);
    expect(again.bodies[0].indices).toHaveLength(model.bodies[0].indices.length);
  },
);

it('results that differ share what is equal', async () => {
  const model = await openModel([await glbFile(chairs())]);
  const bodies = model.bodies.map((body, i) => {
    const result = asResult(body);
    const positions = body.positions.map((value) => value / 2);
    return i === 1 ? { ...result, mesh: { ...result.mesh, positions } } : result;
  });
  const { document } = await openModel([
    { name: 'a.glb', bytes: await exportGlb(model, bodies, { fields: false }) },
  ]);
  const [a, b, c] = document.getRoot().listMeshes();
  expect(sharedBy(a, b)).toEqual([true, false, true, true]);
  expect(sharedBy(a, c)).toEqual([true, true, true, true]);
});

it('meshes of a document in memory share what they shared before, and nothing else', async () => {
  const document = await readGlb((await glbFile(chairs())).bytes);
  const { bodies } = await openModel([await glbFile(document)]);
  await applyBodies(document, bodies.map(asResult), false);
  const [a, b, c, own] = document.getRoot().listMeshes();
  expect([...sharedBy(a, b), ...sharedBy(a, c)]).toEqual(Array.from({ length: 8 }, () => true));
  expect(sharedBy(a, own)).toEqual([false, false, false, false]);
  expect(document.getRoot().listAccessors()).toHaveLength(8);
});

it('Draco keeps a mesh closed that shares its positions with a mesh of other UVs', async () => {
  const document = startDocument();
  const [left, right] = [0, 1].map((at) => moved(grid(7, 7), (x, y) => [x + at, y / 3, at * x]));
  const first = primitiveOf(document, left);
  const uvs = (scale: number) =>
    floats(
      document,
      'VEC2',
      Array.from({ length: (2 * left.positions.length) / 3 }, (_, i) => (scale * i) / 1000),
    );
  const second = first.clone().setAttribute('TEXCOORD_0', uvs(2));
  addMesh(document, 'alone', [first.setAttribute('TEXCOORD_0', uvs(1))]);
  addMesh(document, 'both', [second, primitiveOf(document, right)]);
  const model = await openModel([await glbFile(document)]);
  const [, both] = (await written(model, 'draco')).document.getRoot().listMeshes();
  const [edge, other] = both.listPrimitives().map((primitive) => {
    const positions = primitive.getAttribute('POSITION')!;
    const all = Array.from({ length: positions.getCount() }, (_, v) => positions.getElement(v, []));
    return all.filter(([x]) => Math.abs(x - 1) < 1e-3).map(([, y]) => y);
  });
  expect(edge).toHaveLength(8);
  expect(new Set(edge)).toEqual(new Set(other));
});
