import { beforeAll, describe, expect, it } from 'vitest';
import { bindingOfBody } from '../../web/engine/body/body_binding';
import type { BodyBinding } from '../../web/engine/body/body_binding';
import { readBinding, writeBinding } from '../../web/engine/report/binding_file';
import { NONE } from '../../web/engine/core/core';
import type { Binding, Core, MeshAt, TriangleMesh } from '../../web/engine/core/core';
import { exportGlb } from '../../web/engine/document/export';
import { openModel } from '../../web/engine/document/open';
import type { Body, OpenModel } from '../../web/engine/document/open';
import { bindingBetween } from '../../web/engine/motion/simulation';
import { prepareBody } from '../../web/engine/stages/prepared';
import { defaultSettings } from '../../web/engine/settings/options';
import type { PreparedBody } from '../../web/engine/body/prepared_body';
import { exportedBody } from '../../web/engine/stages/written';
import { loadTestCore } from './support/core';
import { failureOf, textFile } from './support/files';
import { optimized, runOfModel } from './support/runs';
import { grid, toObj, torus } from './support/shapes';

interface Bound {
  model: OpenModel;
  prepared: PreparedBody;
  result: MeshAt;
  body: BodyBinding;
}

let core: Core;
let bound: Bound;
beforeAll(async () => {
  core = await loadTestCore(1);
  // The first vertex is used by no face.
  const lines = toObj(torus()).replace(/f (\d+) (\d+) (\d+)/g, (_, ...corners: string[]) =>
    ['f', ...corners.slice(0, 3).map((corner) => Number(corner) + 1)].join(' '),
  );
  const model = await openModel([textFile('torus.obj', `v 9 9 9\n${lines}`)]);
  const settings = { ...defaultSettings(), method: 'qem' as const };
  const { prepared, result } = optimized(runOfModel(core, model), settings, 150);
  const written = exportedBody(core, prepared, result, null);
  const binding = core.bindToResult(prepared.mesh, result);
  bound = { model, prepared, result, body: bindingOfBody(prepared, result.mesh, written, binding) };
});

