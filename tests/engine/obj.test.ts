import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { openModel } from '../../web/engine/document/open';
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
      SQUARE_OBJ.replace('f 1 2 3', 'vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3//1'),
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

  it('makes every object a body, with its own vertices, and groups part of it', async () => {
    const { bodies } = await open(
      `o left\n${SQUARE_OBJ}o right\nv 5 5 5\nf 2 3 5\ng part\nf 3 4 5\no left\nf 1 2 4\n`,
    );
    expect(bodies.map(({ name, indices }) => [name, indices.length / 3])).toEqual([
      ['left', 3],
      ['right', 2],
    ]);
    expect([...bodies[1].positions]).toEqual([1, 0, 0, 1, 1, 0, 5, 5, 5, 0, 1, 0]);
  });

  it('names what it does not carry', async () => {
    const { unread, notes } = await open(
      `mtllib a.mtl\nusemtl red\nvt 0 0\nl 1 2\nstrange line\n${SQUARE_OBJ}`,
    );
    expect(unread).toEqual(['materials', 'UV coordinates']);
    expect(notes).toEqual(['1 line or point skipped', '1 unknown line skipped, the first is line 5']);
  });

  it.each([
    ['v 0 0 zero\n', 'test.obj, line 1: z is "zero", not a number.'],
    ['v 0 0\n', 'test.obj, line 1: z is missing.'],
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
    ['Dear Sir,\nhow', 'test.obj, line 1: "Dear Sir," is not OBJ, and the file has no faces: is it a mesh?'],
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

  it('never throws anything but a sentence', () =>
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
