/** Nodes with a shear: what no translation, rotation and scale equal stands in every result where it stood. */

import type { GLTF } from '@gltf-transform/core';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { factorsOf } from '../../web/engine/document/checks/matrix_factors';
import type { Quaternion } from '../../web/engine/document/checks/matrix_factors';
import { glbParts, withJson } from '../../web/engine/document/glb';
import { openModel } from '../../web/engine/document/open';
import type { OpenModel } from '../../web/engine/document/open';
import { validateFiles } from '../../web/engine/document/validate';
import { exportFiles } from '../../web/engine/document/write/export_files';
import { flatMeshes } from '../../web/engine/document/write/flat_meshes';
import { addMesh, glbFile, primitiveOf, startDocument } from './support/gltf';
import { asResult } from './support/results';
import { torus } from './support/shapes';

const SHEAR = [1, 0, 0, 0, 0.8, 1, 0, 0, 0, 0, 1, 0, 3, 4, 5, 1];
const TURN = [0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 4, 0, 1, 2, 3, 1];
const LOST = 'is sheared, which is lost: bake its transformation';

/** A torus whose node has a matrix, in a file that has been changed. */
async function opened(matrix: number[], change: (json: GLTF.IGLTF) => void = () => {}): Promise<OpenModel> {
  const document = startDocument();
  addMesh(document, 'ring', [primitiveOf(document, torus())]);
  const { bytes } = await glbFile(document);
  const json = JSON.parse(new TextDecoder().decode(glbParts({ name: '', bytes }).json)) as GLTF.IGLTF;
  json.nodes![0].matrix = matrix;
  change(json);
  return openModel([{ name: 'test.glb', bytes: withJson(bytes, json) }]);
}

/** The model written anew, and read again. */
async function written(
  model: OpenModel,
  name: string,
  compression: 'none' | 'quantized',
): Promise<OpenModel> {
  const bodies = model.bodies.map((body) => ({ first: asResult(body), further: [] }));
  const files = await exportFiles(model, bodies, {
    name,
    form: { format: name.endsWith('.obj') ? 'obj' : 'glb', isZipped: false },
    manner: { compression, style: 'files', keepsOrder: false },
    fields: false,
  });
  if (name.endsWith('.glb')) expect((await validateFiles(files))!.errors).toBe(0);
  return openModel(files);
}

/** The largest distance of points, in any order, from those that the matrix makes of a torus. */
function farthest(points: Float32Array, matrix: number[]): number {
  const { positions } = torus();
  const places = Array.from({ length: positions.length / 3 }, (_, v) => {
    const [x, y, z] = positions.subarray(3 * v, 3 * v + 3);
    return [0, 1, 2].map((c) => matrix[c] * x + matrix[4 + c] * y + matrix[8 + c] * z + matrix[12 + c]);
  });
  const distances = Array.from({ length: points.length / 3 }, (_, v) =>
    Math.min(...places.map((place) => Math.hypot(...place.map((value, c) => value - points[3 * v + c])))),
  );
  return Math.max(...distances);
}

const shown = ({ document }: OpenModel): Float32Array => flatMeshes(document)[0].primitives[0].positions;

