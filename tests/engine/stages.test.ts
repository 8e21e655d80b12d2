import { beforeAll, describe, expect, it } from 'vitest';
import type { Core, TriangleMesh } from '../../web/engine/core/core';
import { defaultSettings } from '../../web/engine/settings/options';
import type { Settings } from '../../web/engine/settings/options';
import { materialOf } from '../../web/engine/body/material';
import { findGuidance } from '../../web/engine/stages/guidance';
import { prepareBody } from '../../web/engine/stages/prepared';
import { STAGES } from '../../web/engine/stages/stages';
import { exportedBody } from '../../web/engine/stages/written';
import { describeHealth } from '../../web/engine/body/health';
import { bodyOf, together } from './support/bodies';
import { loadTestCore } from './support/core';
import { optimized, runOfMesh } from './support/runs';
import { cube, grid, torus } from './support/shapes';

let core: Core;
beforeAll(async () => {
  core = await loadTestCore(1);
});

const settings = (change: Partial<Settings> = {}): Settings => ({
  ...defaultSettings(),
  // These tests ask for numbers of faces, which the guard would stop short of.
  maxDeviation: 0,
  ...change,
});
const faces = ({ triangles }: { triangles: Uint32Array }) => triangles.length / 3;

describe('a body', () => {
  it('is welded, and measured by its usable part', () => {
    const body = bodyOf(
      together(torus(), {
        positions: Float32Array.from([0, 0, 0, 1, 0, 0]),
        triangles: Uint32Array.from([0, 1, 1]),
      }),
    );
    const prepared = prepareBody(core, body, settings());
    expect(prepared.weld.degenerateFaces).toBe(1);
    expect(faces(prepared.mesh)).toBe(faces(torus()));
    expect(prepared.inspection).toMatchObject({ genus: 1, components: 1, boundaryLoops: 0 });
    expect(prepared.diagonal).toBeCloseTo(Math.hypot(2.8, 2.8, 0.8), 5);
    expect(describeHealth(body, prepared.weld, prepared.inspection).map(({ text }) => text)).toEqual([
      '1 face with a repeated vertex set aside',
    ]);
  });

  it('without usable faces is refused with one sentence', () => {
    const body = bodyOf(
      { positions: Float32Array.from([0, 0, 0, 1, 0, 0]), triangles: Uint32Array.from([0, 1, 1]) },
      'flat',
    );
    expect(() => prepareBody(core, body, settings())).toThrow(
      'Body "flat" has no usable face, 1 with a repeated vertex: repair it and export it again.',
    );
  });

  it('has its thickness in % of the diagonal, and a unit that includes the scale of its node', () => {
    const prepared = prepareBody(core, { ...bodyOf(cube()), scale: 0.01 }, settings());
    const material = materialOf(prepared, settings({ thickness: 5, unit: 10 }));
    expect(material.thickness).toBeCloseTo(0.05 * Math.sqrt(3), 6);
    expect(material.unit).toBeCloseTo(0.1, 12);
  });

  it('vibrates the same in other units', () => {
    const centimetres = torus();
    centimetres.positions.forEach((value, i) => (centimetres.positions[i] = 128 * value));
    const shell = settings({ model: 'shell', modeCount: 3 });
    const omegasOf = (mesh: TriangleMesh, unit: number) =>
      runOfMesh(core, mesh)
        .get(STAGES.modes, { ...shell, unit })
        .modes.map((mode) => mode.omega);
    const [expected, found] = [omegasOf(torus(), 1), omegasOf(centimetres, 1 / 128)];
    found.forEach((omega, i) => expect(omega / expected[i]).toBeCloseTo(1, 9));
  });
});

