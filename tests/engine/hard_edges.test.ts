import type { Accessor, Document } from '@gltf-transform/core';
import { beforeAll, describe, expect, it } from 'vitest';
import { cosinesOf, endsOf, hardCosineOf, innerEdgesOf } from '../../web/engine/body/hard_edges';
import type { Core, TriangleMesh } from '../../web/engine/core/core';
import { exportGlb } from '../../web/engine/document/export';
import { ALL_HARD } from '../../web/engine/document/shading/normals';
import { openModel } from '../../web/engine/document/open';
import { defaultSettings } from '../../web/engine/settings/options';
import { STAGES } from '../../web/engine/stages/stages';
import { loadTestCore } from './support/core';
import { addMesh, floats, glbFile, primitiveOf, readGlb, startDocument } from './support/gltf';
import { optimized, runOfModel } from './support/runs';
import { turnedSolid } from './support/scenes';
import { box, grid } from './support/shapes';

let core: Core;

beforeAll(async () => {
  core = await loadTestCore(1);
});

/** A tube of `around` sides with rings at equal heights, closed at both ends. */
const tube = (around: number, rings: number): TriangleMesh =>
  turnedSolid(
    Array<number>(rings).fill(0.5),
    Array.from({ length: rings }, (_, k) => (3 * k) / (rings - 1)),
    around,
  );

/** Every triangle with vertices of its own. */
const soupOf = ({ positions, triangles }: TriangleMesh): TriangleMesh => ({
  positions: Float32Array.from(
    Array.from(triangles).flatMap((v) => [...positions.subarray(3 * v, 3 * v + 3)]),
  ),
  triangles: Uint32Array.from(triangles, (_, i) => i),
});

type Normal = (face: number[], corner: number[], triangle: number) => number[];

function faceNormal(positions: ArrayLike<number>, first: number): number[] {
  const at = (k: number, c: number) => positions[first + 3 * k + c] - positions[first + c];
  const n = [0, 1, 2].map((c) => {
    const [u, v] = [(c + 1) % 3, (c + 2) % 3];
    return at(1, u) * at(2, v) - at(1, v) * at(2, u);
  });
  return n.map((value) => value / Math.hypot(...n));
}

function normalsOf(document: Document, { positions }: TriangleMesh, normal: Normal): Accessor {
  const values = Array.from({ length: positions.length / 3 }, (_, v) => {
    const face = faceNormal(positions, 9 * Math.floor(v / 3));
    return normal(face, [...positions.subarray(3 * v, 3 * v + 3)], Math.floor(v / 3));
  });
  return floats(document, 'VEC3', values.flat());
}

/** Round about y where a face stands, flat where it lies. */
const roundSides: Normal = (face, [x, , z]) => {
  if (Math.abs(face[1]) > 0.9) return face;
  const length = Math.hypot(x, z);
  return [x / length, 0, z / length];
};

async function open(mesh: TriangleMesh, normal: Normal, uvOf?: (v: number, soup: TriangleMesh) => number[]) {
  const soup = soupOf(mesh);
  const document = startDocument();
  const primitive = primitiveOf(document, soup).setAttribute('NORMAL', normalsOf(document, soup, normal));
  if (uvOf) {
    const uv = Array.from(soup.triangles).flatMap((v) => uvOf(v, soup));
    primitive.setAttribute('TEXCOORD_0', floats(document, 'VEC2', uv));
  }
  addMesh(document, 'thing', [primitive]);
  const model = await openModel([await glbFile(document)]);
  const run = runOfModel(core, model);
  const prepared = run.get(STAGES.prepared, defaultSettings());
  return { model, run, prepared };
}

/** Edges at which wedges differ from one side to the other. */
function seamCount({ prepared }: Awaited<ReturnType<typeof open>>): number {
  const { mesh, attributes } = prepared;
  const { wedges } = attributes.charts;
  const edges = innerEdgesOf(mesh);
  return edges.first.filter((_, edge) => endsOf(mesh, edges, edge).some(([a, b]) => wedges[a] !== wedges[b]))
    .length;
}