describe('a sheared node', () => {
  it('keeps its position in GLB and OBJ, and within the grid if quantized', async () => {
    const model = await opened(SHEAR);
    expect(model.notes).toEqual([]);
    expect(farthest(shown(model), SHEAR)).toBeLessThan(1e-6);
    expect(farthest(shown(await written(model, 'a.glb', 'none')), SHEAR)).toBeLessThan(1e-6);
    expect(farthest(shown(await written(model, 'a.obj', 'none')), SHEAR)).toBeLessThan(1e-6);
    expect(farthest(shown(await written(model, 'a.glb', 'quantized')), SHEAR)).toBeLessThan(1e-3);
  });

  it('keeps index, name, extras and children, under a new parent', async () => {
    const model = await opened(SHEAR, (json) => {
      json.nodes!.push({ name: 'below', translation: [1, 1, 0] });
      json.nodes![0] = { ...json.nodes![0], extras: { kept: true }, children: [1] };
    });
    const [node, below, holder] = model.document.getRoot().listNodes();
    expect(node.getName()).toBe('ring node');
    expect(node.getExtras()).toEqual({ kept: true });
    expect(holder.listChildren()).toEqual([node]);
    expect(model.document.getRoot().listScenes()[0].listChildren()).toEqual([holder]);
    node.getWorldMatrix().forEach((value, i) => expect(value).toBeCloseTo(SHEAR[i], 12));
    [4.8, 5, 5].forEach((value, c) => expect(below.getWorldMatrix()[12 + c]).toBeCloseTo(value, 12));
  });

  it('still deforms a skin as a joint', async () => {
    const model = await opened(TURN, (json) => {
      json.nodes!.push({ name: 'joint', matrix: SHEAR });
      json.scenes![0].nodes!.push(1);
      json.skins = [{ joints: [1], skeleton: 1 }];
    });
    const [joint] = model.document.getRoot().listSkins()[0].listJoints();
    expect(joint.getName()).toBe('joint');
    joint.getWorldMatrix().forEach((value, i) => expect(value).toBeCloseTo(SHEAR[i], 12));
  });

  it('loses its shear, with a note, if an animation or levels of detail move it', async () => {
    const animated = await opened(SHEAR, (json) => {
      const times = json.accessors!.push({ componentType: 5126, count: 1, type: 'SCALAR' }) - 1;
      const values = json.accessors!.push({ componentType: 5126, count: 1, type: 'VEC3' }) - 1;
      json.accessors![times] = { ...json.accessors![times], min: [0], max: [0] };
      const channels = [{ sampler: 0, target: { node: 0, path: 'translation' as const } }];
      json.animations = [{ samplers: [{ input: times, output: values }], channels }];
    });
    expect(animated.notes).toContain(`node "ring node" ${LOST}`);
    const [node, ...others] = animated.document.getRoot().listNodes();
    expect(others).toEqual([]);
    expect(Math.hypot(...node.getRotation())).toBeCloseTo(1, 12);
    expect(node.getTranslation()).toEqual([3, 4, 5]);
    const pointed = await opened(SHEAR, (json) => {
      const accessor = json.accessors!.push({ componentType: 5126, count: 1, type: 'VEC3' }) - 1;
      const extensions = { KHR_animation_pointer: { pointer: '/nodes/0/translation' } };
      const channels = [{ sampler: 0, target: { path: 'pointer' as 'scale', extensions } }];
      json.animations = [{ samplers: [{ input: accessor, output: accessor }], channels }];
      json.extensionsUsed = ['KHR_animation_pointer'];
    });
    expect(pointed.notes).toContain(`node "ring node" ${LOST}`);
    expect(pointed.document.getRoot().listNodes()).toHaveLength(1);
    const levels = await opened(SHEAR, (json) => {
      json.nodes!.push({ matrix: SHEAR, mesh: 0 }, { matrix: SHEAR, mesh: 0 });
      json.nodes![0].extensions = { MSFT_lod: { ids: [1, 2] } };
      json.extensionsUsed = ['MSFT_lod'];
    });
    const said = 'node "ring node" and 2 more are sheared, which is lost: bake their transformations';
    expect(levels.notes).toContain(said);
    expect(levels.document.getRoot().listNodes()).toHaveLength(3);
  });

  it('is not detected in rotations, scales, reflections and matrices with six digits', async () => {
    const mirrored = TURN.map((value, i) => (i === 10 ? -value : value));
    const printed = [0.866025, 0.5, 0, 0, -0.5, 0.866025, 0, 0, 1e-6, 0, 1, 0, 0, 0, 0, 1];
    for (const matrix of [TURN, mirrored, printed]) {
      const model = await opened(matrix);
      expect(model.document.getRoot().listNodes()).toHaveLength(1);
      expect(farthest(shown(model), matrix)).toBeLessThan(2e-6);
    }
  });

  it('that is flat stays one node unless it is sheared, too', async () => {
    const flat = TURN.map((value, i) => (i >= 8 && i < 11 ? 0 : value));
    const model = await opened(flat);
    expect(model.document.getRoot().listNodes()).toHaveLength(1);
    expect(farthest(shown(model), flat)).toBeLessThan(1e-6);
  });
});

/** What a rotation makes of a direction. */
function rotated([x, y, z, w]: Quaternion, [a, b, c]: number[]): number[] {
  const [d, e, f] = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
  return [a + w * d + y * f - z * e, b + w * e + z * d - x * f, c + w * f + x * e - y * d];
}

it('any matrix is the product of its factors, however thin, flat, large or small', () => {
  const number = fc.oneof(
    fc.constantFrom(0, 1, -1, 1e-9, 2),
    fc.double({ min: -1, max: 1, noNaN: true }),
    fc.double({ min: -1e150, max: 1e150, noNaN: true }),
  );
  const column = fc.tuple(number, number, number);
  fc.assert(
    fc.property(fc.tuple(column, column, column), (columns) => {
      const { outer, scale, inner, closest } = factorsOf(columns);
      const largest = Math.max(...columns.flat().map(Math.abs));
      for (const quaternion of [outer, inner, closest.rotation])
        expect(Math.hypot(...quaternion)).toBeCloseTo(1, 12);
      columns.forEach((expected, k) => {
        const turned = rotated(
          inner,
          [0, 1, 2].map((c) => Number(c === k)),
        );
        const found = rotated(
          outer,
          turned.map((value, c) => scale[c] * value),
        );
        found.forEach((value, c) =>
          expect(Math.abs(value - expected[c])).toBeLessThanOrEqual(1e-13 * largest),
        );
      });
    }),
    { numRuns: 2000 },
  );
});
