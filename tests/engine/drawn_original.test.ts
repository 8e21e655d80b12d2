/** How the page draws the original: as smooth as its result where the format prescribes no shading. */

import { beforeAll, expect, it } from 'vitest';
import { drawOriginal } from '../../web/app/worker/exporting';
import type { Core } from '../../web/engine/core/core';
import { openModel } from '../../web/engine/document/open';
import type { SourceFile } from '../../web/engine/document/open';
import { FileRun } from '../../web/engine/stages/file_run';
import { loadTestCore } from './support/core';
import { addMesh, glbFile, primitiveOf, readGlb, startDocument } from './support/gltf';
import { ball } from './support/scenes';
import { toObj } from './support/shapes';

let core: Core;
beforeAll(async () => {
  core = await loadTestCore(1);
});

async function drawnPrimitive(file: SourceFile) {
  const run = new FileRun(core, await openModel([file]));
  const document = await readGlb(await drawOriginal(run));
  return document.getRoot().listMeshes()[0].listPrimitives()[0];
}

const textFile = (name: string, text: string): SourceFile => ({
  name,
  bytes: new TextEncoder().encode(text),
});

it('has smooth normals and all faces where an OBJ has no normals', async () => {
  const mesh = ball(8);
  const primitive = await drawnPrimitive(textFile('ball.obj', toObj(mesh)));
  expect(primitive.getIndices()!.getCount()).toBe(mesh.triangles.length);
  const [positions, normals] = [primitive.getAttribute('POSITION')!, primitive.getAttribute('NORMAL')!];
  expect(positions.getCount()).toBe(mesh.positions.length / 3);
  for (let v = 0; v < positions.getCount(); ++v) {
    const [point, normal] = [positions.getElement(v, []), normals.getElement(v, [])];
    const outwards = point.reduce((sum, value, axis) => sum + value * normal[axis], 0);
    // Those around its flat caps lean towards these.
    expect(Math.abs(outwards)).toBeGreaterThan(0.9);
  }
});

it('stays flat where a glTF has no normals, as glTF prescribes', async () => {
  const document = startDocument();
  addMesh(document, 'ball', [primitiveOf(document, ball(8))]);
  const primitive = await drawnPrimitive(await glbFile(document));
  expect(primitive.getAttribute('NORMAL')).toBeNull();
});
