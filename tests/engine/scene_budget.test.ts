import { beforeAll, describe, expect, it } from 'vitest';
import type { Document } from '@gltf-transform/core';
import type { Core } from '../../web/engine/core/core';
import { openModel } from '../../web/engine/document/open';
import { instanceScale } from '../../web/engine/document/placements';
import { defaultSettings } from '../../web/engine/settings/options';
import type { Settings } from '../../web/engine/settings/options';
import type { ErrorCurve } from '../../web/engine/stages/budget/error_curve';
import { FileOutput } from '../../web/engine/stages/file_output';
import { FileRun } from '../../web/engine/stages/file_run';
import { requestFile } from '../../web/engine/stages/budget/file_targets';
import { SceneQueue } from '../../web/engine/stages/budget/scene_budget';
import { loadTestCore } from './support/core';
import { addMesh, glbFile, primitiveOf, readGlb, startDocument } from './support/gltf';
import { ball, boxScene, palmScene, partsScene, roomScene, tableScene, twoSidedLeaf } from './support/scenes';
import { grid } from './support/shapes';

let core: Core;
beforeAll(async () => {
  core = await loadTestCore(1);
});

/** A curve of a body that loses two faces with each collapse. */
function curveOf(errors: number[], diagonal = 1, flip = 0): ErrorCurve {
  const faces = Uint32Array.from({ length: errors.length + 1 }, (_, k) => 2 * (errors.length - k) + 4);
  const ends = Uint32Array.from({ length: errors.length + 1 }, (_, k) => k);
  const refused = { topology: 1, flip, lock: 0, angle: 0, deviation: 0 };
  return { ends, faces, written: faces, errors: Float64Array.from([0, ...errors]), diagonal, refused };
}

describe('the queue of a scene', () => {
  const bodies = [
    { curve: curveOf([0.1, 0.2, 0.9]), scale: 1, limit: 0 },
    { curve: curveOf([0.05, 0.3, 0.3]), scale: 2, limit: 0 },
  ];

  it('removes the faces with the smallest error, in units of the scene', () => {
    const queue = new SceneQueue(bodies);
    expect([queue.faces, queue.fewest]).toEqual([20, 8]);
    // 0.1 of both, the first body first; then 0.2, then twice 0.6, then 0.9.
    expect(queue.targets(18)).toEqual([8, 10]);
    expect(queue.targets(17)).toEqual([8, 8]);
    expect(queue.targets(14)).toEqual([6, 8]);
    expect(queue.targets(10)).toEqual([6, 4]);
    expect(queue.targets(1)).toEqual([4, 4]);
    expect(queue.targets(20)).toEqual([10, 10]);
  });

  it('adds up why the bodies cannot have fewer faces', () => {
    const one = { curve: curveOf([0.1], 1, 2), scale: 1, limit: 0 };
    const { refused } = new SceneQueue([one, { ...one, curve: curveOf([0.2], 1, 3) }]);
    expect(refused).toEqual({ topology: 2, flip: 5, lock: 0, angle: 0, deviation: 0 });
  });

  it('takes equal bodies down together where many of their steps have one error', () => {
    const twin = { curve: curveOf([0.1, 0.2, 0.2, 0.2, 0.2, 0.3]), scale: 1, limit: 0 };
    const queue = new SceneQueue([twin, { ...twin }, { ...twin, scale: 2 }]);
    for (let target = queue.faces; target >= queue.fewest; --target) {
      const [one, other] = queue.targets(target);
      expect(other - one).toBeGreaterThanOrEqual(0);
      expect(other - one).toBeLessThanOrEqual(2);
    }
  });

  it('lets bodies that reach their limit wait for all others', () => {
    const limited = bodies.map((body) => ({ ...body, limit: 25 }));
    // Beyond 0.25 of their diagonals: 0.9 of the first body, 0.3 of the second.
    expect(new SceneQueue(limited).targets(14)).toEqual([6, 8]);
    const small = [{ ...limited[0], limit: 8 }, limited[1]];
    expect(new SceneQueue(small).targets(18)).toEqual([10, 8]);
  });
});

describe('the scale of a mesh in its scene', () => {
  it('is the root of the sum of the squares over all instances', () => {
    const document = boxScene();
    const [ground, crate] = document.getRoot().listMeshes();
    expect(instanceScale(document, ground)).toBeCloseTo(1, 12);
    const scales = [0.5, 0.7, 0.9, 1.1, 1.3];
    expect(instanceScale(document, crate)).toBeCloseTo(Math.hypot(...scales), 6);
    expect(instanceScale(document, document.createMesh('nowhere'))).toBe(1);
  });
});

