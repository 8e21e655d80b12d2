import { describe, expect, it } from 'vitest';
import { ALL_EXTENSIONS, KHRMeshQuantization } from '@gltf-transform/extensions';
import { WebIO } from '@gltf-transform/core';
import fc from 'fast-check';
import type { Document } from '@gltf-transform/core';
import { companionNames } from '../../web/engine/document/gltf';
import { openModel } from '../../web/engine/document/open';
import type { SourceFile } from '../../web/engine/document/open';
import { failureOf, SQUARE_OBJ, textFile } from './support/files';
import { addMesh, addRichMesh, floats, glbFile, indices, primitiveOf, startDocument } from './support/gltf';
import { cube, grid } from './support/shapes';

const open = async (document: Document) => openModel([await glbFile(document)]);

/** The square of SQUARE_OBJ drawn in one of glTF's modes. */
function drawn(mode: number, order: number[] | null): Document {
  const document = startDocument();
  const primitive = primitiveOf(document, {
    positions: Float32Array.from([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]),
    triangles: Uint32Array.from(order ?? []),
  });
  primitive.setMode(mode as 4);
  if (!order) primitive.setIndices(null);
  addMesh(document, 'square', [primitive]);
  return document;
}

/** A glTF with its buffer and an image in separate files. */
function separateGltf(): SourceFile[] {
  const positions = new Uint8Array(Float32Array.from([0, 0, 0, 1, 0, 0, 0, 1, 0]).buffer);
  const json = {
    asset: { version: '2.0' },
    buffers: [{ uri: 'parts/my%20data.bin', byteLength: 36 }],
    bufferViews: [{ buffer: 0, byteLength: 36 }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 0] },
    ],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    images: [{ uri: 'skin.png' }],
  };
  return [
    textFile('model/test.gltf', JSON.stringify(json)),
    { name: 'model/parts/my data.bin', bytes: positions },
    { name: 'model/skin.png', bytes: new Uint8Array(1) },
  ];
}

