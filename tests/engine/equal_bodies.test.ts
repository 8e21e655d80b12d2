/** Equal bodies of a file are worked on once; bodies too small to move visibly are not analysed. */

import { beforeAll, describe, expect, it } from 'vitest';
import type { Document } from '@gltf-transform/core';
import type { Core } from '../../web/engine/core/core';
import { openModel } from '../../web/engine/document/open';
import { defaultSettings } from '../../web/engine/settings/options';
import { requestFile } from '../../web/engine/stages/budget/file_targets';
import { ValueCache } from '../../web/engine/stages/many_bodies/value_cache';
import { FileOutput } from '../../web/engine/stages/file_output';
import { FileRun } from '../../web/engine/stages/file_run';
import { sharesOfScene, tooSmallToMove } from '../../web/engine/stages/many_bodies/scene_share';
import { STAGES } from '../../web/engine/stages/stages';
import { loadTestCore } from './support/core';
import { addMesh, glbFile, primitiveOf, readGlb, startDocument } from './support/gltf';
import { ball, moved, partsScene } from './support/scenes';

let core: Core;
beforeAll(async () => {
  core = await loadTestCore(1);
});

/** The core, and how often each of its functions was called. */
function counted(): { core: Core; calls: Map<string, number> } {
  const calls = new Map<string, number>();
  const counting = new Proxy(core, {
    get: (target, name: keyof Core) => {
      calls.set(name, (calls.get(name) ?? 0) + 1);
      return target[name];
    },
  });
  return { core: counting, calls };
}

async function optimized(document: Document, by: Core) {
  const model = await openModel([await glbFile(document)]);
  const settings = defaultSettings();
  const file = new FileRun(by, model, { guides: true });
  const output = new FileOutput(
    file,
    requestFile(file, { settings, fields: false, faces: null, ratio: 0.5 }),
  );
  output.compute();
  return { file, output, settings, model };
}

describe('work on equal inputs', () => {
  it('is done once, and again for any other bit', () => {
    const cache = new ValueCache(10);
    let runs = 0;
    const run = (values: number[], count = 1) =>
      cache.once('sum', [Float32Array.from(values), { count }], () => ++runs);
    expect([run([1, 2]), run([1, 2]), run([1, 3]), run([1, 2], 2), run([1, 2])]).toEqual([1, 1, 2, 3, 1]);
    expect([run([0]), run([-0]), run([NaN]), run([NaN])]).toEqual([4, 5, 6, 6]);
    expect(cache.once('other', [Float32Array.from([1, 2]), { count: 1 }], () => 'own')).toBe('own');
    expect(cache.once('kind', [new Uint8Array(4)], () => 8)).toBe(8);
    expect(cache.once('kind', [new Uint32Array(1)], () => 32)).toBe(32);
  });

  it('is forgotten, the oldest first', () => {
    const cache = new ValueCache(2);
    let runs = 0;
    const run = (value: number) => cache.once('next', [value], () => ++runs);
    expect([run(1), run(2), run(3), run(3), run(2), run(1)]).toEqual([1, 2, 3, 3, 2, 4]);
  });
});

describe('equal bodies', () => {
  it('are analysed, reduced and fitted once', async () => {
    const counting = counted();
    await optimized(partsScene(6, true), counting.core);
    expect(counting.calls.get('findModes')).toBe(1);
    expect(counting.calls.get('simplify')).toBe(1);
    expect(counting.calls.get('weld')).toBe(1 + 6); // the results are welded one by one
    expect(counting.calls.get('fitShape')).toBeLessThanOrEqual(6);
  });

  it('give the results that they give alone', async () => {
    const all = await optimized(partsScene(3, true), core);
    const [first, , third] = (await readGlb(await all.output.glb())).getRoot().listMeshes();
    const positions = [first, third].map((mesh) =>
      Array.from(mesh.listPrimitives()[0].getAttribute('POSITION')!.getArray()!),
    );
    expect(positions[0].length).toBeGreaterThan(0);
    const [a, b] = all.output.results().filter((_, i) => i !== 1);
    if (a.mesh.triangles.length === b.mesh.triangles.length) expect(positions[1]).toEqual(positions[0]);
  });
});

/** A ball of so large a radius. */
const sized = (radius: number) => moved(ball(12), (x, y, z) => [radius * x, radius * y, radius * z]);

/** A large ball at the origin, and one of `radius` at x = 10. */
function twoBalls(radius: number): Document {
  const document = startDocument();
  addMesh(document, 'large', [primitiveOf(document, sized(1))]);
  addMesh(document, 'small', [primitiveOf(document, sized(radius))]);
  const nodes = document.getRoot().listNodes();
  nodes[nodes.length - 1].setTranslation([10, 0, 0]);
  return document;
}

describe('the share of a body in its scene', () => {
  it('is that of its diagonal in the scene', async () => {
    const document = startDocument();
    addMesh(document, 'body', [primitiveOf(document, sized(1))]);
    const [node] = document.getRoot().listNodes();
    node.setScale([2, 2, 2]);
    const [mesh] = document.getRoot().listMeshes();
    document
      .getRoot()
      .getDefaultScene()!
      .addChild(document.createNode('far').setMesh(mesh).setTranslation([20, 0, 0]));
    const { bodies } = await openModel([await glbFile(document)]);
    const scene = Math.sqrt((21 - -2) ** 2 + 4 ** 2 + 4 ** 2);
    expect(sharesOfScene(document, bodies)[0]).toBeCloseTo((4 * Math.sqrt(3)) / scene, 2);
  });

  it('decides whether its modes matter: 2 % of the diagonal', async () => {
    for (const [radius, isSmall] of [
      [0.15, false],
      [0.05, true],
    ] as const) {
      const { document, bodies } = await openModel([await glbFile(twoBalls(radius))]);
      expect(tooSmallToMove(document, bodies).has(bodies[1])).toBe(isSmall);
      expect(tooSmallToMove(document, bodies).has(bodies[0])).toBe(false);
      // A body that takes part alone is the whole scene.
      expect(tooSmallToMove(document, [bodies[1]]).size).toBe(0);
    }
  });

  it('skips the modes of bodies that are too small, which are still reduced', async () => {
    const counting = counted();
    const { output } = await optimized(twoBalls(0.05), counting.core);
    expect(counting.calls.get('findModes')).toBe(1);
    const [large, small] = output.values(STAGES.modes);
    expect(large.modes.length).toBeGreaterThan(0);
    expect(small.modes.length).toBe(0);
    const { before, after } = output.writtenFaces();
    expect(after).toBeLessThan(0.8 * before);
    expect(output.report({}, []).components).toHaveLength(2);
  });
});
