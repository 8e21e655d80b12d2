import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { openModel } from '../../web/engine/document/open';
import { lostIn } from '../../web/engine/document/write/lost';
import { writePly } from '../../web/engine/document/write/ply_file';
import { failureOf, textFile } from './support/files';

const header = (format: string, vertices = 5, faces = 2) => `ply
format ${format} 1.0
comment made by hand
element vertex ${vertices}
property float x
property double y
property float z
property uchar red
property uchar green
property uchar blue
element face ${faces}
property uchar flags
property list uchar int vertex_indices
end_header
`;

const POINTS = [
  [0, 0, 0],
  [2, 0, 0],
  [2, 2, 0],
  [1, 3, 0],
  [0, 2, 0],
];
const FACES = [
  [0, 1, 2, 3, 4],
  [4, 3, 2],
];

const text = `${header('ascii')}${POINTS.map((point) => `${point.join(' ')} 1 2 3`).join('\n')}\n${FACES.map((face) => `7 ${face.length} ${face.join(' ')}`).join('\n')}`;

function binary(isLittle: boolean, newline = '\n'): Uint8Array {
  const start = new TextEncoder().encode(
    header(isLittle ? 'binary_little_endian' : 'binary_big_endian').replace(/\n/g, newline),
  );
  const bytes = new Uint8Array(start.length + 5 * 19 + 2 * 2 + 8 * 4);
  bytes.set(start);
  const view = new DataView(bytes.buffer);
  let at = start.length;
  for (const [x, y, z] of POINTS) {
    view.setFloat32(at, x, isLittle);
    view.setFloat64(at + 4, y, isLittle);
    view.setFloat32(at + 12, z, isLittle);
    at += 19;
  }
  for (const face of FACES) {
    bytes[at + 1] = face.length;
    at += 2;
    for (const vertex of face) {
      view.setInt32(at, vertex, isLittle);
      at += 4;
    }
  }
  return bytes;
}

const failure = (bytes: Uint8Array) => failureOf(() => openModel([{ name: 'a.ply', bytes }]));

