/** Tangents of results are MikkTSpace's where those of the file are, and carried elsewhere. */

import { describe, expect, it } from 'vitest';
import type { Document, Primitive } from '@gltf-transform/core';
import { generateTangents } from 'three/examples/jsm/libs/mikktspace.module.js';
import { openModel } from '../../web/engine/document/open';
import { defaultSettings } from '../../web/engine/settings/options';
import { FileOutput } from '../../web/engine/stages/file_output';
import { FileRun } from '../../web/engine/stages/file_run';
import { requestFile } from '../../web/engine/stages/budget/file_targets';
import { addMesh, floats, glbFile, primitiveOf, startDocument } from './support/gltf';
import { grid } from './support/shapes';
import { loadTestCore } from './support/core';

const core = await loadTestCore(1);

const WAVES = 2;
const height = (x: number, y: number) => 0.1 * Math.sin(2 * Math.PI * WAVES * x) * Math.cos(3 * y);

/** A wavy sheet with normals, coordinates that are turned and mirrored beyond x = 1 / 2, and MikkTSpace's tangents. */
function sheet(spoil: (tangent: number[]) => number[] = (tangent) => tangent): Document {
  const document = startDocument();
  const halves = [0, 1].map((half) => {
    const mesh = grid(16, 32);
    for (let v = 0; v < mesh.positions.length; v += 3) {
      const [x, y] = [(half + mesh.positions[v]) / 2, mesh.positions[v + 1]];
      mesh.positions.set([x, y, height(x, y)], v);
    }
    return mesh;
  });
  const primitives = halves.map((mesh, half) => {
    const primitive = primitiveOf(document, mesh);
    const [normals, coordinates]: number[][] = [[], []];
    for (let v = 0; v < mesh.positions.length; v += 3) {
      const [x, y] = mesh.positions.subarray(v, v + 2);
      const e = 1e-4;
      const slope = [
        (height(x + e, y) - height(x - e, y)) / (2 * e),
        (height(x, y + e) - height(x, y - e)) / (2 * e),
      ];
      const length = Math.hypot(slope[0], slope[1], 1);
      normals.push(-slope[0] / length, -slope[1] / length, 1 / length);
      coordinates.push(half === 0 ? x + 0.3 * y : 1 - x - 0.3 * y, y);
    }
    primitive
      .setAttribute('NORMAL', floats(document, 'VEC3', normals))
      .setAttribute('TEXCOORD_0', floats(document, 'VEC2', coordinates));
    const made = tangentsAt(primitive);
    const tangents = [...made.keys()].sort((a, b) => a - b).flatMap((v) => spoil(made.get(v)!));
    return primitive.setAttribute('TANGENT', floats(document, 'VEC4', tangents));
  });
  addMesh(document, 'sheet', primitives);
  return document;
}

/** By vertex; all corners of a vertex agree. */
function tangentsAt(primitive: Primitive): Map<number, number[]> {
  const indices = primitive.getIndices()!.getArray()!;
  const gather = (name: string) =>
    Float32Array.from([...indices].flatMap((v) => primitive.getAttribute(name)!.getElement(v, [])));
  const made = generateTangents(gather('POSITION'), gather('NORMAL'), gather('TEXCOORD_0')) as Float32Array;
  return new Map(
    [...indices].map((v, corner) => {
      const [x, y, z, w] = made.subarray(4 * corner, 4 * corner + 4);
      return [v, [x, y, z, -w]];
    }),
  );
}

/** The primitives of the sheet with a share of its faces. */
async function optimized(document: Document, ratio: number): Promise<Primitive[]> {
  const model = await openModel([await glbFile(document)]);
  const settings = { ...defaultSettings(), maxDeviation: 0 };
  const file = new FileRun(core, model);
  const output = new FileOutput(file, requestFile(file, { settings, fields: false, faces: null, ratio }));
  const { document: written } = await openModel([{ name: 'out.glb', bytes: await output.glb() }]);
  return written.getRoot().listMeshes()[0].listPrimitives();
}

const values = (primitive: Primitive, name: string): number[] => [
  ...primitive.getAttribute(name)!.getArray()!,
];

describe('tangents', () => {
  it('are recomputed by MikkTSpace if those of the file were', async () => {
    const primitives = await optimized(sheet(), 0.3);
    for (const primitive of primitives) {
      const made = tangentsAt(primitive);
      for (const [vertex, expected] of made) {
        const tangent = primitive.getAttribute('TANGENT')!.getElement(vertex, []);
        const normal = primitive.getAttribute('NORMAL')!.getElement(vertex, []);
        const dot = (a: number[], b: number[]) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        expect(Math.abs(dot(tangent, normal))).toBeLessThan(1e-5);
        expect(dot(tangent, tangent)).toBeCloseTo(1, 5);
        expect(tangent[3]).toBe(expected[3]);
        expect(dot(tangent, expected)).toBeGreaterThan(0.999);
      }
    }
    const hands = primitives.map((primitive) => primitive.getAttribute('TANGENT')!.getElement(0, [])[3]);
    expect(hands[0]).toBe(-hands[1]);
  });

  it('stay bit-equal if no face has changed', async () => {
    const document = sheet();
    const before = document.getRoot().listMeshes()[0].listPrimitives();
    const after = await optimized(document, 1);
    after.forEach((primitive, i) => {
      const [own, old] = [values(primitive, 'TANGENT'), values(before[i], 'TANGENT')];
      const rows = (list: number[]) =>
        list.map((_, k) => (k % 4 ? '' : list.slice(k, k + 4).join(' '))).sort();
      expect(rows(own)).toEqual(rows(old));
    });
  });

  it('are interpolated if the file has others', async () => {
    const turned = ([x, y, z, w]: number[]) => [y, -x, z, w];
    const [primitive] = await optimized(sheet(turned), 0.3);
    const made = tangentsAt(primitive);
    const far = [...made].filter(([vertex, expected]) => {
      const tangent = primitive.getAttribute('TANGENT')!.getElement(vertex, []);
      return tangent[0] * expected[0] + tangent[1] * expected[1] + tangent[2] * expected[2] < 0.7;
    });
    expect(far.length).toBeGreaterThan(0.9 * made.size);
  });
});
