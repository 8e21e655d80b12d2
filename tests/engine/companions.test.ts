import type { OpenModel } from '../../web/engine/document/open';
import { describe, expect, it } from 'vitest';
import { companionNames } from '../../web/engine/document/gltf';
import { companionPath } from '../../web/engine/document/checks/companions';
import { exportGlb } from '../../web/engine/document/export';
import { passThrough } from '../../web/engine/document/write/pass_through';
import { writeZip } from '../../web/engine/document/archive/write_zip';
import { glbParts } from '../../web/engine/document/glb';
import { openAnyModel, openModel } from '../../web/engine/document/open';
import type { SourceFile } from '../../web/engine/document/open';
import { validateGlb } from '../../web/engine/document/validate';
import { failureOf, textFile } from './support/files';
import { addMesh, addRichMesh, floats, glbFile, startDocument } from './support/gltf';
import { cube } from './support/shapes';

interface Json {
  asset: { generator?: string };
  images?: { uri?: string; bufferView?: number }[];
}

const jsonOf = (bytes: Uint8Array) =>
  JSON.parse(new TextDecoder().decode(glbParts({ name: 'a.glb', bytes }).json)) as Json;

/** A triangle whose buffer and image are at the given addresses, and the files. */
function triangleAt(buffer: string, image: string): SourceFile[] {
  const json = {
    asset: { version: '2.0' },
    buffers: [{ uri: buffer, byteLength: 36 }],
    bufferViews: [{ buffer: 0, byteLength: 36 }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 0] },
      { bufferView: 0, componentType: 5126, count: 3, type: 'VEC2' },
    ],
    images: [{ uri: image }],
    textures: [{ source: 0 }],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, TEXCOORD_0: 1 }, material: 0 }] }],
    nodes: [{ mesh: 0 }],
    scenes: [{ nodes: [0] }],
    scene: 0,
  };
  const positions = new Uint8Array(Float32Array.from([0, 0, 0, 1, 0, 0, 0, 1, 0]).buffer);
  return [textFile('test.gltf', JSON.stringify(json)), { name: 'data.bin', bytes: positions }];
}

async function passOn(model: OpenModel, bytes: Uint8Array): Promise<Uint8Array> {
  const form = { format: 'glb', isZipped: false } as const;
  return (await passThrough(model, bytes, { name: 'out.glb', form }))[0].bytes;
}

describe('a companion that is not at its path', () => {
  const moved = (files: SourceFile[], name: string): SourceFile[] => [files[0], { ...files[1], name }];

  it('is found by its name if it came without a folder', async () => {
    const model = await openModel(moved(triangleAt('parts/data.bin', 'wood.png'), 'data.bin'));
    expect(model.bodies).toHaveLength(1);
  });

  it('may have a percent sign in its name, before two digits', async () => {
    const files = moved(triangleAt('50%2520off.bin', 'wood.png'), '50%20off.bin');
    expect((await openModel(files)).bodies).toHaveLength(1);
  });

  it('is not replaced by a file of that name from another folder', async () => {
    const files = moved(triangleAt('a/data.bin', 'wood.png'), 'b/data.bin');
    expect(await failureOf(() => openModel(files))).toMatch(/^test.gltf needs a\/data.bin, which is missing/);
  });

  it('is not replaced by a file that another address refers to', async () => {
    const [main, data] = triangleAt('data.bin', 'a/data.bin');
    const model = await openModel([main, data]);
    expect(model.notes.join()).toContain('texture (a/data.bin) is missing');
  });
});

describe('the address of a companion', () => {
  it.each([
    ['data.bin', 'data.bin'],
    ['./parts//my%20data.bin', 'parts/my data.bin'],
    ['parts\\data.bin', 'parts/data.bin'],
    ['parts/../data.bin', 'data.bin'],
    ['100%.bin', '100%.bin'],
    ['%252e%252e/data.bin', '%2e%2e/data.bin'],
  ])('%s is %s, below the folder', (uri, path) => {
    expect(companionPath('', uri)).toBe(path);
  });

  it.each([
    '../data.bin',
    'parts/../../data.bin',
    '..\\data.bin',
    '%2e%2e/data.bin',
    '%2e%2e%2fdata.bin',
    '..%5cdata.bin',
    '/etc/passwd',
    '%2fetc/passwd',
    '\\\\server\\share\\data.bin',
    'file:///etc/passwd',
    'FILE:data.bin',
    'https://example.org/data.bin',
    'C:\\data.bin',
    'c:data.bin',
    'data.bin\0.png',
    'data.bin%00.png',
    '.',
    'parts/..',
  ])('%j is outside of the folder or no file', (uri) => {
    expect(companionPath('', uri)).toBeNull();
    expect(companionNames(triangleAt(uri, uri)[0])).toEqual([]);
  });

  it('may go up within the folders in the names of all files', () => {
    expect(companionPath('set/models/a.gltf', '../skins/b.png')).toBe('set/skins/b.png');
    expect(companionPath('set/models/a.gltf', '../../../b.png')).toBeNull();
  });

  it('outside of the folder is refused for a buffer, whatever files are given', async () => {
    const [main, data] = triangleAt('../data.bin', 'skin.png');
    expect(await failureOf(() => openModel([main, data]))).toBe(
      'test.gltf refers to ../data.bin, which is outside its folder and is therefore not read: put the file beside it and refer to it without a path.',
    );
  });
});

