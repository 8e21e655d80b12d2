import { describe, expect, it } from 'vitest';
import type { Document } from '@gltf-transform/core';
import { posesInAnimations } from '../../web/engine/body/skinning';
import { posesOfTargets } from '../../web/engine/body/morphing';
import { posesOf } from '../../web/engine/body/poses';
import type { WeldResult } from '../../web/engine/core/core';
import { openModel } from '../../web/engine/document/open';
import { addMesh, floats, glbFile, primitiveOf, startDocument } from './support/gltf';
import { defaultSettings } from '../../web/engine/settings/options';
import { STAGES } from '../../web/engine/stages/stages';
import { loadTestCore } from './support/core';
import { runOfModel } from './support/runs';
import { box, grid } from './support/shapes';

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
  it('are the positions to which its joints move the vertices', async () => {
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

  it('are absent without a skin', async () => {
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
    const first = posesOf(model.document, body, weld, 1)!;
    expect([first.size, first.animated]).toEqual([3, 1]);
    const [one, two, all] = [sumOf(1), sumOf(2), sumOf(8)];
    expect(one).toBeGreaterThan(0.8 * all);
    expect(two).toBeGreaterThan(0.99 * all);
    expect(two).toBeLessThanOrEqual(all);
  });
});

/** The bar with morph targets that move its vertices by these functions of their positions. */
async function morphedBar(...moves: ((x: number, y: number, z: number) => number[])[]) {
  const document = startDocument();
  const primitive = primitiveOf(document, mesh);
  for (const move of moves) {
    const values = Array.from({ length: count }, (_, v) =>
      move(mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]),
    );
    const target = document.createPrimitiveTarget();
    primitive.addTarget(target.setAttribute('POSITION', floats(document, 'VEC3', values.flat())));
  }
  addMesh(document, 'bar', [primitive]);
  return openModel([await glbFile(document)]);
}

describe('morph targets of a body', () => {
  const bumpAt = (height: number, size: number) => (_x: number, _y: number, z: number) =>
    z === height ? [size, 0, 0] : [0, 0, 0];

  it('move its vertices to their positions at full weight, and are dropped if they move none', async () => {
    const model = await morphedBar(bumpAt(8, 0.5), () => [0, 0, 0]);
    const [body] = model.bodies;
    const poses = posesOfTargets(model.document, body);
    expect(poses.length).toBe(1);
    for (let v = 0; v < count; ++v) {
      const moved = body.positions[3 * v + 2] === 8 ? 0.5 : 0;
      expect(poses[0][3 * v]).toBeCloseTo(body.positions[3 * v] + moved, 6);
    }
  });

  it('cost nothing where they move the body as a whole or stretch it', async () => {
    const model = await morphedBar((x, y, z) => [0.3 * x + 1, y, z - 2]);
    const [body] = model.bodies;
    const poses = posesOf(model.document, body, weldOf(body.positions, body.indices), 2);
    expect(poses ? Math.max(...poses.values.map(Math.abs)) : 0).toBeLessThan(1e-5);
  });

  it('have fields whose squares add up to a third of that of the one which moves a vertex most', async () => {
    const both = await morphedBar(bumpAt(2, 0.4), bumpAt(6, 0.4));
    const fieldsOf = async (model: typeof both) => {
      const [body] = model.bodies;
      return posesOf(model.document, body, weldOf(body.positions, body.indices), 2)!;
    };
    const squaresAt = ({ values, size }: { values: Float32Array; size: number }, v: number) =>
      values.subarray(size * v, size * (v + 1)).reduce((sum, value) => sum + value * value, 0);
    const [two, first, second] = [
      await fieldsOf(both),
      await fieldsOf(await morphedBar(bumpAt(2, 0.4))),
      await fieldsOf(await morphedBar(bumpAt(6, 0.4))),
    ];
    expect([two.size, two.animated]).toEqual([6, 0]);
    for (let v = 0; v < count; ++v) {
      expect(squaresAt(two, v)).toBeCloseTo(Math.max(squaresAt(first, v), squaresAt(second, v)), 5);
      expect(squaresAt(first, v)).toBeLessThan(0.4 ** 2 / 3);
    }
  });

  it('with equal shapes count less than twice as much as one', async () => {
    const [one, four] = [await morphedBar(bumpAt(4, 1)), await morphedBar(...Array(4).fill(bumpAt(4, 1)))];
    const sums = [one, four].map((model) => {
      const [body] = model.bodies;
      const { values } = posesOf(model.document, body, weldOf(body.positions, body.indices), 2)!;
      return values.reduce((sum, value) => sum + value * value, 0);
    });
    expect(sums[1]).toBeLessThan(2.001 * sums[0]);
  });

  it('keep vertices where they bend a flat sheet', async () => {
    const core = await loadTestCore(1);
    const sheet = grid(24, 24);
    const height = (x: number, y: number) => 0.1 * Math.exp(-((x - 0.5) ** 2 + (y - 0.5) ** 2) / 0.1 ** 2);
    const sharesInside: number[] = [];
    for (const isMorphed of [false, true]) {
      const document = startDocument();
      const primitive = primitiveOf(document, sheet);
      const moves = Array.from(sheet.positions, (_, i) =>
        i % 3 === 2 && isMorphed ? height(sheet.positions[i - 2], sheet.positions[i - 1]) : 0,
      );
      const target = document.createPrimitiveTarget();
      primitive.addTarget(target.setAttribute('POSITION', floats(document, 'VEC3', moves)));
      addMesh(document, 'sheet', [primitive]);
      const run = runOfModel(core, await openModel([await glbFile(document)]));
      const { mesh } = run.get(STAGES.level, { ...defaultSettings(), maxDeviation: 0, targetFaces: 230 });
      const isInside = (v: number) =>
        Math.hypot(mesh.positions[3 * v] - 0.5, mesh.positions[3 * v + 1] - 0.5) < 0.2;
      const vertices = Array.from({ length: mesh.positions.length / 3 }, (_, v) => v);
      sharesInside.push(vertices.filter(isInside).length / vertices.length);
    }
    expect(sharesInside[0]).toBeLessThan(0.25);
    expect(sharesInside[1]).toBeGreaterThan(2 * sharesInside[0]);
  });
});