describe('PLY', () => {
  it.each([
    ['text', textFile('a.ply', text)],
    ['text with CR LF', textFile('a.ply', text.replace(/\n/g, '\r\n'))],
    ['binary, little-endian', { name: 'a.ply', bytes: binary(true) }],
    ['binary, big-endian', { name: 'a.ply', bytes: binary(false) }],
    ['binary with CR LF in its header', { name: 'a.ply', bytes: binary(true, '\r\n') }],
    ['PLY under another name', { name: 'a.bin', bytes: binary(true) }],
  ])('reads %s with a pentagon', async (_, file) => {
    const { bodies, unread, format } = await openModel([file]);
    expect(format).toBe('ply');
    expect([...bodies[0].positions]).toEqual(POINTS.flat());
    expect([...bodies[0].indices]).toEqual([0, 1, 2, 0, 2, 3, 0, 3, 4, 4, 3, 2]);
    expect(bodies[0].notes).toEqual(['1 polygon with more than three corners cut into triangles']);
    expect(unread).toEqual([]);
  });

  it('reads normals, UVs, colours and opacities', async () => {
    const triangle = `ply\nformat ascii 1.0\nelement vertex 3\n${['x', 'y', 'z', 'nx', 'ny', 'nz', 's', 't']
      .map((name) => `property float ${name}\n`)
      .join(
        '',
      )}${['red', 'green', 'blue', 'alpha'].map((name) => `property uchar ${name}\n`).join('')}element face 1
property list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header
0 0 0 0 0 2 0 0.25 255 0 55 255\n1 0 0 0 3 4 1 0 0 0 0 128\n0 1 0 0 0 1 nan 1 10 20 30 255\n3 0 1 2 2 0.5 0.5\n`;
    const { document, unread } = await openModel([textFile('a.ply', triangle)]);
    const [primitive] = document.getRoot().listMeshes()[0].listPrimitives();
    const values = (name: string) => [...primitive.getAttribute(name)!.getArray()!];
    expect(values('NORMAL')).toEqual([0, 0, 1, 0, 0.6, 0.8, 0, 0, 1].map(Math.fround));
    // The origin of UVs is the lower left corner in PLY and the upper left corner in glTF.
    expect(values('TEXCOORD_0')).toEqual([0, 0.75, 1, 1, 0, 0]);
    // sRGB 55 is 0.0382 in linear light, 10 is 0.0030.
    expect(values('COLOR_0').slice(0, 9)).toEqual([65535, 0, 2504, 65535, 0, 0, 0, 32896, 199]);
    expect(primitive.getAttribute('COLOR_0')!.getType()).toBe('VEC4');
    expect(unread).toEqual(['UV coordinates of faces']);
  });

  it.each(['', '128', '-1', '300'])('comes back with the opacity of its colours: "%s"', async (alpha) => {
    const colours = ['red', 'green', 'blue', ...(alpha === '' ? [] : ['alpha'])];
    const properties = colours.map((name) => `property uchar ${name}\n`).join('');
    const model = await openModel([
      textFile(
        'a.ply',
        `ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n${properties}element face 1
property list uchar int vertex_indices\nend_header\n0 0 0 255 0 55 ${alpha}\n1 0 0 255 0 55 ${alpha}\n0 1 0 255 0 55 ${alpha}\n3 0 1 2\n`,
      ),
    ]);
    expect(lostIn('ply', model)).toEqual([]);
    expect(lostIn('obj', model)).toEqual(
      alpha === '128' || alpha === '-1' ? ['opacity of vertex colours'] : [],
    );
    const { bytes } = writePly(model.document, 'b.ply', 'Limber 1');
    expect(new TextDecoder('latin1').decode(bytes).includes('property uchar alpha')).toBe(alpha !== '');
    const opacities = { '': [], '128': [128], '-1': [0], '300': [255] }[alpha]!;
    // Positions and face follow the colours of the last vertex.
    expect([...bytes.subarray(bytes.length - 13 - 3 - opacities.length, bytes.length - 13)]).toEqual([
      ...[255, 0, 55],
      ...opacities,
    ]);
  });

  it('unrolls triangle strips', async () => {
    const strips = `ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z
element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n8 0 1 2 3 -1 2 3 4`;
    const { bodies } = await openModel([textFile('a.ply', strips)]);
    expect([...bodies[0].indices]).toEqual([0, 1, 2, 2, 1, 3, 2, 3, 4]);
  });

  it('refuses truncated or wrong files with one sentence', async () => {
    const bytes = binary(true);
    expect(await failure(bytes.subarray(0, bytes.length - 1))).toMatch(
      /^a\.ply, byte \d+: the file ends too early: export it again\.$/,
    );
    expect(await failure(textFile('a.ply', text.slice(0, -8)).bytes)).toMatch(
      /^a\.ply, line 21: the file ends too early/,
    );
    const wrong = (from: string, to: string) => failure(textFile('a.ply', text.replace(from, to)).bytes);
    expect(await wrong('4 3 2', '4 3 5')).toBe(
      'a.ply, face 1: it names vertex 5, but vertices go from 0 to 4: export it again.',
    );
    expect(await wrong('4 3 2', '4 3 -1')).toMatch(/^a\.ply, face 1: it names vertex -1,/);
    expect(await wrong('property double y', 'property decimal y')).toBe(
      'a.ply, line 6: "decimal" is not a PLY type.',
    );
    expect(await wrong('ascii', 'text')).toMatch(/^a\.ply, line 2: the format "text" is not one of ascii,/);
    expect(await wrong('end_header', 'end')).toBe('a.ply, line 14: "end" is not PLY.');
    expect(await wrong('2 2 0', '2 nan 0')).toMatch(/^a\.ply, line 17: .* not a finite number\.$/);
    expect(await failure(textFile('a.ply', header('ascii', 99999999, 1)).bytes)).toMatch(
      /do not fit into the file/,
    );
    expect(await failure(textFile('a.ply', header('ascii', 0, 0)).bytes)).toMatch(/^a\.ply has no faces/);
  });

  it('never throws anything other than a sentence, whichever byte is damaged', () =>
    fc.assert(
      fc.asyncProperty(fc.nat(), fc.nat(255), fc.boolean(), async (place, value, isText) => {
        const bytes = isText ? new TextEncoder().encode(text) : binary(true);
        bytes[place % bytes.length] = value;
        const message = await failureOf(() => openModel([{ name: 'a.ply', bytes }]));
        expect(message === '' || /^a\.ply\b.*[.?]$/s.test(message)).toBe(true);
      }),
      { numRuns: 2000, seed: 4 },
    ));
});
