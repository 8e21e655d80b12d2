/** Fuzz targets of the readers: files that were valid once, changed in up to eight places. */

import { Document } from '@gltf-transform/core';
import { zipSync } from 'fflate';
import { PNG_MARK } from '../../../web/engine/document/formats/png_chunks';
import type { SourceFile } from '../../../web/engine/document/model';
import { openAnyModel, openModel } from '../../../web/engine/document/open';
import { validateFiles } from '../../../web/engine/document/validate';
import { exportFiles } from '../../../web/engine/document/write/export_files';
import { formOfName } from '../../../web/engine/document/write/output_form';
import { addMesh, addRichMesh, glbFile, primitiveOf, startDocument } from '../../engine/support/gltf';
import { asResult } from '../../engine/support/results';
import { cube, grid, toObj } from '../../engine/support/shapes';
import type { Choices } from './choices';
import type { FuzzTarget } from './fuzz_target';
import { mutateFile, mutateGlbJson, mutateJson, mutateText, partsOfGlb } from './mutate';

/** Of one white pixel, without its pixels: mark, header with colour type 6, end. */
const PNG = [
  ...[...PNG_MARK, 0, 0, 0, 13, 0x49, 0x48, 0x44, 0x52, 0, 0, 0, 1],
  ...[0, 0, 0, 1, 8, 6, 0, 0, 0, 0x1f, 0x15, 0xc4, 0x89, 0, 0, 0, 0, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42],
  ...[0x60, 0x82],
];

const encode = (text: string) => new TextEncoder().encode(text);

const OBJ = `mtllib a.mtl\no one\n${toObj(grid(2, 2))}vn 0 0 1\nvt 0 1\ng two\nusemtl red\ns 1\nf 1/1/1 2/1/1 5/1/1 4/1/1\nf -1 -2 -3\nl 1 2\np 1\n`;

const PLY = [
  'ply',
  'format ascii 1.0',
  'comment a square',
  'element vertex 4',
  ...['x', 'y', 'z'].map((name) => `property float ${name}`),
  'property uchar red',
  'element face 2',
  'property list uchar int vertex_indices',
  'end_header',
  '0 0 0 255\n1 0 0 255\n1 1 0 0\n0 1 0 0\n3 0 1 2\n3 0 2 3\n',
].join('\n');

const STL = `solid a\n${'facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n'.repeat(2)}endsolid a\n`;

const OFF = 'OFF\n# a square\n4 2 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n4 0 1 2 3\n';

/** The PLY of `PLY` in binary. */
function binaryPly(): Uint8Array {
  const header = encode(PLY.slice(0, PLY.indexOf('0 0 0 255')).replace('ascii', 'binary_little_endian'));
  const bytes = new Uint8Array(header.length + 4 * 13 + 2 * 13);
  bytes.set(header);
  const view = new DataView(bytes.buffer, header.length);
  for (let v = 0; v < 4; ++v) {
    view.setFloat32(13 * v, v === 1 || v === 2 ? 1 : 0, true);
    view.setFloat32(13 * v + 4, v > 1 ? 1 : 0, true);
  }
  [0, 1, 2, 0, 2, 3].forEach((corner, i) => {
    const start = 52 + 13 * Math.floor(i / 3);
    view.setUint8(start, 3);
    view.setUint32(start + 1 + 4 * (i % 3), corner, true);
  });
  return bytes;
}

function binaryStl(): Uint8Array {
  const bytes = new Uint8Array(84 + 50 * 2);
  const view = new DataView(bytes.buffer);
  view.setUint32(80, 2, true);
  for (let t = 0; t < 2; ++t) {
    view.setFloat32(84 + 50 * t + 24, 1, true);
    view.setFloat32(84 + 50 * t + 40, 1, true);
  }
  return bytes;
}

async function glbs(): Promise<Uint8Array[]> {
  const documents: Document[] = [startDocument(), startDocument()];
  addMesh(documents[0], 'plain', [primitiveOf(documents[0], cube())]);
  addRichMesh(documents[1], 'rich', cube());
  return Promise.all(documents.map(async (document) => (await glbFile(document)).bytes));
}

/** The GLBs as the product compresses them: quantized, by meshopt, by Draco. */
async function compressed(seeds: Uint8Array[]): Promise<Uint8Array[]> {
  const written: Uint8Array[] = [];
  for (const bytes of seeds)
    for (const compression of ['quantized', 'meshopt', 'draco'] as const) {
      const model = await openModel([{ name: 'a.glb', bytes }]);
      const bodies = model.bodies.map((body) => ({ first: asResult(body), further: [] }));
      const [file] = await exportFiles(model, bodies, {
        name: 'a.glb',
        form: formOfName('a.glb', model.format)!,
        manner: { compression, style: 'files', keepsOrder: false },
        fields: false,
      });
      written.push(file.bytes);
    }
  return written;
}

type Change = (bytes: Uint8Array, choices: Choices) => Uint8Array;

function reader(name: string, ending: string, seeds: Uint8Array[], change: Change): FuzzTarget {
  return {
    name,
    run: async (choices) => {
      const bytes = change(choices.pick(seeds), choices);
      await openAnyModel([{ name: `a.${ending}`, bytes }]);
    },
  };
}