describe('normals that follow from the angle between faces', () => {
  it('make no seams where every face has its own', async () => {
    const opened = await open(tube(12, 4), (face) => face);
    expect(seamCount(opened)).toBe(0);
    expect(opened.prepared.attributes.hardCosine).toBe(ALL_HARD);
  });

  it('make no seams where round sides meet flat ends', async () => {
    const opened = await open(tube(12, 4), roundSides);
    expect(seamCount(opened)).toBe(0);
    // The sides meet at 30 degrees, the ends at 90: the middle of their cosines.
    expect(opened.prepared.attributes.hardCosine).toBeCloseTo(Math.cos(Math.PI / 6) / 2, 4);
  });

  it('leave seams of texture coordinates on the same edges', async () => {
    const opened = await open(tube(12, 4), roundSides, (v, { positions }) => {
      const isSide = Math.abs(faceNormal(positions, 9 * Math.floor(v / 3))[1]) < 0.5;
      return isSide ? [positions[3 * v + 1], 1] : [0, 0];
    });
    expect(seamCount(opened)).toBe(24);
  });

  it('are ordinary attributes if no angle separates hard edges from soft ones', async () => {
    // The strips of one flat sheet take turns: at all angles between faces, which are 0, some edges are hard.
    const opened = await open(grid(4, 4), (_face, _corner, triangle) =>
      triangle % 16 < 8 ? [0, 0, 1] : [0, 0.6, 0.8],
    );
    expect(opened.prepared.attributes.hardCosine).toBeNull();
    expect(seamCount(opened)).toBeGreaterThan(0);
  });

  it('of a flat side are shared by its faces, so that a file with fewer of them is smaller', async () => {
    const { model, run } = await open(box(4, 4, 24), (face) => face);
    const settings = { ...defaultSettings(), modeCount: 6, maxDeviation: 0 };
    const exported = run.get(STAGES.written, { ...settings, targetFaces: 400, fields: false });
    const glb = await readGlb(await exportGlb(model, [exported], { fields: false }));
    const [primitive] = glb.getRoot().listMeshes()[0].listPrimitives();
    const faces = primitive.getIndices()!.getCount() / 3;
    expect(faces).toBeLessThanOrEqual(400);
    // Changed corners share a vertex with those beside them in their plane; corners of untouched faces may have one of their own.
    expect(primitive.getAttribute('POSITION')!.getCount()).toBeLessThan(1.5 * faces);
  });

  it('do not lock edges, and are recomputed with the same angle', async () => {
    const { model, run } = await open(box(4, 4, 24), (face) => face);
    const settings = { ...defaultSettings(), modeCount: 6, maxDeviation: 0 };
    const { result } = optimized(run, settings, 60);
    expect(result.mesh.triangles.length / 3).toBeLessThanOrEqual(60);
    const exported = run.get(STAGES.written, { ...settings, targetFaces: 60, fields: false });
    const glb = await readGlb(await exportGlb(model, [exported], { fields: false }));
    const [primitive] = glb.getRoot().listMeshes()[0].listPrimitives();
    const [positions, normals] = ['POSITION', 'NORMAL'].map((name) => primitive.getAttribute(name)!);
    const corners = [...primitive.getIndices()!.getArray()!];
    const at = (accessor: Accessor, v: number) => accessor.getElement(v, []);
    for (let t = 0; t < corners.length; t += 3) {
      const face = faceNormal(
        corners.slice(t, t + 3).flatMap((v) => at(positions, v)),
        0,
      );
      for (const v of corners.slice(t, t + 3))
        at(normals, v).forEach((value, c) => expect(value).toBeCloseTo(face[c], 4));
    }
  });
});

describe('the angle of hard edges', () => {
  const mesh = tube(8, 2);
  const edges = innerEdgesOf(mesh);
  const cosines = cosinesOf(mesh, edges);

  it('is absent if no edge is hard', () => {
    expect(hardCosineOf(mesh, edges, cosines, () => false)).toBeNull();
  });

  it('has the least length of edges on the wrong side', () => {
    const isHard = (edge: number) => cosines[edge] < 0.5;
    const one = edges.first.findIndex((_, edge) => isHard(edge));
    const found = hardCosineOf(mesh, edges, cosines, (edge) => isHard(edge) && edge !== one)!;
    expect(found).toBeGreaterThan(1e-6);
    expect(found).toBeLessThan(Math.cos(Math.PI / 4));
  });

  it('counts each edge between two faces once, and no border', () => {
    expect(edges.first.length).toBe((3 * mesh.triangles.length) / 6);
    expect(innerEdgesOf(grid(1, 1)).first.length).toBe(1);
  });
});
