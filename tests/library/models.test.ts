/** What callers of the library give as models. */

import { runInNewContext } from 'node:vm';
import { Document } from '@gltf-transform/core';
import { expect, it } from 'vitest';
import { filesOf, isDocument } from '../../web/library/models';
import { LimberError } from '../../web/library/options';
import type { Model } from '../../web/library/options';

it('are files with a name and bytes; what is none is told by its number, and is no error of the library', async () => {
  const file = { name: 'a.obj', bytes: new Uint8Array(3) };
  expect(await filesOf([file])).toEqual([file]);
  for (const wrong of [{}, null, { name: 'a.bin' }, { ...file, bytes: new ArrayBuffer(3) }])
    await expect(filesOf([file, wrong] as unknown as Model)).rejects.toThrow(
      new LimberError('File 2 of the model is none: give its name, and its bytes as a Uint8Array.'),
    );
});

it('are documents only with a graph and a root of glTF-Transform', async () => {
  expect(isDocument(new Document())).toBe(true);
  for (const other of [{ getRoot: () => {} }, { getRoot: () => {}, getGraph: () => {} }])
    await expect(filesOf(other as unknown as Model)).rejects.toThrow(/^The model is an object: give /);
});

it('are no paths, and bytes without a name are those of a GLB', async () => {
  await expect(filesOf('chair.glb' as unknown as Model)).rejects.toThrow(
    'The model is "chair.glb": give a glTF-Transform Document, the bytes of a GLB, or files ',
  );
  await expect(filesOf(undefined as unknown as Model, 'second ')).rejects.toThrow(
    'The second model is undefined: give ',
  );
  await expect(filesOf(new TextEncoder().encode('v 0 0 0'))).rejects.toThrow(
    /^The bytes of the model do not start with "glTF", .*: give a model of another format with its name, /,
  );
});

it('are bytes of another realm, too', async () => {
  const bytes = runInNewContext('new Uint8Array([103, 108, 84, 70])') as Uint8Array<ArrayBuffer>;
  expect(bytes).not.toBeInstanceOf(Uint8Array);
  expect(await filesOf(bytes)).toEqual([{ name: 'model.glb', bytes }]);
  expect(await filesOf([{ name: 'a.obj', bytes }])).toEqual([{ name: 'a.obj', bytes }]);
  expect(await filesOf(bytes.buffer)).toEqual([
    { name: 'model.glb', bytes: new Uint8Array([103, 108, 84, 70]) },
  ]);
});

it('are documents without a buffer, which stay without', async () => {
  const document = new Document();
  const positions = document.createAccessor().setType('VEC3').setArray(new Float32Array(9));
  const primitive = document.createPrimitive().setAttribute('POSITION', positions);
  document
    .createScene()
    .addChild(document.createNode().setMesh(document.createMesh().addPrimitive(primitive)));
  expect((await filesOf(document)).map(({ bytes }) => bytes.length)).toEqual([expect.any(Number), 36]);
  expect(document.getRoot().listBuffers()).toEqual([]);
});

it('are documents that can be written; others are refused with why', async () => {
  const document = new Document();
  const accessor = document.createAccessor().setBuffer(document.createBuffer());
  document.createMesh().addPrimitive(document.createPrimitive().setAttribute('POSITION', accessor));
  await expect(filesOf(document)).rejects.toMatchObject({
    name: 'LimberError',
    isInternal: false,
    message: expect.stringMatching(
      /^The document cannot be written as a glTF \(.*\): mend it, or /,
    ) as string,
  });
});