describe('a missing image', () => {
  it.each([
    ['skins/my%20skin.png', 'skins/my skin.png'],
    ['a%0Ab.png', 'a%0Ab.png'],
    ['../skin.jpg', '../skin.jpg'],
    ['https://example.org/skin.png', 'https://example.org/skin.png'],
  ])('stays a reference to %s, and is said under the name %s', async (uri, name) => {
    const model = await openModel(triangleAt('data.bin', uri));
    expect(model.notes).toEqual([
      `1 texture (${name}) is missing or outside the folder: the result only refers to it`,
    ]);
    const bytes = await exportGlb(model, [null], { fields: false });
    expect(jsonOf(bytes).images).toMatchObject([{ uri }]);
    expect(await validateGlb(bytes)).toMatchObject({ errors: 0 });
    const again = await openModel([{ name: 'out.glb', bytes }]);
    expect(again.document.getRoot().listMaterials()[0].getBaseColorTexture()!.getURI()).toBe(uri);
  });

  it('is named with others up to five', async () => {
    const [main, data] = triangleAt('data.bin', 'a.png');
    const json = JSON.parse(new TextDecoder().decode(main.bytes)) as Json;
    json.images = Array.from({ length: 7 }, (_, i) => ({ uri: `${i}.png` }));
    const { notes } = await openModel([textFile('test.gltf', JSON.stringify(json)), data]);
    expect(notes).toEqual([
      '7 textures (0.png, 1.png, 2.png, 3.png, 4.png and 2 more) are missing or outside the folder: the result only refers to them',
    ]);
  });
});

describe('a glTF without triangles', () => {
  it('is passed on from a ZIP', async () => {
    const source = startDocument();
    const points = source.createPrimitive().setMode(0);
    addMesh(source, 'dots', [points.setAttribute('POSITION', floats(source, 'VEC3', [0, 0, 0, 1, 1, 1]))]);
    const archive = { name: 'dots.zip', bytes: writeZip([await glbFile(source, 'dots.glb')], 'a test') };
    const model = await openAnyModel([archive]);
    const bytes = await passOn(model, archive.bytes);
    const again = await openAnyModel([{ name: 'out.glb', bytes }]);
    expect(again.notes).toEqual(model.notes);
  });

  const points = () => {
    const document = startDocument();
    const positions = floats(document, 'VEC3', [0, 0, 0, 1, 0, 0]);
    addMesh(document, 'dots', [document.createPrimitive().setAttribute('POSITION', positions).setMode(0)]);
    return glbFile(document);
  };

  it('opens without bodies where that is allowed, and is refused elsewhere', async () => {
    const file = await points();
    expect((await openAnyModel([file])).bodies).toEqual([]);
    expect(await failureOf(() => openModel([file]))).toMatch(/^test\.glb has no triangles \(mesh "dots"/);
  });

  it('passes through with nothing changed but the name of the program', async () => {
    const file = await points();
    const bytes = await passOn(await openAnyModel([file]), file.bytes);
    const [before, after] = [file.bytes, bytes].map((glb) => glbParts({ name: 'a.glb', bytes: glb }));
    expect(after.binary).toEqual(before.binary);
    const [old, now] = [jsonOf(file.bytes), jsonOf(bytes)];
    expect(now.asset.generator).toMatch(/^Limber \d/);
    expect({ ...now, asset: old.asset }).toEqual(old);
    expect(await validateGlb(bytes)).toMatchObject({ errors: 0 });
  });

  it('is packed into one file where it has several', async () => {
    const files = triangleAt('data.bin', 'skin.png');
    const text = new TextDecoder().decode(files[0].bytes).replace('"material":0', '"material":0,"mode":0');
    const model = await openAnyModel([textFile('test.gltf', text), files[1]]);
    const bytes = await passOn(model, files[0].bytes);
    expect(await validateGlb(bytes)).toMatchObject({ errors: 0 });
    expect(glbParts({ name: 'a.glb', bytes }).binary!.length).toBeGreaterThanOrEqual(36);
    expect(jsonOf(bytes).images).toMatchObject([{ uri: 'skin.png' }]);
  });

  it('has one note for all meshes without triangles', async () => {
    const document = startDocument();
    for (const name of ['a', 'b', 'c', 'd', 'e', 'f']) addMesh(document, name, []);
    addRichMesh(document, 'cube', cube());
    const { notes } = await openModel([await glbFile(document)]);
    expect(notes[0]).toBe('6 meshes ("a", "b", "c", "d", "e", ...) have no triangles');
  });
});

it('a texture without any image is left out with a note, also one that is transformed', async () => {
  const [{ bytes }, data] = triangleAt('data.bin', 'wood.png');
  const json = JSON.parse(new TextDecoder().decode(bytes)) as Record<string, unknown>;
  const transform = { KHR_texture_transform: { scale: [2, 2] } };
  const open = (textures: object[]) =>
    openModel([
      textFile(
        'test.gltf',
        JSON.stringify({
          ...json,
          ...{ textures, extensionsUsed: ['KHR_texture_transform', 'MY_image'] },
          materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0, extensions: transform } } }],
        }),
      ),
      data,
    ]);
  const note = '1 texture has no image that can be read: the result is without it';
  for (const texture of [{}, { extensions: { MY_image: { source: 0 } } }]) {
    const model = await open([texture]);
    expect(model.notes.at(-1)).toBe(note);
    expect((await validateGlb(await exportGlb(model, [null], { fields: false }))).errors).toBe(0);
  }
  expect((await open([{ source: 0 }, {}])).notes.at(-1)).toMatch(/^1 texture \(wood\.png\) is missing/);
});