describe('guidance', () => {
  const guide = (mesh = torus(), change: Partial<Settings> = {}) => {
    const used = settings({ model: 'shell', modeCount: 3, ...change });
    return runOfMesh(core, mesh).get(STAGES.guidance, used);
  };

  it('ranks the strain from 0 to 1', () => {
    const { rank } = guide();
    expect(Math.min(...rank)).toBeGreaterThanOrEqual(0);
    expect(Math.max(...rank)).toBeLessThanOrEqual(1);
    expect(Math.max(...rank)).toBeGreaterThan(0.9);
  });

  it('of one mode does not depend on its weight', () => {
    const [plain, weighted] = [
      guide(torus(), { modes: [2] }),
      guide(torus(), { modes: [2], modeWeights: [7] }),
    ];
    // Rounding may separate equal strains.
    plain.rank.forEach((rank, t) => expect(Math.abs(rank - weighted.rank[t])).toBeLessThan(0.01));
  });

  it('is 0 if a body has no elastic modes', () => {
    const run = runOfMesh(core, cube());
    const found = run.get(STAGES.modes, settings());
    const none = {
      ...found,
      modes: [],
      components: found.components.map((one) => ({ ...one, modeCount: 0 })),
    };
    const request = { ...settings(), guiding: [2] };
    const { rank } = findGuidance({ core }, run.get(STAGES.prepared, settings()), none, request);
    expect([...rank]).toEqual(Array(12).fill(0));
  });

  it('uses those of the named modes that exist, and is refused if none does', () => {
    const small = { modes: [1, 90], modeWeights: [1, 1], modeCount: 100 };
    expect(guide(cube(), small).rank).toEqual(guide(cube(), { modes: [1], modeCount: 100 }).rank);
    expect(() => guide(cube(), { modes: [90], modeCount: 100 })).toThrow(
      /^“Modes that guide” names mode 90, but "body" has only \d+: name a lower one\.$/,
    );
  });
});

describe('optimizing', () => {
  const optimize = (target: number, change: Partial<Settings> = {}, mesh = torus()) =>
    optimized(runOfMesh(core, mesh), settings(change), target);

  it.each(['paper', 'qem'] as const)('with %s reaches the target and keeps the topology', (method) => {
    const { result, measured, modes } = optimize(300, { method });
    expect(faces(result.mesh)).toBeLessThanOrEqual(300);
    expect(faces(result.mesh)).toBeGreaterThan(296);
    expect(measured.certificate).toEqual({ components: true, boundaryLoops: true, genus: true, kept: true });
    expect(measured.inspection.genus).toBe(1);
    expect(modes === null).toBe(method === 'qem');
    expect(measured.distance.hausdorff).toBeGreaterThan(0);
    expect(measured.distance.hausdorff).toBeLessThan(5);
  });

  it('to the number of faces that a body has changes nothing', () => {
    const { result, prepared, measured } = optimize(1e9);
    expect(result.mesh).toEqual(prepared.mesh);
    expect(measured.distance.hausdorff).toBeLessThan(1e-4);
  });

  it('stops at the floor and says why', () => {
    const { result, history } = optimize(1);
    expect(faces(result.mesh)).toBeGreaterThan(1);
    const { topology, flip, lock } = history.refused;
    expect(topology + flip + lock).toBeGreaterThan(0);
    expect(history.trianglesAfter[history.trianglesAfter.length - 1]).toBe(faces(result.mesh));
  });

  it('records for every face and vertex of the result its origin in the file', () => {
    const soup = together(torus(), grid(8, 8));
    const { prepared, result, guidance, curvature } = optimize(200, {}, soup);
    const exported = exportedBody(core, prepared, result, { guidance, curvature });
    expect(exported.inputOfTriangle).toHaveLength(faces(result.mesh));
    expect(Math.max(...exported.inputOfTriangle)).toBeLessThan(faces(soup));
    expect(new Set(exported.inputOfTriangle).size).toBe(faces(result.mesh));
    expect(exported.fields!.strain).toHaveLength(result.mesh.positions.length / 3);
    expect(exported.fields!.strain.every((value) => value >= 0 && value <= 1)).toBe(true);
  });

  it('keeps an open sheet open with one border', () => {
    const { measured } = optimize(40, { method: 'qem' }, grid(12, 12));
    expect(measured.inspection).toMatchObject({ boundaryLoops: 1, components: 1, eulerCharacteristic: 1 });
  });
});
