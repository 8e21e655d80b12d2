import { beforeAll, describe, expect, it } from 'vitest';
import type { Core, TriangleMesh } from '../../web/engine/core/core';
import { exportGlb } from '../../web/engine/document/export';
import { ALL_HARD } from '../../web/engine/document/shading/normals';
import { openModel } from '../../web/engine/document/open';
import { defaultSettings } from '../../web/engine/settings/options';
import type { Settings } from '../../web/engine/settings/options';
import { STAGES } from '../../web/engine/stages/stages';
import { exportedMesh } from '../../web/engine/stages/written';
import { loadTestCore } from './support/core';
import { addMesh, floats, glbFile, primitiveOf, readGlb, startDocument } from './support/gltf';
import { facesOf } from './support/mirrored';
import { optimized, runOfModel } from './support/runs';
import { grid } from './support/shapes';

let core: Core;
beforeAll(async () => {
  core = await loadTestCore(1);
});

/** A wavy sheet over [-1, 1] x [0, 1], symmetric across x = 0 except that all quads are cut along the same diagonal. */
function oneWay(cellsX = 12, cellsY = 8): TriangleMesh {
  const { positions, triangles } = grid(cellsX, cellsY);
  const at = (v: number) => {
    const x = Math.round(2 * cellsX * positions[3 * v] - cellsX) / cellsX;
    const y = positions[3 * v + 1];
    return [x, y, 0.2 * x * x + 0.1 * Math.sin(5 * y + 2 * Math.abs(x))];
  };
  const moved = Array.from({ length: positions.length / 3 }, (_, v) => at(v)).flat();
  return { positions: Float32Array.from(moved), triangles };
}

/** The same as a soup: every face has its own three vertices, rotated arbitrarily; `isTurned` faces are reversed. */
function soupOf({ positions, triangles }: TriangleMesh, isTurned: (face: number) => boolean): TriangleMesh {
  const corners: number[] = [];
  for (let t = 0; t < triangles.length; t += 3) {
    const face = [0, 1, 2].map((k) => triangles[t + ((k + t / 3) % 3)]);
    corners.push(...(isTurned(t / 3) ? face.reverse() : face));
  }
  const points = corners.flatMap((v) => [...positions.subarray(3 * v, 3 * v + 3)]);
  return { positions: Float32Array.from(points), triangles: Uint32Array.from(corners, (_, i) => i) };
}

function normalOf(positions: ArrayLike<number>, face: number[]): number[] {
  const [a, b, c] = face.map((v) => [0, 1, 2].map((axis) => positions[3 * v + axis]));
  const [u, w] = [b.map((value, i) => value - a[i]), c.map((value, i) => value - a[i])];
  const n = [u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]];
  return n.map((value) => value / Math.hypot(...n));
}

interface Made {
  /** whether texture coordinates are a function of positions */
  isTextured?: boolean;
  /** whether every vertex has the normal of its face */
  isFaceted?: boolean;
}

async function open(mesh: TriangleMesh, change: Partial<Settings>, made: Made = {}) {
  const { positions, triangles } = mesh;
  const settings = { ...defaultSettings(), modeCount: 6, ...change };
  const document = startDocument();
  const primitive = primitiveOf(document, mesh);
  const vertices = Array.from({ length: positions.length / 3 }, (_, v) => v);
  if (made.isTextured) {
    const uv = vertices.flatMap((v) => [positions[3 * v], positions[3 * v + 1]]);
    primitive.setAttribute('TEXCOORD_0', floats(document, 'VEC2', uv));
  }
  if (made.isFaceted) {
    const faceOf = (v: number) => [0, 1, 2].map((k) => triangles[3 * Math.floor(v / 3) + k]);
    const normals = vertices.flatMap((v) => normalOf(positions, faceOf(v)));
    primitive.setAttribute('NORMAL', floats(document, 'VEC3', normals));
  }
  addMesh(document, 'thing', [primitive]);
  const model = await openModel([await glbFile(document)]);
  const run = runOfModel(core, model);
  return { model, run, settings, prepared: run.get(STAGES.prepared, settings) };
}

/** The prepared mesh, exported to a file and read back. */
async function written({ model, prepared }: Awaited<ReturnType<typeof open>>) {
  const glb = await readGlb(await exportGlb(model, [exportedMesh(prepared)], { fields: false }));
  return glb.getRoot().listMeshes()[0].listPrimitives()[0];
}

