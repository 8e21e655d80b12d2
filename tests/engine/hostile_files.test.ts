/** Files that are damaged or made to do harm: opened, or refused with one sentence, in little time and memory. */

import fc from 'fast-check';
import { existsSync, readFileSync, statSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { beforeAll, describe, expect, it } from 'vitest';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { Logger, WebIO } from '@gltf-transform/core';
import { companionNames } from '../../web/engine/document/gltf';
import { openAnyModel } from '../../web/engine/document/open';
import type { SourceFile } from '../../web/engine/document/open';
import { SQUARE_OBJ, textFile } from './support/files';
import { addRichMesh, glbFile, startDocument } from './support/gltf';
import { cube, grid, toObj, torus } from './support/shapes';
import { processorTime } from './support/processor_time';

const shared = join(
  process.env.LIMBER_SHARED ?? join(new URL('../../', import.meta.url).pathname, '..', 'shared'),
  'meshes',
);
const isAbsent = !existsSync(shared);

/** Far above what these small files need, and far below what one of them once took. */
const MAX_SECONDS = 5;
const MAX_MEGABYTES = 400;

/** Words of the program about itself, which tell a user nothing. */
const CODE =
  /undefined|NaN\b.*of|is not a function|is not iterable|Cannot |TypeError|RangeError|Invalid (typed )?array|out of bounds|\[object|=>|Unexpected token|\bat position\b|offset is out|Maximum call stack|internal error/;

/** Opens the files and checks time, memory and words; returns the sentence, '' where they could be read. */
async function tryOpen(files: SourceFile[]): Promise<string> {
  const [before, seconds] = [process.memoryUsage(), processorTime()];
  let message = '';
  try {
    await openAnyModel(files);
  } catch (error) {
    expect((error as Error).constructor, String((error as Error).stack)).toBe(Error);
    ({ message } = error as Error);
    // What is quoted from the file is not the program's.
    const own = message.replace(/"[^"]*"/g, '""');
    expect(own, message).not.toMatch(CODE);
    expect(message).toMatch(/[.?]$/);
    expect(message.split('\n')).toHaveLength(1);
    expect(message.length).toBeLessThan(600);
  }
  expect(seconds(), message).toBeLessThan(MAX_SECONDS);
  const after = process.memoryUsage();
  const grown = after.heapUsed + after.arrayBuffers - before.heapUsed - before.arrayBuffers;
  expect(grown / 2 ** 20, message).toBeLessThan(MAX_MEGABYTES);
  return message;
}

const glTF = (json: object): SourceFile =>
  textFile('a.gltf', JSON.stringify({ asset: { version: '2.0' }, ...json }));

const BYTES = `data:application/octet-stream;base64,${btoa('\0'.repeat(240))}`;
const buffers = [{ uri: BYTES, byteLength: 240 }];
const bufferViews = [{ buffer: 0, byteLength: 240 }];
const meshes = [{ primitives: [{ attributes: { POSITION: 0 } }] }];
const accessor = { componentType: 5126, type: 'VEC3' };

const XYZ = 'property float x\nproperty float y\nproperty float z\n';

describe('a count that the file has no bytes for is refused', () => {
  const sparse = {
    count: 1,
    indices: { bufferView: 0, componentType: 5125 },
    values: { bufferView: 0 },
  };
  it.each([
    [
      'of an accessor',
      { buffers, bufferViews, meshes, accessors: [{ ...accessor, bufferView: 0, count: 6e8 }] },
    ],
    [
      'of a sparse accessor',
      { buffers, bufferViews, meshes, accessors: [{ ...accessor, count: 6e8, sparse }] },
    ],
    [
      'of sparse values',
      {
        buffers,
        bufferViews,
        meshes,
        accessors: [{ ...accessor, count: 6e8, bufferView: 0, sparse: { ...sparse, count: 5e8 } }],
      },
    ],
    ['of an accessor without data', { meshes, accessors: [{ ...accessor, count: 3e9 }] }],
    [
      'of many accessors without data',
      { buffers, bufferViews, meshes, accessors: Array(2000).fill({ ...accessor, count: 1e6, sparse }) },
    ],
    [
      'with a stride of 0',
      {
        buffers,
        bufferViews: [{ ...bufferViews[0], byteStride: 0 }],
        meshes,
        accessors: [{ ...accessor, bufferView: 0, count: 6e8 }],
      },
    ],
    [
      'of compressed data',
      {
        extensionsUsed: ['EXT_meshopt_compression'],
        buffers,
        bufferViews: [
          {
            ...bufferViews[0],
            extensions: {
              EXT_meshopt_compression: {
                buffer: 0,
                byteLength: 240,
                byteStride: 12,
                count: 6e8,
                mode: 'ATTRIBUTES',
              },
            },
          },
        ],
        meshes,
        accessors: [{ ...accessor, bufferView: 0, count: 6e8 }],
      },
    ],
  ])('%s', async (_, json) => {
    expect(await tryOpen([glTF(json)])).toMatch(/^a\.gltf is not a valid glTF file \(.*\d.*\): check it/);
  });

  it('of accessors that read the same data over and over', async () => {
    const data = `data:;base64,${btoa('\0'.repeat(120_000))}`;
    const json = {
      buffers: [{ uri: data, byteLength: 120_000 }],
      bufferViews: [{ buffer: 0, byteLength: 120_000 }],
      accessors: Array(5000).fill({ ...accessor, bufferView: 0, count: 10_000 }),
    };
    expect(await tryOpen([glTF(json)])).toMatch(/read the same data over and over/);
  });

  it('of meshes that repeat the same data', async () => {
    const data = `data:;base64,${btoa('\0'.repeat(120_000))}`;
    const json = {
      buffers: [{ uri: data, byteLength: 120_000 }],
      bufferViews: [{ buffer: 0, byteLength: 120_000 }],
      accessors: [{ ...accessor, bufferView: 0, count: 10_000, min: [0, 0, 0], max: [0, 0, 0] }],
      meshes: Array(10_000).fill(meshes[0]),
    };
    expect(await tryOpen([glTF(json)])).toMatch(/repeat its data too often/);
  });

  it.each([
    ['ply\nformat binary_little_endian 1.0\nelement face 4000000000\nend_header\n'],
    [`ply\nformat ascii 1.0\nelement nothing 4000000000\nelement vertex 1\n${XYZ}end_header\n1 1 1\n`],
    [`ply\nformat ascii 1.0\nelement vertex 4000000000\n${XYZ}end_header\n1 1 1\n`],
  ])('of elements of a PLY: %j', async (text) => {
    expect(await tryOpen([textFile('a.ply', text)])).toMatch(/do not fit into the file/);
  });

  it.each(['-3', '2.5', '1e300'])('of a list of %s corners', async (length) => {
    const header = `ply\nformat ascii 1.0\nelement vertex 1\n${XYZ}element face 1\n`;
    const text = `${header}property list float int vertex_indices\nend_header\n0 0 0\n${length} 0 0 0\n`;
    expect(await tryOpen([textFile('a.ply', text)])).toMatch(/not the length of a list|ends too early/);
  });
});

describe('a file that once took minutes', () => {
  it('with a face of 100,000 corners opens at once', async () => {
    const corners = Array.from({ length: 100_000 }, (_, i) => (2 * Math.PI * i) / 100_000);
    const vertices = corners.map((angle) => `v ${Math.cos(angle)} ${Math.sin(angle)} 0`);
    const text = `${vertices.join('\n')}\nf ${corners.map((_, i) => i + 1).join(' ')}\n`;
    expect(await tryOpen([textFile('a.obj', text)])).toBe('');
  });

  it('with a concave face of 100,000 corners is refused at once', async () => {
    const vertices = Array.from(
      { length: 100_000 },
      (_, i) => `v ${(i * 7919) % 100_003} ${(i * i) % 99_991} 0`,
    );
    const text = `${vertices.join('\n')}\nf ${vertices.map((_, i) => i + 1).join(' ')}\n`;
    expect(await tryOpen([textFile('a.obj', text)])).toMatch(
      /^a\.obj, line 100001: a face that is not convex has 100,000 corners/,
    );
  });

  it('with 50,000 texture coordinates at one vertex opens at once', async () => {
    const uvs = Array.from({ length: 50_000 }, (_, i) => `vt ${i} 0`).join('\n');
    const faces = Array.from({ length: 50_000 }, (_, i) => `f 1/${i + 1} 2/1 3/1`).join('\n');
    expect(await tryOpen([textFile('a.obj', `v 0 0 0\nv 1 0 0\nv 0 1 0\n${uvs}\n${faces}\n`)])).toBe('');
  });

  it('with 10,000 objects opens in little memory', async () => {
    const objects = Array.from({ length: 10_000 }, (_, i) => `o ${i}\nf 1 2 3`).join('\n');
    expect(await tryOpen([textFile('a.obj', `v 0 0 0\nv 1 0 0\nv 0 1 0\n${objects}\n`)])).toBe('');
  });

  it('with 20,000 nodes below each other is refused at once', async () => {
    const count = 20_000;
    const json = {
      buffers,
      bufferViews,
      accessors: [{ ...accessor, bufferView: 0, count: 3, min: [0, 0, 0], max: [0, 0, 0] }],
      meshes: Array(count).fill(meshes[0]),
      nodes: Array.from({ length: count }, (_, i) => ({
        mesh: i,
        children: i + 1 < count ? [i + 1] : undefined,
      })),
      scenes: [{ nodes: [0] }],
    };
    expect(await tryOpen([glTF(json)])).toBe(
      'a.gltf has nodes more than 1000 levels deep: flatten it and export it again.',
    );
  });
});

describe('a file of another kind gets its sentence', () => {
  it.each([
    ['a.gltf', '{"asset":{"version":"1.0"},"meshes":{"a":{}}}'],
    ['a.gltf', '{"meshes":{"a":{}},"nodes":{},"accessors":{}}'],
  ])('%s of the first version: %s', async (name, text) => {
    expect(await tryOpen([textFile(name, text)])).toBe(
      'a.gltf is glTF 1.0: convert it to glTF 2.0, as gltf-pipeline does.',
    );
    expect(() => companionNames(textFile(name, text))).toThrow(/is glTF 1\.0/);
  });

  it('a GLB of the first version', async () => {
    const { bytes } = await glbFile(startDocument());
    bytes[4] = 1;
    expect(await tryOpen([{ name: 'a.glb', bytes }])).toMatch(/^a\.glb is glTF 1\.0: convert/);
  });

  const wide = (text: string, mark: boolean, isBig: boolean) => {
    const bytes = new Uint8Array(Buffer.from((mark ? '\ufeff' : '') + text, 'utf16le'));
    return isBig ? new Uint8Array(Buffer.from(bytes).swap16()) : bytes;
  };
  const PLY = 'ply\nformat ascii 1.0\nelement vertex 3\n';
  it.each([
    ['a.obj', SQUARE_OBJ],
    ['a.gltf', '{"asset":{"version":"2.0"}}'],
    ['a.ply', PLY],
    ['a.stl', 'solid a\n  facet normal 0 0 1\n'],
  ])('%s in UTF-16', async (name, text) => {
    for (const mark of [true, false])
      for (const isBig of [true, false])
        expect(await tryOpen([{ name, bytes: wide(text, mark, isBig) }])).toBe(
          `${name} is text in UTF-16 or UTF-32: save it as UTF-8.`,
        );
  });

  it('a file without an ending, recognised by its first bytes', async () => {
    const { bytes } = await glbFile(startDocument());
    const open = async (content: Uint8Array) =>
      (await openAnyModel([{ name: 'stdin', bytes: content }])).format;
    expect(await open(bytes)).toBe('glb');
    expect(await open(textFile('', SQUARE_OBJ).bytes)).toBe('obj');
    expect(await open(textFile('', ' {"asset":{"version":"2.0"}}').bytes)).toBe('gltf');
    const facet = 'facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet';
    expect(await open(textFile('', `solid a\n${facet}\nendsolid a\n`).bytes)).toBe('stl');
    expect(await tryOpen([textFile('stdin', 'hello')])).toMatch(/^stdin is not a mesh that can be read/);
  });
});

/** Values that a damaged or hostile JSON may have anywhere. */
const ODD: unknown[] = [
  -1,
  0.5,
  7,
  4294967295,
  1e300,
  null,
  true,
  '',
  'x',
  '../x',
  [],
  {},
  [[]],
  [null],
  [{}],
];

/** The text of a JSON value with one of its parts replaced by something odd, or without it. */
function withOdd(json: unknown, which: number, odd: unknown): string {
  let count = 0;
  JSON.stringify(json, (_, value: unknown) => (++count, value));
  let at = -1;
  return JSON.stringify(json, (_, value: unknown) => (++at === 1 + (which % (count - 1)) ? odd : value));
}

/** Cuts, changes, repeats and swaps bytes. */
const damage = fc.array(fc.tuple(fc.constantFrom('set', 'cut', 'repeat', 'insert'), fc.nat(), fc.nat(255)), {
  minLength: 1,
  maxLength: 4,
});

function damaged(bytes: Uint8Array, hits: [string, number, number][]): Uint8Array {
  let changed = bytes.slice();
  for (const [kind, place, value] of hits) {
    const at = changed.length === 0 ? 0 : place % changed.length;
    if (kind === 'set') changed[at] = value;
    else if (kind === 'cut') changed = changed.slice(0, at);
    else if (kind === 'repeat')
      changed = Uint8Array.from([...changed.slice(0, at), ...changed.slice(at >> 1)]);
    else changed = Uint8Array.from([...changed.slice(0, at), value, value, ...changed.slice(at)]);
  }
  return changed;
}

/** Numbers in a text replaced by others that are larger, negative or none. */
const ODD_NUMBERS = [
  '-1',
  '0',
  '1e300',
  '99999999999',
  '4294967296',
  'nan',
  'inf',
  '1e-400',
  '',
  '0x10',
  '1/2/3',
];

function withOddNumber(text: string, which: number, odd: string): string {
  const numbers = [...text.matchAll(/-?\d+(\.\d+)?/g)];
  if (numbers.length === 0) return odd;
  const { index, 0: old } = numbers[which % numbers.length];
  return text.slice(0, index) + odd + text.slice(index + old.length);
}

const PLY_BINARY = (() => {
  const header =
    'ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n' +
    'element face 1\nproperty list uchar int vertex_indices\nend_header\n';
  const body = new DataView(new ArrayBuffer(4 * 12 + 17));
  [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0].forEach((value, i) => body.setFloat32(4 * i, value, true));
  body.setUint8(48, 4);
  [0, 1, 2, 3].forEach((value, i) => body.setInt32(49 + 4 * i, value, true));
  return Uint8Array.from([...new TextEncoder().encode(header), ...new Uint8Array(body.buffer)]);
})();
const PLY_TEXT =
  'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n' +
  'property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n';
const STL_TEXT =
  'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n';
const OBJ_TEXT = `mtllib a.mtl\nvt 0 0\nvt 1 1\nvn 0 0 1\no a\nusemtl m\n${SQUARE_OBJ}f -4/1/1 -3/2/1 -2/1/1 -1/2/1\n`;

describe('a mutated file is opened or refused with a sentence', () => {
  let glb: SourceFile;
  let json: object;
  let companions: SourceFile[];

  beforeAll(async () => {
    const document = startDocument();
    addRichMesh(document, 'rich', cube());
    addRichMesh(document, 'flat', grid(2, 2));
    glb = await glbFile(document, 'a.glb');
    const io = new WebIO().setLogger(new Logger(Logger.Verbosity.SILENT)).registerExtensions(ALL_EXTENSIONS);
    const written = await io.writeJSON(document, { basename: 'a' });
    json = written.json;
    companions = Object.entries(written.resources).map(([name, bytes]) => ({ name, bytes }));
  });

  it('of glTF, with any value anywhere in its JSON', async () => {
    await fc.assert(
      fc.asyncProperty(fc.nat(), fc.constantFrom(...ODD), async (which, odd) => {
        await tryOpen([textFile('a.gltf', withOdd(json, which, odd)), ...companions]);
      }),
      { numRuns: 2500, seed: 21 },
    );
  }, 120_000);

  it.each([
    ['a.glb', () => glb.bytes],
    ['a.obj', () => new TextEncoder().encode(OBJ_TEXT)],
    ['torus.obj', () => new TextEncoder().encode(toObj(torus()))],
    ['a.ply', () => PLY_BINARY],
    ['a.ply', () => new TextEncoder().encode(PLY_TEXT)],
    ['a.stl', () => new TextEncoder().encode(STL_TEXT)],
  ])(
    'of %s, whatever bytes are changed',
    async (name, bytes) => {
      await fc.assert(
        fc.asyncProperty(damage, async (hits) => {
          await tryOpen([{ name, bytes: damaged(bytes(), hits) }]);
        }),
        { numRuns: 500, seed: 22 },
      );
    },
    120_000,
  );

  it.each([
    ['a.obj', OBJ_TEXT],
    ['a.ply', PLY_TEXT],
    ['a.stl', STL_TEXT],
  ])('of %s, whatever its numbers are', async (name, text) => {
    await fc.assert(
      fc.asyncProperty(fc.nat(), fc.constantFrom(...ODD_NUMBERS), async (which, odd) => {
        await tryOpen([textFile(name, withOddNumber(text, which, odd))]);
      }),
      { numRuns: 500, seed: 23 },
    );
  });
});

/** Real files of at most this size, so that a round takes milliseconds. */
const LARGEST = 300_000;
const REAL = [
  'gltf/AnimatedMorphCube/AnimatedMorphCube.gltf',
  'gltf/BoxTextured_meshopt.glb',
  'gltf/Box_Draco.glb',
  'gltf/Fox.glb',
  'gltf/derived_Fox_draco.glb',
  'gltf/derived_Fox_meshopt.glb',
  'gltf/gltf_primitives.glb',
  'gltf/quad_skin.glb',
  'dirty/draco_mat_test.obj',
  'dirty/gc_platonic_shelf.obj',
  'cube_no_bottom.obj',
];

describe.skipIf(isAbsent)('a mutated real file is opened or refused with a sentence', () => {
  it.each(REAL.filter((name) => isAbsent || statSync(join(shared, name)).size <= LARGEST))(
    '%s',
    async (name) => {
      const path = join(shared, name);
      const main = { name: basename(name), bytes: new Uint8Array(readFileSync(path)) };
      const companions = companionNames(main).map((one) => ({
        name: one,
        bytes: new Uint8Array(readFileSync(join(dirname(path), one))),
      }));
      expect(await tryOpen([main, ...companions])).toBe('');
      await fc.assert(
        fc.asyncProperty(damage, async (hits) => {
          await tryOpen([{ ...main, bytes: damaged(main.bytes, hits) }, ...companions]);
        }),
        { numRuns: 60, seed: 24 },
      );
    },
    120_000,
  );
});
