import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { exportGlb } from '../../web/engine/document/export';
import { openModel } from '../../web/engine/document/open';
import { validateGlb } from '../../web/engine/document/validate';
import { failureOf, SQUARE_OBJ, textFile } from './support/files';
import { areaOf } from './support/shapes';

const open = (text: string) => openModel([textFile('test.obj', text)]);
const failure = (text: string) => failureOf(() => open(text));

describe('OBJ', () => {
  it('reads vertices and faces', async () => {
    const { bodies, format } = await open(SQUARE_OBJ);
    expect(format).toBe('obj');
    expect(bodies).toHaveLength(1);
    expect(bodies[0].name).toBe('test');
    expect([...bodies[0].positions]).toEqual([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
    expect([...bodies[0].indices]).toEqual([0, 1, 2, 0, 2, 3]);
  });

  it.each([
    ['without a final newline', SQUARE_OBJ.trimEnd()],
    ['with CR LF', SQUARE_OBJ.replace(/\n/g, '\r\n')],
    ['with CR alone', SQUARE_OBJ.replace(/\n/g, '\r')],
    ['with a byte order mark', `\ufeff${SQUARE_OBJ}`],
    ['with blanks and comments', `# made by hand\n\n  ${SQUARE_OBJ.replace(/ /g, ' \t ')}   # end`],
    ['with a joined line', SQUARE_OBJ.replace('v 1 0 0', 'v 1 \\\n 0 0')],
    [
      'with texture and normal indices',
      `vt 0 0\nvn 0 0 1\n${SQUARE_OBJ.replace(/f.*\n/g, '')}f 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/-1/-1 4/1/1\n`,
    ],
    ['with vertex colours', SQUARE_OBJ.replace('v 0 0 0', 'v 0 0 0 0.5 0.5 0.5')],
    ['with negative indices', SQUARE_OBJ.replace('f 1 2 3', 'f -4 -3 -2')],
    ['with faces before their vertices', `f 1 2 3\nf 1 3 4\n${SQUARE_OBJ.replace(/f.*\n/g, '')}`],
  ])('reads a file %s', async (_, text) => {
    const { bodies } = await open(text);
    expect([...bodies[0].positions]).toEqual([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
    expect([...bodies[0].indices]).toEqual([0, 1, 2, 0, 2, 3]);
  });

  it('cuts a quad along the diagonal of its first corner', async () => {
    const { bodies } = await open('v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n');
    expect([...bodies[0].indices]).toEqual([0, 1, 2, 0, 2, 3]);
    expect(bodies[0].notes).toEqual(['1 polygon with more than three corners cut into triangles']);
  });

  it('splits vertices where UVs or normals differ and numbers the new ones last', async () => {
    const { document, bodies } = await open(
      `${SQUARE_OBJ.replace(/f.*\n/g, '')}v 9 9 9\nvt 0 0\nvt 1 0.25\nvt 1 1\nvn 0 0 2\nvn 0 3 4\n` +
        'f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/2/1 4/2/2\n',
    );
    expect([...bodies[0].indices]).toEqual([0, 1, 2, 0, 5, 3]);
    expect([...bodies[0].positions.slice(12)]).toEqual([9, 9, 9, 1, 1, 0]);
    const [primitive] = document.getRoot().listMeshes()[0].listPrimitives();
    const values = (name: string) => [...primitive.getAttribute(name)!.getArray()!];
    // The origin of UVs is the lower left corner in OBJ and the upper left corner in glTF.
    expect(values('TEXCOORD_0')).toEqual([0, 1, 1, 0.75, 1, 0, 1, 0.75, 0, 1, 1, 0.75]);
    expect(values('NORMAL').slice(6, 12)).toEqual([0, 0, 1, 0, 0.6, 0.8].map(Math.fround));
  });

  it('drops normals if a corner has none, and keeps colours if every vertex has one', async () => {
    const normals = `vn 0 0 1\n${SQUARE_OBJ.replace('f 1 2 3', 'f 1//1 2//1 3//1')}`;
    const colours = SQUARE_OBJ.replace(/^v.*$/gm, '$& 1 0.5 0');
    const semantics = async (text: string) => {
      const { document } = await open(text);
      return document.getRoot().listMeshes()[0].listPrimitives()[0].listSemantics();
    };
    expect(await semantics(normals)).toEqual(['POSITION']);
    expect(await semantics(colours)).toEqual(['POSITION', 'COLOR_0']);
    expect(await semantics(colours.replace(' 1 0.5 0', ' 1'))).toEqual(['POSITION']);
  });

  it('keeps the colours of an object beside others without colours', async () => {
    const object = (name: string, colour: string) =>
      `o ${name}\n${SQUARE_OBJ.replace(/^v.*$/gm, `$&${colour}`).replace(/f.*\n/g, '')}f -4 -3 -2 -1\n`;
    const { document } = await open(object('a', '') + object('b', ' 1 0 0') + object('c', ''));
    const colours = document
      .getRoot()
      .listMeshes()
      .map((mesh) => mesh.listPrimitives()[0].getAttribute('COLOR_0')?.getElement(3, []));
    expect(colours).toEqual([undefined, [1, 0, 0], undefined]);
  });

  it('makes one primitive per material in an object', async () => {
    const model = await open(
      `${SQUARE_OBJ.replace(/f.*\n/g, '')}usemtl red\nf 1 2 3\nusemtl blue sky\nf 1 3 4\nusemtl red\nf 1 2 4\n`,
    );
    const { document, bodies } = model;
    const primitives = document.getRoot().listMeshes()[0].listPrimitives();
    expect(primitives.map((one) => one.getMaterial()!.getName())).toEqual(['red', 'blue sky']);
    expect(primitives.map((one) => [...one.getIndices()!.getArray()!])).toEqual([
      [0, 1, 2, 0, 1, 3],
      [0, 2, 3],
    ]);
    expect(bodies[0].spans).toEqual([
      { primitive: 0, first: 0, firstVertex: 0, vertexCount: 4 },
      { primitive: 1, first: 2, firstVertex: 0, vertexCount: 4 },
    ]);
    const bytes = await exportGlb(model, [null], { fields: false });
    expect(await validateGlb(bytes)).toMatchObject({ errors: 0, warnings: 0 });
  });

  it('makes every object, with its groups, one body with its own vertices', async () => {
    const { bodies } = await open(
      `o left\n${SQUARE_OBJ}o right\nv 5 5 5\nf 2 3 5\ng part\nf 3 4 5\no left\nf 1 2 4\n`,
    );
    expect(bodies.map(({ name, indices }) => [name, indices.length / 3])).toEqual([
      ['left', 3],
      ['right', 2],
    ]);
    expect([...bodies[1].positions]).toEqual([1, 0, 0, 1, 1, 0, 5, 5, 5, 0, 1, 0]);
  });

  it('lists the content that it drops', async () => {
    const { unread, notes } = await open(
      `mtllib a.mtl\nusemtl red\nvt 0 0\nl 1 2\nstrange line\n${SQUARE_OBJ}`,
    );
    expect(unread).toEqual([]);
    expect(notes).toEqual([
      '1 line or point skipped',
      '1 unknown line skipped, the first is line 5',
      expect.stringMatching(/^a\.mtl is missing: put it beside the OBJ/),
    ]);
  });

  it.each([
    ['v 0 0 zero\n', 'test.obj, line 1: z is "zero", not a number.'],
    ['v 0 0\n', 'test.obj, line 1: z is missing.'],
    ['v 0 0', 'test.obj, line 1: z is missing and the file seems cut off: export it again.'],
    ['\nv 0 nan 0\n', 'test.obj, line 2: y is nan, not a finite number.'],
    ['v 0 -inf 0\n', 'test.obj, line 1: y is -inf, not a finite number.'],
    ['v 1e400 0 0\n', 'test.obj, line 1: x is 1e400, not a finite number.'],
    ['v 1e39 0 0\n', 'test.obj, line 1: a coordinate is too large for a 32-bit number.'],
    [
      `${SQUARE_OBJ}f 1 2 9\nf 1 2 7\n`,
      'test.obj, line 7: a face names vertex 9, but the file has 4: export it again.',
    ],
    [`${SQUARE_OBJ}f 1 2 -5\n`, 'test.obj, line 7: a face names vertex -5, but only 4 come before it.'],
    [`${SQUARE_OBJ}f 0 1 2\n`, 'test.obj, line 7: a face names vertex 0, but vertices are numbered from 1.'],
    [`${SQUARE_OBJ}f 1 2 three\n`, 'test.obj, line 7: the corner "three" is not a vertex number.'],
    [`${SQUARE_OBJ}f 1 2 3.5\n`, 'test.obj, line 7: the corner "3.5" is not a vertex number.'],
    ['v 0 0 0\n', 'test.obj has 1 vertex but no faces: export it as a mesh with faces.'],
    [
      'Dear Sir,\nhow',
      'test.obj, line 1: "Dear Sir," is not OBJ, and the file has no faces: check that it is a mesh file.',
    ],
  ])('refuses %j with one sentence', async (text, message) => {
    expect(await failure(text)).toBe(message);
  });

  it('rounds every decimal as JavaScript does', () => {
    const decimal = fc.oneof(
      fc.double({ noNaN: true, noDefaultInfinity: true, min: -3e38, max: 3e38 }).map(String),
      fc.float({ noNaN: true, noDefaultInfinity: true }).map((value) => value.toFixed(7)),
      fc
        .double({ noNaN: true, noDefaultInfinity: true, min: -3e38, max: 3e38 })
        .map((value) => value.toExponential()),
      fc.stringMatching(/^[+-]?[0-9]{1,20}\.?[0-9]{0,20}$/),
    );
    return fc.assert(
      fc.asyncProperty(fc.tuple(decimal, decimal, decimal), async (words) => {
        const { bodies } = await open(`v ${words.join(' ')}\nf 1 1 1\n`);
        expect([...bodies[0].positions]).toEqual(words.map((word) => Math.fround(Number(word))));
      }),
      { numRuns: 300, seed: 1 },
    );
  });

  it('never throws anything other than a sentence', () =>
    fc.assert(
      fc.asyncProperty(
        fc.array(fc.constantFrom(...'vfo 0129.-/e\n\\#\u00e9'), { maxLength: 60 }),
        async (letters) => {
          const message = await failure(letters.join(''));
          expect(message === '' || /^test\.obj\b.*[.?]$/.test(message)).toBe(true);
        },
      ),
      { numRuns: 2000, seed: 2 },
    ));

  it('keeps the area of a concave polygon', async () => {
    const { bodies } = await open('v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nf 1 2 3 4 5\n');
    const [{ positions, indices }] = bodies;
    expect(indices).toHaveLength(9);
    expect(areaOf({ positions, triangles: indices })).toBeCloseTo(2.5, 6);
  });
});