/** A .gltf and its buffer, of which either is changed. */
const gltfFiles = (seeds: Uint8Array[]): FuzzTarget => ({
  name: 'gltf',
  run: async (choices) => {
    const { json, chunk } = partsOfGlb(choices.pick(seeds));
    let buffer = chunk.subarray(8);
    const buffers = (json as { buffers: { uri?: string }[] }).buffers;
    buffers[0].uri = choices.pick([
      'a.bin',
      'a.bin',
      `data:;base64,${Buffer.from(buffer).toString('base64')}`,
    ]);
    let words = JSON.stringify(mutateJson(json, choices.below(4), choices));
    if (choices.chance(0.2)) words = mutateText(words, choices);
    if (choices.chance(0.3)) buffer = mutateFile(buffer, choices, false);
    const files: SourceFile[] = [{ name: 'a.gltf', bytes: encode(words) }];
    if (choices.chance(0.9)) files.push({ name: choices.pick(['a.bin', 'b/a.bin']), bytes: buffer });
    await openAnyModel(files);
  },
});

const NAMES = [
  'a.obj',
  'a.mtl',
  'b/a.obj',
  '../a.obj',
  '/a.obj',
  'C:\\a.obj',
  '',
  '.a',
  'a.zip',
  '__proto__',
  '😀.off',
];

/** An archive with members of any name, whose bytes are changed, too. */
const zip: FuzzTarget = {
  name: 'zip',
  run: async (choices) => {
    const members: Record<string, Uint8Array> = choices.chance(0.8) ? { 'a.obj': encode(OBJ) } : {};
    for (let left = choices.below(4); left > 0; --left)
      members[choices.pick(NAMES)] = mutateFile(encode(choices.pick([OBJ, OFF, PLY])), choices, true);
    const level = choices.pick([0, 6] as const);
    const bytes = zipSync(members, { level });
    await openAnyModel([
      { name: 'a.zip', bytes: choices.chance(0.7) ? mutateFile(bytes, choices, false) : bytes },
    ]);
  },
};

const TEXTURED_OBJ = [
  ...['mtllib a.mtl', 'v 0 0 0', 'v 1 0 0', 'v 0 1 0', 'v 0 0 1', 'vt 0 0', 'vt 1 0', 'vt 0 1'],
  ...['usemtl red', 'f 1/1 2/2 3/3', 'usemtl steel', 'f 1/1 3/2 4/3', 'usemtl plain', 'f 1 2 4', ''],
].join('\n');

const MTL = [
  ...['newmtl red', 'Kd 0.8 0.2 0.1', 'Ks 0.5 0.5 0.5', 'Ns 250', 'd 0.5', 'Tr 0.5', 'illum 2'],
  ...['map_Kd -s 2 2 1 -o 0.5 0 0 -clamp on a.png', 'map_d a.png', 'bump -bm 0.5 a_normal.jpg'],
  ...['newmtl steel', 'Pr 0.2', 'Pm 1', 'Ke 2 1 0', 'map_Ke a.jpg', 'norm -bm 2 b/a.png'],
  ...['map_Pr a.png', 'map_Pm a.png', 'newmtl plain', 'Kd 1 1 1', 'map_Kd "a b.png"', ''],
].join('\n');

/** Beginnings of pictures, of which no reader looks at more. */
const PICTURES: SourceFile[] = [
  ...['a.png', 'b/a.png', 'a b.png'].map((name) => ({ name, bytes: Uint8Array.from(PNG) })),
  ...['a.jpg', 'a_normal.jpg'].map((name) => ({ name, bytes: Uint8Array.of(0xff, 0xd8, 0xff, 0xe0) })),
];

/** A material library and a picture of it, of which either is changed; whatever they say, the result is valid. */
const mtl: FuzzTarget = {
  name: 'mtl',
  run: async (choices) => {
    const pictures = PICTURES.map((one) =>
      choices.chance(0.1) ? { ...one, bytes: mutateFile(one.bytes, choices, false) } : one,
    );
    const model = await openAnyModel([
      { name: 'a.obj', bytes: encode(TEXTURED_OBJ) },
      { name: 'a.mtl', bytes: mutateFile(encode(MTL), choices, true) },
      ...pictures.filter(() => choices.chance(0.9)),
    ]);
    const files = await exportFiles(model, [null], {
      name: 'a.glb',
      form: formOfName('a.glb', model.format)!,
      manner: { compression: 'none', style: 'files', keepsOrder: false },
      fields: false,
    });
    const { messages = [], errors = 0 } = (await validateFiles(files)) ?? {};
    const own = messages.slice(0, errors).filter((message) => !message.startsWith('IMAGE_'));
    if (own.length > 0) throw new TypeError(`The result is not valid: ${own[0]}`);
  },
};

const asText: Change = (bytes, choices) => mutateFile(bytes, choices, true);
const asBytes: Change = (bytes, choices) => mutateFile(bytes, choices, false);

export async function readers(): Promise<FuzzTarget[]> {
  const seeds = await glbs();
  const packed = await compressed(seeds);
  return [
    reader('obj', 'obj', [encode(OBJ)], asText),
    reader('ply', 'ply', [encode(PLY)], asText),
    reader('binary ply', 'ply', [binaryPly()], asBytes),
    reader('stl', 'stl', [encode(STL)], asText),
    reader('binary stl', 'stl', [binaryStl()], asBytes),
    reader('off', 'off', [encode(OFF)], asText),
    mtl,
    zip,
    gltfFiles(seeds),
    reader('glb bytes', 'glb', seeds, asBytes),
    reader('glb json', 'glb', seeds, mutateGlbJson),
    reader('compressed glb bytes', 'glb', packed, asBytes),
    reader('compressed glb json', 'glb', packed, mutateGlbJson),
  ];
}
