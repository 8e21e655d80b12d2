import { describe, expect, it } from 'vitest';
import type { Document } from '@gltf-transform/core';
import { posesInAnimations } from '../../web/engine/body/skinning';
import { posesOf } from '../../web/engine/body/poses';
import type { WeldResult } from '../../web/engine/core/core';
import { openModel } from '../../web/engine/document/open';
import { addMesh, floats, glbFile, primitiveOf, startDocument } from './support/gltf';
import { box } from './support/shapes';

const mesh = box(2, 2, 8);
const count = mesh.positions.length / 3;

/** A bar along z of two bones, the upper one from z = 4 on; the animation sets `path` of it to the values, a second apart. */
async function barOf(path: 'rotation' | 'translation', values: number[][], whole = false) {
  const document = startDocument();
  const primitive = primitiveOf(document, mesh);
  const isUpper = (v: number) => whole || mesh.positions[3 * v + 2] > 4;
  const joints = Array.from({ length: count }, (_, v) => [isUpper(v) ? 1 : 0, 0, 0, 0]).flat();
  const set = document.createAccessor().setType('VEC4').setArray(Uint8Array.from(joints));
  const weights = Array.from({ length: count }, () => [1, 0, 0, 0]).flat();
  primitive
    .setAttribute('JOINTS_0', set.setBuffer(document.getRoot().listBuffers()[0]))
    .setAttribute('WEIGHTS_0', floats(document, 'VEC4', weights));
  const body = addMesh(document, 'bar', [primitive]);
  animate(document, path, values);
  const node = document
    .getRoot()
    .listNodes()
    .find((one) => one.getMesh() === body)!;
  const skin = document.createSkin();
  for (const name of ['lower', 'upper'])
    skin.addJoint(
      document
        .getRoot()
        .listNodes()
        .find((one) => one.getName() === name)!,
    );
  // The upper bone begins at z = 4.
  const bind = [identity(), identity([0, 0, -4])].flat();
  skin.setInverseBindMatrices(
    document
      .createAccessor()
      .setType('MAT4')
      .setArray(Float32Array.from(bind))
      .setBuffer(document.getRoot().listBuffers()[0]),
  );
  node.setSkin(skin);
  return openModel([await glbFile(document)]);
}

const identity = (at = [0, 0, 0]) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, ...at, 1];

function animate(document: Document, path: 'rotation' | 'translation', values: number[][]): void {
  const lower = document.createNode('lower');
  const upper = document.createNode('upper').setTranslation([0, 0, 4]);
  document.getRoot().listScenes()[0].addChild(lower.addChild(upper));
  const sampler = document
    .createAnimationSampler()
    .setInput(
      floats(
        document,
        'SCALAR',
        values.map((_, i) => i),
      ),
    )
    .setOutput(floats(document, path === 'rotation' ? 'VEC4' : 'VEC3', values.flat()));
  const channel = document
    .createAnimationChannel()
    .setTargetNode(upper)
    .setTargetPath(path)
    .setSampler(sampler);
  document.createAnimation('move').addSampler(sampler).addChannel(channel);
}

/** No vertex of the bar is doubled, so that the welded mesh is the body's own. */
const weldOf = (positions: Float32Array, triangles: Uint32Array) =>
  ({
    mesh: { positions, triangles },
    vertexOfSource: Uint32Array.from({ length: count }, (_, v) => v),
  }) as WeldResult;

const quarter = [0, Math.SQRT1_2, 0, Math.SQRT1_2];

describe('poses of a skinned body', () => {
  it('are where the bones take its vertices', async () => {
    const model = await barOf('rotation', [[0, 0, 0, 1], quarter]);
    const [body] = model.bodies;
    const poses = posesInAnimations(model.document, body);
    expect(poses.length).toBe(8);
    for (let v = 0; v < count; ++v)
      for (let c = 0; c < 3; ++c) expect(poses[0][3 * v + c]).toBeCloseTo(body.positions[3 * v + c], 5);
    // Halfway, at pose 4, the upper half has turned by 45 degrees about y through (0, 0, 4).
    const [cosine, sine] = [Math.SQRT1_2, Math.SQRT1_2];
    for (let v = 0; v < count; ++v) {
      const [x, y, z] = body.positions.subarray(3 * v, 3 * v + 3);
      if (z <= 4) continue;
      expect(poses[4][3 * v]).toBeCloseTo(cosine * x + sine * (z - 4), 4);
      expect(poses[4][3 * v + 1]).toBeCloseTo(y, 5);
      expect(poses[4][3 * v + 2]).toBeCloseTo(4 - sine * x + cosine * (z - 4), 4);
    }
  });

  it('are none of a body without a skin', async () => {
    const document = startDocument();
    addMesh(document, 'box', [primitiveOf(document, mesh)]);
    const model = await openModel([await glbFile(document)]);
    expect(posesInAnimations(model.document, model.bodies[0])).toEqual([]);
  });

  it('cost nothing where the body moves as a whole, however far', async () => {
    const model = await barOf(
      'translation',
      [
        [0, 0, 4],
        [70, -9, 5],
      ],
      true,
    );
    const [body] = model.bodies;
    const poses = posesOf(model.document, body, weldOf(body.positions, body.indices), 2);
    const largest = poses ? Math.max(...poses.values.map(Math.abs)) : 0;
    expect(largest).toBeLessThan(1e-4);
  });

  it('have fields whose squares add up to what is not affine in them', async () => {
    const model = await barOf('rotation', [[0, 0, 0, 1], quarter]);
    const [body] = model.bodies;
    const weld = weldOf(body.positions, body.indices);
    const sumOf = (most: number) =>
      posesOf(model.document, body, weld, most)!.values.reduce((sum, value) => sum + value * value, 0);
    expect(posesOf(model.document, body, weld, 1)!.size).toBe(3);
    const [one, two, all] = [sumOf(1), sumOf(2), sumOf(8)];
    expect(one).toBeGreaterThan(0.8 * all);
    expect(two).toBeGreaterThan(0.99 * all);
    expect(two).toBeLessThanOrEqual(all);
  });
});