describe('a binding file', () => {
  it('is read back as it was written', () => {
    expect(readBinding('bind.json', writeBinding([bound.body]))).toEqual([bound.body]);
  });

  it('places every vertex of the original on the triangles of the exported file', async () => {
    const { model, prepared, result, body } = bound;
    const bytes = await exportGlb(model, [exportedBody(core, prepared, result, null)], { fields: false });
    const [written] = (await openModel([{ name: 'out.glb', bytes }])).bodies;
    const { triangle, barycentric } = body.binding;
    expect(triangle[0]).toBe(NONE);
    expect(farthest(model.bodies[0], written, body.binding)).toBeLessThan(0.12);
    for (let v = 1; v < triangle.length; ++v)
      expect(barycentric[3 * v] + barycentric[3 * v + 1] + barycentric[3 * v + 2]).toBeCloseTo(1, 6);
  });

  it('numbers triangles with back sides, and reversed ones, as in the exported file', async () => {
    const { positions, triangles } = grid(12, 12);
    const height = (v: number) => 0.1 * Math.sin(5 * positions[3 * v]);
    const lines = Array.from({ length: positions.length / 3 }, (_, v) =>
      ['v', positions[3 * v], positions[3 * v + 1], height(v)].join(' '),
    );
    const faces = Array.from({ length: triangles.length / 3 }, (_, t) => {
      const [a, b, c] = triangles.subarray(3 * t, 3 * t + 3).map((v) => v + 1);
      return { front: `f ${a} ${b} ${c}`, back: `f ${a} ${c} ${b}`, isTurned: t % 5 === 0 };
    });
    const [left, right] = [faces.slice(0, faces.length / 2), faces.slice(faces.length / 2)];
    lines.push('usemtl left', ...left.flatMap(({ front, back }) => [front, back]));
    lines.push('usemtl right', ...right.map(({ front, back, isTurned }) => (isTurned ? back : front)));
    const model = await openModel([textFile('sheet.obj', lines.join('\n'))]);
    const { prepared, result } = optimized(
      runOfModel(core, model),
      { ...defaultSettings(), method: 'qem' },
      150,
    );
    const written = exportedBody(core, prepared, result, null);
    const found = core.bindToResult(prepared.mesh, result);
    const body = bindingOfBody(prepared, result.mesh, written, found);
    const bytes = await exportGlb(model, [written], { fields: false });
    const again = await openModel([{ name: 'out.glb', bytes }]);
    expect(body.faces).toBe(again.bodies[0].indices.length / 3);
    expect(farthest(model.bodies[0], again.bodies[0], body.binding)).toBeLessThan(0.03);
    const other = prepareBody(core, again.bodies[0], defaultSettings(), again.document);
    expect(() => bindingBetween(prepared, other, [{ ...body, faces: body.faces - 1 }])).toThrow(
      `The binding is of another result of "sheet", which has ${body.faces - 1} faces and not ${body.faces}: write it again together with the optimized mesh.`,
    );
    const { triangle, barycentric } = bindingBetween(prepared, other, [body]);
    expect(
      farthest({ positions: prepared.mesh.positions }, meshAsBody(other.mesh), {
        triangle,
        barycentric,
        offset: new Float32Array(triangle.length),
      }),
    ).toBeLessThan(0.03);
  });

  it('is refused if it is damaged', async () => {
    const text = writeBinding([bound.body]);
    const cases: [string, string][] = [
      ['torus', 'is not JSON'],
      ['{"schema":"limber-report/1"}', 'is no binding file, because its "schema" is not "limber-binding/1"'],
      [text.replace(/"offset": ".{8}/, '"offset": "'), 'has damaged arrays for "torus"'],
      [text.replace(/"faces": \d+/, '"faces": 3'), 'refers to a triangle that "torus" does not have'],
      [text.replace(/"mesh": \d+/, '"mesh": 0.5'), 'lacks the mesh index or the face count of "torus"'],
      [writeBinding([withInfinity(bound.body)]), 'has a coordinate of "torus" that is not finite'],
    ];
    for (const [content, problem] of cases)
      expect(await failureOf(() => readBinding('bind.json', content))).toBe(
        `bind.json ${problem}: write it again with limber optimize --bind.`,
      );
  });
});

function withInfinity(body: BodyBinding): BodyBinding {
  const offset = body.binding.offset.slice();
  offset[0] = Infinity;
  return { ...body, binding: { ...body.binding, offset } };
}

const meshAsBody = ({ positions, triangles }: TriangleMesh) => ({ positions, indices: triangles });

/** How far at most a coordinate of a vertex is from where the binding has it on the triangles of `written`. */
function farthest(
  original: Pick<Body, 'positions'>,
  written: Pick<Body, 'positions' | 'indices'>,
  { triangle, barycentric, offset }: Binding,
): number {
  let most = 0;
  triangle.forEach((t, v) => {
    if (t === NONE) return;
    const corners = [0, 1, 2].map((k) => written.indices[3 * t + k]);
    const [a, b, c] = corners.map((corner) => [...written.positions.slice(3 * corner, 3 * corner + 3)]);
    const normal = unitNormal(a, b, c);
    for (let axis = 0; axis < 3; ++axis) {
      const foot = [a, b, c].reduce((sum, p, k) => sum + barycentric[3 * v + k] * p[axis], 0);
      const point = foot + offset[v] * normal[axis];
      most = Math.max(most, Math.abs(point - original.positions[3 * v + axis]));
    }
  });
  return most;
}

function unitNormal(a: number[], b: number[], c: number[]): number[] {
  const [u, w] = [b, c].map((point) => point.map((value, axis) => value - a[axis]));
  const normal = [0, 1, 2].map((i) => u[(i + 1) % 3] * w[(i + 2) % 3] - u[(i + 2) % 3] * w[(i + 1) % 3]);
  const length = Math.hypot(...normal);
  return normal.map((value) => value / length);
}