describe('quads that are cut along the same diagonal on both sides', () => {
  it('are cut along the other diagonal on one side, only if a symmetry is requested', async () => {
    const mesh = oneWay();
    const { prepared } = await open(mesh, { symmetry: 'x' });
    expect(prepared.body.notes).toEqual(['48 quads cut the other way, so that both sides are mirror images']);
    expect(facesOf(prepared.mesh, 1)).toEqual(facesOf(prepared.mesh, -1));
    expect(prepared.inspection).toEqual(core.inspect(prepared.mesh));
    const plain = (await open(mesh, {})).prepared;
    expect(plain.mesh.triangles).toEqual(mesh.triangles);
    expect(plain.body.notes).toEqual([]);
    expect(facesOf(plain.mesh, 1)).not.toEqual(facesOf(plain.mesh, -1));
  });

  it('collapse to a result that is its own mirror image', async () => {
    const { run, settings } = await open(oneWay(), { symmetry: 'on' }, { isTextured: true });
    expect(run.get(STAGES.constraints, settings).note).toBe('');
    const { result } = optimized(run, settings, 60);
    expect(result.mesh.triangles.length / 3).toBeLessThanOrEqual(60);
    expect(facesOf(result.mesh, 1)).toEqual(facesOf(result.mesh, -1));
  });

  it('of a soup with reversed faces keep the vertex numbers and attributes', async () => {
    const soup = soupOf(oneWay(), (face) => face % 5 === 0);
    const opened = await open(soup, { symmetry: 'x' }, { isTextured: true });
    const { weld, mesh } = opened.prepared;
    const plain = (await open(soup, {}, { isTextured: true })).prepared;
    expect(weld.flippedFaces).toBeGreaterThan(0);
    expect(weld.vertexOfSource).toEqual(plain.weld.vertexOfSource);
    expect(mesh.positions).toEqual(plain.mesh.positions);
    expect(facesOf(mesh, 1)).toEqual(facesOf(mesh, -1));
    const primitive = await written(opened);
    const [position, uv] = ['POSITION', 'TEXCOORD_0'].map((name) => primitive.getAttribute(name)!);
    expect(primitive.getIndices()!.getCount()).toBe(mesh.triangles.length);
    for (let v = 0; v < position.getCount(); ++v)
      expect(uv.getElement(v, [])).toEqual(position.getElement(v, []).slice(0, 2));
  });

  it('get their own normals if normals are per face', async () => {
    const opened = await open(
      soupOf(oneWay(), () => false),
      { symmetry: 'x' },
      { isFaceted: true },
    );
    expect(opened.prepared.attributes.hardCosine).toBe(ALL_HARD);
    const primitive = await written(opened);
    const corners = [...primitive.getIndices()!.getArray()!];
    const [positions, normals] = ['POSITION', 'NORMAL'].map((name) => primitive.getAttribute(name)!);
    for (let t = 0; t < corners.length; t += 3) {
      const face = corners.slice(t, t + 3);
      const expected = normalOf(positions.getArray()!, face);
      for (const v of face)
        normals.getElement(v, []).forEach((value, axis) => expect(value).toBeCloseTo(expected[axis], 5));
    }
  });

  it('stay if a seam runs along their diagonals on both sides', async () => {
    const soup = soupOf(oneWay(4, 2), () => false);
    const document = startDocument();
    const primitive = primitiveOf(document, soup);
    const ownCharts = Array.from({ length: soup.positions.length / 3 }, (_, v) => [Math.floor(v / 3), v % 3]);
    primitive.setAttribute('TEXCOORD_0', floats(document, 'VEC2', ownCharts.flat()));
    addMesh(document, 'thing', [primitive]);
    const model = await openModel([await glbFile(document)]);
    const settings: Settings = { ...defaultSettings(), symmetry: 'x' };
    const run = runOfModel(core, model);
    expect(run.get(STAGES.prepared, settings).body).toBe(model.bodies[0]);
    expect(run.get(STAGES.constraints, settings).note).toBe(
      '"thing" has no mirror symmetry across x to keep: its vertices have images, but 16 triangles would have none',
    );
  });
});
