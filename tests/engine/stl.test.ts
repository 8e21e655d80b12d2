import { describe, expect, it } from 'vitest';
import { openModel } from '../../web/engine/document/open';
import { failureOf, textFile } from './support/files';
import { cube } from './support/shapes';
import type { TriangleMesh } from '../../web/engine/core/core';

function toBinaryStl({ positions, triangles }: TriangleMesh, header = 'solid made by a test'): Uint8Array {
  const bytes = new Uint8Array(84 + (50 * triangles.length) / 3);
  bytes.set(new TextEncoder().encode(header));
  const view = new DataView(bytes.buffer);
  view.setUint32(80, triangles.length / 3, true);
  triangles.forEach((vertex, corner) => {
    const at = 84 + 50 * Math.floor(corner / 3) + 12 + 12 * (corner % 3);
    for (let c = 0; c < 3; ++c) view.setFloat32(at + 4 * c, positions[3 * vertex + c], true);
  });
  return bytes;
}

function toTextStl({ positions, triangles }: TriangleMesh): string {
  const facet = (t: number) => {
    const corners = [0, 1, 2].map((k) => 3 * triangles[3 * t + k]);
    const lines = corners.map((at) => `      vertex ${positions.slice(at, at + 3).join(' ')}`);
    return ['  facet normal 0 nan 1e0', '    outer loop', ...lines, '    endloop', '  endfacet'].join('\r\n');
  };
  const facets = Array.from({ length: triangles.length / 3 }, (_, t) => facet(t));
  return ['solid a cube with a name', ...facets, 'endsolid a cube with a name'].join('\r\n');
}

const failure = (file: { name: string; bytes: Uint8Array }) => failureOf(() => openModel([file]));

describe('STL', () => {
  it.each([
    ['binary although it starts with "solid"', { name: 'cube.stl', bytes: toBinaryStl(cube()) }],
    ['text', textFile('cube.stl', toTextStl(cube()))],
    ['text without a final newline', textFile('CUBE.STL', toTextStl(cube()).trimEnd())],
  ])('reads a file that is %s', async (_, file) => {
    const { bodies, format } = await openModel([file]);
    const { positions, triangles } = cube();
    expect(format).toBe('stl');
    expect(bodies[0].indices).toHaveLength(36);
    expect([...bodies[0].positions]).toEqual(
      [...triangles].flatMap((v) => [...positions.slice(3 * v, 3 * v + 3)]),
    );
  });

  it('reads bytes that start in the middle of a buffer', async () => {
    const bytes = toBinaryStl(cube());
    const shifted = new Uint8Array(bytes.length + 3);
    shifted.set(bytes, 3);
    const { bodies } = await openModel([{ name: 'cube.stl', bytes: shifted.subarray(3) }]);
    expect(bodies[0].indices).toHaveLength(36);
  });

  it('refuses truncated, broken or empty files with one sentence', async () => {
    const bytes = toBinaryStl(cube(), 'binary');
    expect(await failure({ name: 'a.stl', bytes: bytes.subarray(0, 400) })).toBe(
      'a.stl is cut off or not STL (684 bytes expected, 400 found): export it again.',
    );
    expect(await failure(textFile('a.stl', 'short'))).toBe('a.stl is not STL: check that it is a mesh file.');
    expect(await failure(textFile('a.stl', toTextStl(cube()).slice(0, 120)))).toMatch(/^a\.stl, line \d+: /);
    expect(await failure(textFile('a.stl', 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 zero 0'))).toBe(
      'a.stl, line 4: y is "zero", not a number.',
    );
    expect(await failure(textFile('a.stl', toTextStl(cube()).replace('vertex 0', 'vertex 1e39')))).toMatch(
      /^a\.stl, line \d+: a coordinate is too large for a 32-bit number\.$/,
    );
    expect(await failure(textFile('a.stl', 'solid a\nendsolid a\n'))).toMatch(/^a\.stl has no facets/);
    const broken = toBinaryStl(cube());
    new DataView(broken.buffer).setFloat32(84 + 50 + 12, NaN, true);
    expect(await failure({ name: 'a.stl', bytes: broken })).toBe(
      'a.stl, facet 1: a coordinate is NaN, not a finite number: export it again.',
    );
  });
});
