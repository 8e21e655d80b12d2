import { beforeAll, describe, expect, it } from 'vitest';
import type { Core, TriangleMesh } from '../../web/engine/core/core';
import { openModel } from '../../web/engine/document/open';
import { defaultSettings } from '../../web/engine/settings/options';
import type { Settings } from '../../web/engine/settings/options';
import { STAGES } from '../../web/engine/stages/stages';
import { loadTestCore } from './support/core';
import { addMesh, floats, glbFile, primitiveOf, startDocument } from './support/gltf';
import { facesOf } from './support/mirrored';
import { optimized, runOfModel } from './support/runs';
import { butterfly, grid, torus } from './support/shapes';

let core: Core;
beforeAll(async () => {
  core = await loadTestCore(1);
});

/** A body from a file, with an attribute _KEEP if values are given. */
async function open(mesh: TriangleMesh, change: Partial<Settings>, keep?: number[]) {
  const settings = { ...defaultSettings(), modeCount: 6, ...change };
  const document = startDocument();
  const primitive = primitiveOf(document, mesh);
  if (keep) primitive.setAttribute('_KEEP', floats(document, 'SCALAR', keep));
  addMesh(document, 'thing', [primitive]);
  const model = await openModel([await glbFile(document)]);
  const run = runOfModel(core, model);
  return { settings, run, ...run.get(STAGES.constraints, settings) };
}

async function optimize(mesh: TriangleMesh, targetFaces: number, change: Partial<Settings>, keep?: number[]) {
  const { settings, run } = await open(mesh, change, keep);
  return optimized(run, settings, targetFaces);
}

describe('a mirror symmetry', () => {
  it.each([
    [100, 'limber', 'surface'],
    [101, 'limber', 'surface'],
    [100, 'limber', 'modal'],
    [101, 'limber', 'modal'],
    [61, 'limber', 'off'],
    [60, 'qem', 'off'],
    [83, 'paper', 'off'],
  ] as const)('is that of a result of %i faces by %s, fit %s', async (faces, method, fit) => {
    const { result } = await optimize(butterfly(), faces, { ...defaultSettings(method), symmetry: 'x', fit });
    expect(result.mesh.triangles.length / 3).toBeLessThanOrEqual(faces);
    expect(result.mesh.triangles.length / 3).toBeGreaterThan(faces - 8);
    expect(facesOf(result.mesh, 1)).toEqual(facesOf(result.mesh, -1));
  });

  it('is preserved by a fit that reduces the frequency errors', async () => {
    const errorOf = async (fit: Settings['fit']) => {
      const { result, prepared } = await optimize(butterfly(10, 12), 120, { symmetry: 'on', fit });
      const options = {
        modeCount: 6,
        thickness: 0.02 * prepared.diagonal,
        young: 1e6,
        poisson: 0.3,
        density: 1000,
      };
      return core.compareFidelity(prepared.mesh, result.mesh, { ...options, unit: 1 }).frequencyErrorMean;
    };
    expect(await errorOf('modal')).toBeLessThan(0.6 * (await errorOf('off')));
  });

  it('is not preserved unless requested', async () => {
    const { result, constraints } = await optimize(butterfly(), 61, { fit: 'off' });
    expect(constraints).not.toHaveProperty('mirror');
    expect(facesOf(result.mesh, 1)).not.toEqual(facesOf(result.mesh, -1));
  });

  it('that does not exist is reported in a sentence and constrains nothing', async () => {
    const across = await open(butterfly(), { symmetry: 'y' });
    expect(across.constraints).not.toHaveProperty('mirror');
    expect(across.note).toMatch(
      /^"thing" has no mirror symmetry across y to keep: \d+ vertices would have no image$/,
    );
    // Its quads cross the plane of symmetry, and a quad has only one diagonal.
    expect((await open(grid(5, 4), { symmetry: 'x' })).note).toBe(
      '"thing" has no mirror symmetry across x to keep: its vertices have images, but 40 triangles would have none',
    );
    expect((await open(butterfly(), { symmetry: 'on' })).note).toBe('');
  });
});

describe('locks, keep weights and creases', () => {
  it('leave locked vertices in place, also with the fit', async () => {
    const { result, prepared, constraints } = await optimize(torus(), 150, { lock: 'high:10' });
    expect(constraints.locked!.length).toBeGreaterThan(3);
    for (const vertex of constraints.locked!) {
      const now = result.vertexOfInput[vertex];
      expect(result.inputOfVertex[now]).toBe(vertex);
      const at = (mesh: TriangleMesh, v: number) => [...mesh.positions.subarray(3 * v, 3 * v + 3)];
      expect(at(result.mesh, now)).toEqual(at(prepared.mesh, vertex));
    }
  });

  it('keep more triangles where an attribute says so', async () => {
    const isKept = (x: number) => x > 0.3;
    const { positions } = torus();
    const keep = Array.from({ length: positions.length / 3 }, (_, v) => (isKept(positions[3 * v]) ? 1 : 0));
    const countOf = async (change: Partial<Settings>) => {
      const { result } = await optimize(torus(), 200, { method: 'qem', ...change }, keep);
      return result.mesh.positions.filter((x, i) => i % 3 === 0 && isKept(x)).length;
    };
    expect(await countOf({ keep: '_KEEP' })).toBeGreaterThan(1.4 * (await countOf({})));
  });

  it('refuse an attribute that does not exist', async () => {
    await expect(open(torus(), { keep: '_NO' })).rejects.toThrow(
      '“Keep triangles where” names the attribute _NO, but "thing" has POSITION: name one of these.',
    );
    await expect(open(torus(), { lock: 'vertices:999' })).rejects.toThrow(
      /^“Locked vertices” names vertex 999/,
    );
  });

  it('keep creases', async () => {
    const roof = butterfly(6, 8);
    for (let i = 0; i < roof.positions.length; i += 3)
      roof.positions[i + 2] = 0.2 * Math.abs(roof.positions[i]);
    const facesAcross = async (creases: number) => {
      const change = { ...defaultSettings('qem'), sizeWeight: 1000, creases };
      const { positions, triangles } = (await optimize(roof, 24, change)).result.mesh;
      const isAcross = (_: number, t: number) => {
        const x = [0, 1, 2].map((c) => positions[3 * triangles[3 * t + c]]);
        return Math.min(...x) < -1e-6 && Math.max(...x) > 1e-6;
      };
      return Array.from({ length: triangles.length / 3 }, isAcross).filter(Boolean).length;
    };
    expect(await facesAcross(15)).toBe(0);
    expect(await facesAcross(0)).toBeGreaterThan(0);
  });
});