describe('glTF', () => {
  it.each([
    ['a list', 4, [0, 1, 2, 0, 2, 3], [0, 1, 2, 0, 2, 3]],
    ['a strip, with every second triangle reversed', 5, [0, 1, 3, 2], [0, 1, 3, 3, 1, 2]],
    ['a fan', 6, [0, 1, 2, 3], [0, 1, 2, 0, 2, 3]],
    ['a list without indices', 4, null, [0, 1, 2]],
  ])('reads %s', async (_, mode, order, expected) => {
    const { bodies } = await open(drawn(mode, order));
    expect([...bodies[0].indices]).toEqual(expected);
    expect(bodies[0].name).toBe('square');
  });

  it('joins the primitives of a mesh into one body that shares the vertices they share', async () => {
    const document = startDocument();
    const first = primitiveOf(document, cube());
    const second = document
      .createPrimitive()
      .setAttribute('POSITION', first.getAttribute('POSITION'))
      .setIndices(indices(document, [0, 1, 2]));
    const lines = document
      .createPrimitive()
      .setAttribute('POSITION', first.getAttribute('POSITION'))
      .setMode(1);
    addMesh(document, 'cube', [first, lines, second, primitiveOf(document, grid(1, 1))]);
    const { bodies } = await open(document);
    expect(bodies).toHaveLength(1);
    expect(bodies[0].positions).toHaveLength(3 * (8 + 4));
    expect([...bodies[0].indices.slice(36)]).toEqual([0, 1, 2, 8, 9, 11, 8, 11, 10]);
    expect(bodies[0].spans).toEqual([
      { primitive: 0, first: 0, firstVertex: 0, vertexCount: 8 },
      { primitive: 2, first: 12, firstVertex: 0, vertexCount: 8 },
      { primitive: 3, first: 13, firstVertex: 8, vertexCount: 4 },
    ]);
    expect(bodies[0].notes).toEqual(['1 primitive of lines skipped']);
  });

  it('decodes quantized positions', async () => {
    const document = startDocument();
    document.createExtension(KHRMeshQuantization).setRequired(true);
    const primitive = primitiveOf(document, cube());
    const quantized = Int16Array.from(cube().positions, (value) => 32767 * value);
    primitive.getAttribute('POSITION')!.setArray(quantized).setNormalized(true);
    addMesh(document, 'cube', [primitive]);
    const { bodies } = await open(document);
    expect([...bodies[0].positions]).toEqual([...cube().positions]);
  });

  it('reads sparse positions', async () => {
    const document = startDocument();
    const primitive = primitiveOf(document, cube());
    primitive.getAttribute('POSITION')!.setSparse(true);
    addMesh(document, 'cube', [primitive]);
    const { bodies } = await open(document);
    expect([...bodies[0].positions]).toEqual([...cube().positions]);
  });

  it('uses the scale of the first node that shows the mesh', async () => {
    const document = startDocument();
    const mesh = addMesh(document, 'even', [primitiveOf(document, cube())]);
    addMesh(document, 'uneven', [primitiveOf(document, cube())]);
    const [even, uneven] = document.getRoot().listNodes();
    const parent = document
      .createNode('parent')
      .setScale([2, 2, 2])
      .addChild(even.setScale([0.005, -0.005, 0.005]));
    document
      .getRoot()
      .getDefaultScene()!
      .addChild(parent)
      .addChild(document.createNode('second').setMesh(mesh));
    uneven.setScale([1, 2, 4]);
    const { bodies } = await open(document);
    expect(bodies[0].scale).toBeCloseTo(0.01, 7);
    expect(bodies[0].notes).toEqual([]);
    expect(bodies[1].scale).toBeCloseTo(Math.sqrt(7), 6);
    expect(bodies[1].notes).toEqual(['its node scales it non-uniformly: frequencies use the mean scale']);
  });

  it('uses the scale of the joints of a skinned mesh, whose node glTF ignores', async () => {
    const document = startDocument();
    addMesh(document, 'skinned', [primitiveOf(document, cube())]);
    const [node] = document.getRoot().listNodes();
    const joint = document.createNode('joint').setRotation([0, 0.6, 0, 0.8]).setScale([0.02, 0.02, 0.02]);
    document
      .getRoot()
      .getDefaultScene()!
      .addChild(document.createNode('armature').setScale([0.5, 0.5, 0.5]).addChild(joint));
    const bind = document
      .createAccessor()
      .setType('MAT4')
      .setArray(Float32Array.of(2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1))
      .setBuffer(document.getRoot().listBuffers()[0]);
    node
      .setScale([7, 7, 7])
      .setSkin(document.createSkin().addJoint(joint).setInverseBindMatrices(bind).setSkeleton(joint));
    const { bodies } = await open(document);
    expect(bodies[0].scale).toBe(0.02);
    expect(bodies[0].notes).toEqual([]);
  });

  it('finds its companion files, in folders and with escaped names', async () => {
    const files = separateGltf();
    expect(companionNames({ ...files[0], name: 'test.gltf' })).toEqual(['parts/my data.bin', 'skin.png']);
    expect((await openModel(files)).bodies[0].indices).toHaveLength(3);
    const flat = files.map((file) => ({ ...file, name: file.name.split('/').pop()! }));
    expect((await openModel(flat)).bodies[0].indices).toHaveLength(3);
  });

  it('names meshes with equal names after their nodes', async () => {
    const document = startDocument();
    for (const [mesh, node] of [
      ['Mesh', 'left'],
      ['Mesh', 'right'],
      ['Wheel', 'front'],
      ['Mesh', ''],
    ]) {
      const made = addMesh(document, mesh, [primitiveOf(document, cube())]);
      made
        .listParents()
        .find((parent) => parent.propertyType === 'Node')!
        .setName(node);
    }
    const { bodies } = await openModel([await glbFile(document)]);
    expect(bodies.map(({ name }) => name)).toEqual(['left', 'right', 'Wheel', 'Mesh']);
  });

  it('says that morph targets with default weights are taken at rest', async () => {
    const notesAt = async (weight: number) => {
      const document = startDocument();
      const target = document.createPrimitiveTarget('up');
      target.setAttribute('POSITION', floats(document, 'VEC3', Array(cube().positions.length).fill(1)));
      addMesh(document, 'cube', [primitiveOf(document, cube()).addTarget(target)]).setWeights([weight]);
      return (await openModel([await glbFile(document)])).notes;
    };
    expect(await notesAt(0)).toEqual([]);
    expect(await notesAt(0.5)).toEqual([
      'default weights of morph targets: measurements and motion use weights of 0',
    ]);
  });

  it('names the companion files that are missing', async () => {
    const [main, buffer] = separateGltf();
    expect(await failureOf(() => openModel([main]))).toBe(
      'model/test.gltf needs parts/my data.bin, which is missing: open the whole folder, or put the missing files beside it.',
    );
    expect((await openModel([main, buffer])).notes).toEqual([
      '1 texture (skin.png) is missing or outside the folder: the result only refers to it',
    ]);
  });

  it('refuses numbers that are not finite and indices out of range, naming mesh and primitive', async () => {
    const infinite = startDocument();
    addMesh(infinite, 'bad', [primitiveOf(infinite, cube()), primitiveOf(infinite, cube())]);
    infinite
      .getRoot()
      .listMeshes()[0]
      .listPrimitives()[1]
      .getAttribute('POSITION')!
      .setElement(3, [0, NaN, 1]);
    expect(await failureOf(() => open(infinite))).toBe(
      'test.glb, mesh "bad", primitive 1: vertex 3 is at (0, NaN, 1), which is not finite: repair the mesh and export it again.',
    );
    expect(await failureOf(() => open(drawn(4, [0, 1, 9])))).toBe(
      'test.glb, mesh "square", primitive 0: index 9 is out of range, there are 4 vertices: repair the mesh and export it again.',
    );
  });

  it('says what a file without triangles contains', async () => {
    expect(await failureOf(() => open(startDocument()))).toBe(
      'test.glb has no mesh: export it with a triangle mesh.',
    );
    expect(await failureOf(() => open(drawn(0, null)))).toBe(
      'test.glb has no triangles (mesh "square" has no triangles (1 primitive of points skipped)): export it with a triangle mesh.',
    );
  });

  it('omits a mesh without triangles from the bodies and says so', async () => {
    const document = drawn(1, null);
    addMesh(document, 'cube', [primitiveOf(document, cube())]);
    const { bodies, notes } = await open(document);
    expect(bodies.map(({ name, mesh }) => [name, mesh])).toEqual([['cube', 1]]);
    expect(notes).toEqual(['mesh "square" has no triangles (1 primitive of lines skipped)']);
  });

  it('refuses broken files with one sentence', async () => {
    const { bytes } = await glbFile(drawn(4, [0, 1, 2]));
    const glb = (part: Uint8Array) => failureOf(() => openModel([{ name: 'a.glb', bytes: part }]));
    expect(await glb(bytes.subarray(0, 10))).toBe(
      'a.glb is not a usable GLB (it is cut off): export it again.',
    );
    expect(await glb(bytes.subarray(0, bytes.length - 4))).toMatch(
      /^a\.glb is not a usable GLB \(it is cut off: \d+ bytes/,
    );
    expect(await glb(new TextEncoder().encode('a text that is longer than a header'))).toMatch(
      /does not start with "glTF"/,
    );
    const gltf = (json: string) => failureOf(() => openModel([textFile('a.gltf', json)]));
    expect(await gltf('{"asset"')).toMatch(/^a\.gltf is not glTF \(/);
    expect(await gltf('[]')).toBe('a.gltf is not glTF (it has no "asset"): check that it is a mesh file.');
    expect(await gltf('{"asset":{"version":"1.0"}}')).toBe(
      'a.gltf is glTF 1.0: convert it to glTF 2.0, as gltf-pipeline does.',
    );
    expect(
      await gltf('{"asset":{"version":"2.0"},"extensionsUsed":["A_b"],"extensionsRequired":["A_b"]}'),
    ).toBe('a.gltf requires A_b, which cannot be read: export it without this extension.');
    expect(
      await gltf('{"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":7}}]}]}'),
    ).toMatch(/^a\.gltf (has no triangles|is not a valid glTF file)/);
  });

  it.each([[[{ children: [0] }]], [[{ children: [1] }, { children: [2] }, { children: [0] }]]])(
    'refuses cycles of nodes: %j',
    async (nodes) => {
      const json = JSON.stringify({ asset: { version: '2.0' }, nodes });
      expect(await failureOf(() => openModel([textFile('a.gltf', json)]))).toMatch(
        /^a\.gltf is not a valid glTF file \(node \d is its own descendant\): export it again\.$/,
      );
    },
  );

  it('refuses an accessor that ends far beyond its buffer', async () => {
    const [main, buffer, image] = separateGltf();
    const text = new TextDecoder().decode(main.bytes).replace('"count":3', '"count":3000');
    const message = await failureOf(() => openModel([textFile('model/test.gltf', text), buffer, image]));
    expect(message).toMatch(
      /^model\/test\.gltf is not a valid glTF file \(.*\): check it with the glTF validator\.$/,
    );
  });
});

describe('a damaged GLB', () => {
  it('is read or refused with one sentence, whichever byte is damaged', async () => {
    const document = startDocument();
    addRichMesh(document, 'rich', cube());
    const { bytes } = await glbFile(document);
    await fc.assert(
      fc.asyncProperty(
        fc.array(fc.tuple(fc.nat(), fc.nat(255)), { minLength: 1, maxLength: 4 }),
        async (hits) => {
          const damaged = bytes.slice();
          for (const [place, value] of hits) damaged[place % damaged.length] = value;
          const message = await failureOf(() => openModel([{ name: 'a.glb', bytes: damaged }]));
          expect(message === '' || /^a\.glb\b.*[.?]$/s.test(message) || message).toBe(true);
        },
      ),
      { numRuns: 1500, seed: 7 },
    );
  });

  it('is read or refused with one sentence, whichever number in its JSON is wrong', async () => {
    const document = startDocument();
    addRichMesh(document, 'rich', cube());
    const io = new WebIO().registerExtensions(ALL_EXTENSIONS);
    const { json, resources } = await io.writeJSON(document, { basename: 'a' });
    const text = JSON.stringify(json);
    const numbers = [...text.matchAll(/(?<=[:,[])-?\d+(\.\d+)?(?=[,}\]])/g)];
    const companions = Object.entries(resources).map(([name, bytes]) => ({ name, bytes }));
    await fc.assert(
      fc.asyncProperty(
        fc.nat(),
        fc.constantFrom('-1', '7', '99', '0.5', '65536', 'null', '"x"', '{}'),
        async (which, value) => {
          const { index, 0: old } = numbers[which % numbers.length];
          const changed = text.slice(0, index) + value + text.slice(index + old.length);
          const message = await failureOf(() => openModel([textFile('a.gltf', changed), ...companions]));
          expect(message === '' || /^a\.gltf\b.*[.?]$/s.test(message) || message).toBe(true);
        },
      ),
      { numRuns: 1500, seed: 8 },
    );
  });
});

describe('a set of files', () => {
  it('is refused if it contains no model, several models or no file', async () => {
    expect(await failureOf(() => openModel([]))).toBe(
      'There is no file: choose a GLB, glTF, OBJ, STL, PLY or OFF file.',
    );
    expect(await failureOf(() => openModel([textFile('notes.txt', 'hello')]))).toBe(
      'notes.txt is not a mesh that can be read: open a GLB, glTF, OBJ, STL, PLY or OFF file.',
    );
    expect(
      await failureOf(() => openModel([textFile('a.obj', SQUARE_OBJ), textFile('b.obj', SQUARE_OBJ)])),
    ).toBe('There are 2 models (a.obj, b.obj): open one at a time.');
    expect(await failureOf(() => openModel([textFile('a.obj', '')]))).toBe(
      'a.obj is empty: export it again.',
    );
  });

  it('may contain files that the model does not need', async () => {
    const { bodies } = await openModel([textFile('a.mtl', ''), textFile('a.obj', SQUARE_OBJ)]);
    expect(bodies[0].name).toBe('a');
  });
});