it('a texture whose image has neither file nor view is left out with a note', async () => {
  const [{ bytes }, data] = triangleAt('data.bin', 'wood.png');
  const json = JSON.parse(new TextDecoder().decode(bytes)) as Record<string, unknown>;
  const open = (changes: object) =>
    openModel([textFile('test.gltf', JSON.stringify({ ...json, ...changes })), data]);
  const written = async (model: OpenModel) => {
    const result = await exportGlb(model, [null], { fields: false });
    return { errors: (await validateGlb(result)).errors, images: jsonOf(result).images };
  };
  const materials = [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }];
  for (const image of [{}, { name: 'a' }, { uri: '' }, { mimeType: 'image/png' }]) {
    const used = await open({ materials, images: [image], textures: [{ source: 0 }] });
    expect(used.notes.at(-1)).toBe('1 texture has no image that can be read: the result is without it');
    expect(await written(used)).toEqual({ errors: 0, images: undefined });
    const unused = await open({ materials, images: [image, { uri: 'wood.png' }], textures: [{ source: 1 }] });
    expect(unused.notes.at(-1)).toMatch(/^1 texture \(wood\.png\) is missing/);
    expect(await written(unused)).toMatchObject({ images: [{ uri: 'wood.png' }] });
  }
  const webp = await open({
    ...{ materials, images: [{}, { uri: 'wood.webp' }], extensionsUsed: ['EXT_texture_webp'] },
    textures: [{ source: 0, extensions: { EXT_texture_webp: { source: 1 } } }],
  });
  expect(webp.document.getRoot().listMaterials()[0].getBaseColorTexture()!.getURI()).toBe('wood.webp');
  // Numbers of images stay where an extension may refer to them.
  const foreign = await open({ materials, images: [{ name: 'a' }], extensionsUsed: ['MY_image'] });
  expect((await written(foreign)).images).toEqual([{ name: 'a' }]);
});

it('data URIs are read in base64, in any case, and percent-encoded', async () => {
  const [{ bytes }, data] = triangleAt('data.bin', 'wood.png');
  const text = new TextDecoder().decode(bytes);
  const letters = String.fromCharCode(...data.bytes);
  const escaped = [...data.bytes].map((byte) => `%${byte.toString(16).padStart(2, '0')}`).join('');
  const addresses = [
    `data:application/octet-stream;base64,${btoa(letters)}`,
    `data:;BASE64,${btoa(letters)}`,
    `data:application/octet-stream,${escaped}`,
    `data:,${escaped.replaceAll('%3f', '?')}`,
  ];
  const [{ bodies }] = [await openModel(triangleAt('data.bin', 'wood.png'))];
  for (const address of addresses) {
    const model = await openModel([textFile('test.gltf', text.replace('data.bin', address))]);
    expect(model.bodies[0].positions).toEqual(bodies[0].positions);
  }
});

it('a fallback image for viewers without WebP is left out with a note, and WebP is required', async () => {
  const [{ bytes }, data] = triangleAt('data.bin', 'wood.png');
  const json = JSON.parse(new TextDecoder().decode(bytes)) as Record<string, unknown>;
  const model = await openModel([
    textFile(
      'test.gltf',
      JSON.stringify({
        ...json,
        extensionsUsed: ['EXT_texture_webp'],
        images: [{ uri: 'wood.png' }, { uri: 'wood.webp' }],
        textures: [{ source: 0, extensions: { EXT_texture_webp: { source: 1 } } }],
      }),
    ),
    data,
    { name: 'wood.webp', bytes: new TextEncoder().encode('RIFF....WEBPVP8 ') },
  ]);
  expect(model.notes.at(-1)).toBe('1 texture has a second image for older viewers, which is left out');
  const written = jsonOf(await exportGlb(model, [null], { fields: false }));
  expect(written).toMatchObject({ extensionsRequired: ['EXT_texture_webp'] });
});