async function optimize(
  document: Document,
  change: Partial<Settings>,
  asked: { faces?: number; ratio?: number },
) {
  const settings = { ...defaultSettings(), ...change };
  const file = new FileRun(core, await openModel([await glbFile(document)]), { guides: true });
  file.prepare(settings);
  const { faces = null, ratio = null } = asked;
  const request = requestFile(file, { settings, fields: false, faces, ratio });
  const output = new FileOutput(file, request);
  output.compute();
  const written = await readGlb(await output.glb());
  const counts = written
    .getRoot()
    .listMeshes()
    .map((mesh) => mesh.listPrimitives().map((primitive) => primitive.getIndices()!.getCount() / 3));
  const report = output.report({}, []);
  file.dispose();
  return { counts, report, request, written };
}

const total = (counts: number[][]): number => counts.flat().reduce((sum, count) => sum + count, 0);

describe('half of the faces of a scene', () => {
  it('leaves a table top of two triangles and a frame of 12 alone', async () => {
    const { counts, report } = await optimize(tableScene(), { maxDeviation: 0 }, { ratio: 0.5 });
    expect(counts.slice(0, 2)).toEqual([[2], [12]]);
    expect(total(counts)).toBeLessThanOrEqual(87);
    expect(report.stop!.reason).toBe('target');
  });

  it('leaves crates and the ground alone, and takes from the ball', async () => {
    const { counts, report } = await optimize(boxScene(), {}, { ratio: 0.5 });
    expect(counts.slice(0, 2)).toEqual([[2], [12]]);
    expect(total(counts)).toBeLessThanOrEqual(1111);
    expect(total(counts)).toBeGreaterThan(1111 - 3);
    expect(report.stop!.reason).toBe('target');
  });

  it('comes from the flat floor of a house first, which loses nothing by it', async () => {
    const { counts, report } = await optimize(roomScene(), {}, { ratio: 0.5 });
    expect([counts[0], counts[2], counts[3]]).toEqual([[10], [12], [560]]);
    expect(report.surface!.hausdorff).toBeLessThan(1e-4);
  });

  it('is half of each body if requested', async () => {
    const { counts } = await optimize(boxScene(), { perBody: true, maxDeviation: 0 }, { ratio: 0.5 });
    expect(counts.slice(0, 2)).toEqual([[1], [6]]);
    expect(counts[2][0]).toBeGreaterThan(1100 - 3);
  });
});

describe('the guard', () => {
  it('stops a body at 1 % of its diagonal, and says so', async () => {
    const { report } = await optimize(tableScene(), {}, { ratio: 0.1 });
    expect(report.stop!.reason).toBe('deviation');
    expect(report.surface!.hausdorff).toBeLessThanOrEqual(1);
    const [leg] = report.stop!.guarded!;
    expect(leg).toMatchObject({ body: 'leg', limit: 1 });
    expect(leg.deviation).toBeLessThanOrEqual(1);
  });

  it('is lifted by 0', async () => {
    const { report } = await optimize(tableScene(), { maxDeviation: 0 }, { ratio: 0.2 });
    expect(report.stop!.guarded).toBeUndefined();
    expect(report.output!.faces).toBeLessThanOrEqual(34);
    expect(report.surface!.hausdorff).toBeGreaterThan(1);
  });

  it('leaves few faces instead of trading distance for size and quality', async () => {
    const document = startDocument();
    addMesh(document, 'ball', [primitiveOf(document, ball(16))]);
    addMesh(document, 'sheet', [primitiveOf(document, grid(30, 30))]);
    const { counts } = await optimize(document, {}, { faces: 1 });
    expect(counts[1]).toEqual([2]);
    expect(counts[0][0]).toBeLessThan(400);
  });

  it('judges levels with their fit, so that a ball stays within it with fewer faces than without', async () => {
    const document = startDocument();
    addMesh(document, 'ball', [primitiveOf(document, ball(24))]);
    const fewest = async (settings: Partial<Settings>) => {
      const { counts, report } = await optimize(document, settings, { faces: 1 });
      const { hausdorff } = report.surface!;
      expect(hausdorff).toBeLessThanOrEqual(1);
      expect(report.stop!.guarded![0].deviation).toBe(hausdorff);
      return counts[0][0];
    };
    expect(await fewest({ fit: 'surface' })).toBeLessThan(0.95 * (await fewest({ fit: 'off' })));
  });
});

describe('two-sided leaves', () => {
  it('come back with both sides, each wound as it was', async () => {
    const { counts, report, written } = await optimize(twoSidedLeaf(), {}, { ratio: 0.5 });
    // A collapse on the border takes one face of each side, any other two.
    const [[faces]] = counts;
    expect(counts).toEqual([[faces, faces]]);
    expect([399, 400]).toContain(faces);
    expect([report.input.faces, report.output!.faces]).toEqual([1600, 2 * faces]);
    expect([report.input.duplicateFaces, report.output!.duplicateFaces]).toEqual([800, faces]);
    const [front, back] = written.getRoot().listMeshes()[0].listPrimitives();
    const facesOf = (primitive: typeof front, reversed: boolean): string[] => {
      const positions = primitive.getAttribute('POSITION')!;
      const corner = (i: number) => positions.getElement(primitive.getIndices()!.getScalar(i), []).join();
      return Array.from({ length: faces }, (_, t) => {
        const corners = [0, 1, 2].map((c) => corner(3 * t + c));
        if (reversed) corners.reverse();
        const first = corners.indexOf([...corners].sort()[0]);
        return [...corners.slice(first), ...corners.slice(0, first)].join(' ');
      }).sort();
    };
    expect(facesOf(back, true)).toEqual(facesOf(front, false));
    // Texture coordinates of the back side are its own, five away from those of the front.
    const least = (primitive: typeof front): number =>
      Math.min(
        ...Array.from<number>(primitive.getAttribute('TEXCOORD_0')!.getArray()!).filter(
          (_, i) => i % 2 === 0,
        ),
      );
    expect(least(front)).toBeCloseTo(0, 5);
    expect(least(back)).toBeCloseTo(5, 5);
  });

  it('count with both sides in a number of faces', async () => {
    const { counts } = await optimize(twoSidedLeaf(), { maxDeviation: 0 }, { faces: 500 });
    expect(total(counts)).toBeLessThanOrEqual(500);
    expect(total(counts)).toBeGreaterThan(500 - 5);
  });

  it('of a palm keep their materials', async () => {
    const { counts } = await optimize(palmScene(), {}, { ratio: 0.5 });
    expect(counts[1][0]).toBe(counts[1][1]);
    expect(counts[1][0]).toBeGreaterThan(100);
  });
});

describe('a body whose faces are wound in different ways', () => {
  it('is written with the winding that it had', async () => {
    const document = startDocument();
    const sheet = grid(10, 10);
    const mixed = sheet.triangles.slice();
    // The right half looks down.
    for (let t = 0; t < mixed.length / 3; ++t)
      if (sheet.positions[3 * mixed[3 * t]] >= 0.5)
        [mixed[3 * t + 1], mixed[3 * t + 2]] = [mixed[3 * t + 2], mixed[3 * t + 1]];
    addMesh(document, 'sheet', [primitiveOf(document, { ...sheet, triangles: mixed })]);
    const { written, report } = await optimize(document, { maxDeviation: 0, method: 'qem' }, { ratio: 0.9 });
    const [primitive] = written.getRoot().listMeshes()[0].listPrimitives();
    const [positions, indices] = [primitive.getAttribute('POSITION')!, primitive.getIndices()!];
    let down = 0;
    for (let t = 0; t < indices.getCount() / 3; ++t) {
      const [a, b, c] = [0, 1, 2].map((k) => positions.getElement(indices.getScalar(3 * t + k), []));
      const z = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
      expect(z).not.toBe(0);
      down += z < 0 ? 1 : 0;
    }
    expect(report.input.faces).toBe(200);
    expect(down).toBeGreaterThan(70);
    expect(down).toBeLessThan(110);
  });
});

describe('a mesh that no node shows', () => {
  it('keeps its faces, which count in no number of faces', async () => {
    const document = startDocument();
    for (const name of ['shown', 'stored']) addMesh(document, name, [primitiveOf(document, grid(8, 8))]);
    document.getRoot().listNodes()[1].dispose();
    const { counts, report } = await optimize(document, {}, { faces: 40 });
    expect(counts).toEqual([[40], [128]]);
    expect([report.input.faces, report.output!.faces]).toEqual([128, 40]);
    const { notes } = await openModel([await glbFile(document)]);
    expect(notes).toEqual(['mesh "stored" is left unchanged, because no node shows it']);
  });

  it('is a body where no node shows any', async () => {
    const document = startDocument();
    addMesh(document, 'stored', [primitiveOf(document, grid(8, 8))]);
    document.getRoot().listNodes()[0].dispose();
    expect((await optimize(document, {}, { faces: 40 })).counts).toEqual([[40]]);
  });
});

describe('a file of many parts', () => {
  it('is guided in each of them, and gives the same bytes again', async () => {
    const settings = { fit: 'off' as const };
    const first = await optimize(partsScene(6), settings, { ratio: 0.5 });
    const again = await optimize(partsScene(6), settings, { ratio: 0.5 });
    expect(again.counts).toEqual(first.counts);
    expect(first.report.modes!.length).toBeGreaterThan(6 * 6);
  });
});
