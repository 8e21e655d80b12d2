import { beforeAll, describe, expect, it } from 'vitest';
import type { Core } from '../../web/engine/core/core';
import { defaultSettings } from '../../web/engine/settings/options';
import { meshReport } from '../../web/engine/report/mesh_report';
import { modesReport } from '../../web/engine/report/modes_report';
import { startReport } from '../../web/engine/report/report';
import { describeShapeFit } from '../../web/engine/report/fit_words';
import { fitReport, worstSurface } from '../../web/engine/report/result_report';
import { describeRefused, stopReport } from '../../web/engine/report/stop_report';
import { prepareBody } from '../../web/engine/stages/prepared';
import { STAGES } from '../../web/engine/stages/stages';
import { bodyOf } from './support/bodies';
import { loadTestCore } from './support/core';
import { runOfMesh } from './support/runs';
import { cube, grid, torus } from './support/shapes';

let core: Core;
beforeAll(async () => {
  core = await loadTestCore(1);
});

const prepare = (mesh = cube()) => prepareBody(core, bodyOf(mesh), defaultSettings());

describe('a report', () => {
  it('starts with the fields of every report, and spells infinity', () => {
    const report = startReport(core, 'optimize', { p: Infinity, ratio: 0.5 }, [prepare()]);
    expect(report).toMatchObject({ schema: 'limber-report/1', command: 'optimize', threads: 1, timings: {} });
    expect(report.options).toEqual({ p: 'inf', ratio: 0.5 });
    expect(JSON.parse(JSON.stringify(report))).toEqual(report);
  });

  it('sums over bodies, and has the smallest angle and the mean over all faces', () => {
    const [sheet, ring] = [prepare(grid(4, 4)), prepare(torus())];
    const both = meshReport([sheet, ring]);
    expect(both).toMatchObject({
      faces: 32 + 576,
      components: 2,
      boundaryLoops: 1,
      genus: 1,
      eulerCharacteristic: 1,
    });
    expect(both.minAngle).toBe(Math.min(sheet.quality.minAngle, ring.quality.minAngle));
    const mean = (32 * sheet.quality.meanMinAngle + 576 * ring.quality.meanMinAngle) / 608;
    expect(both.meanMinAngle).toBeCloseTo(mean, 9);
  });

  it('has no genus if one body is not a manifold', () => {
    const fan = {
      positions: Float32Array.from([0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, -1, -1, 0]),
      triangles: Uint32Array.from([0, 1, 2, 0, 1, 3, 0, 1, 4]),
    };
    expect(meshReport([prepare(fan), prepare()])).toMatchObject({ genus: null, nonManifoldEdges: 1 });
  });

  it('numbers the components of all bodies consecutively and sorts their modes', () => {
    const settings = { ...defaultSettings(), model: 'shell' as const, modeCount: 3 };
    const sets = [grid(4, 4), torus()].map((mesh) => runOfMesh(core, mesh).get(STAGES.modes, settings));
    const report = modesReport(sets);
    expect(report.components.map(({ faces }) => faces)).toEqual([32, 576]);
    expect(report.zeroModes).toEqual({ expected: 12, found: 12 });
    expect(report.modes.map(({ component }) => component).sort()).toEqual([0, 0, 0, 1, 1, 1]);
    const omegas = report.modes.map(({ omega }) => omega);
    expect(omegas).toEqual([...omegas].sort((a, b) => a - b));
    expect(report.modes[0].frequency).toBeCloseTo(report.modes[0].omega / (2 * Math.PI), 9);
    expect(report.modes[0]).not.toHaveProperty('nominal');
    const run = runOfMesh(core, grid(4, 4));
    const laplacian = run.get(STAGES.modes, { ...settings, model: 'laplacian' });
    expect(modesReport([laplacian]).modes[0]).toMatchObject({ nominal: true, along: 'shortest' });
    expect(modesReport([...sets, laplacian]).model).toBe('mixed');
  });

  it('gives the frequency error of the worst part, and what was not fitted', () => {
    const fit = (before: number[], after: number[], unfitted = '') => ({
      kind: 'modal' as const,
      flips: 7,
      errorBefore: Float64Array.from(before),
      errorAfter: Float64Array.from(after),
      unfitted,
    });
    expect(fitReport([fit([], []), fit([], [])])).toEqual({});
    expect(fitReport([fit([2, 4], [0.1, 0.3]), fit([5], [0.2])])).toEqual({
      fit: { kind: 'modal', before: 5, after: 0.3 },
    });
    expect(fitReport([fit([2], [1]), fit([], [], 'too large'), fit([], [], 'too large')])).toEqual({
      fit: { kind: 'modal', before: 2, after: 1, unfitted: ['too large'] },
    });
    expect(fitReport([fit([], [], 'too large')])).toEqual({
      fit: { kind: 'modal', unfitted: ['too large'] },
    });
  });

  it('counts the flips of fits to the surface, which know no frequencies', () => {
    const none = new Float64Array();
    const fit = (flips: number, unfitted = '') => ({
      kind: 'surface' as const,
      flips,
      errorBefore: none,
      errorAfter: none,
      unfitted,
    });
    expect(fitReport([fit(3), fit(4)])).toEqual({ fit: { kind: 'surface', flips: 7 } });
    expect(describeShapeFit(fit(1))).toBe('fitted to the surface (1 edge flipped)');
    expect(fitReport([fit(3), fit(0, 'too far')])).toEqual({
      fit: { kind: 'surface', flips: 3, unfitted: ['too far'] },
    });
    expect(fitReport([fit(0, 'too far')])).toEqual({ fit: { kind: 'surface', unfitted: ['too far'] } });
  });

  it('is exhausted if one body missed its target, and gives the share of each reason in it', () => {
    const refused = { topology: 2, flip: 1, lock: 1, angle: 0, deviation: 0 };
    const reached = { faces: 10, targetFaces: 10, history: { refused, stop: 'exhausted' as const } };
    expect(stopReport([reached]).reason).toBe('target');
    expect(stopReport([reached, { ...reached, faces: 11 }])).toEqual({
      reason: 'exhausted',
      refused,
    });
    expect(describeRefused(refused)).toBe(
      'of the remaining edges 50 % would change the topology, 25 % flip a face, 25 % break a seam, a border or a lock',
    );
    expect(describeRefused({ topology: 0, flip: 0, lock: 0, angle: 0, deviation: 0 })).toBe(
      'no edge is left that could collapse',
    );
  });

  it('has the largest distance of all bodies', () => {
    const distances = [
      { hausdorff: 1, mean: 0.5, vertexHausdorff: 3 },
      { hausdorff: 2, mean: 0.1, vertexHausdorff: 1 },
    ];
    expect(worstSurface(distances)).toEqual({ hausdorff: 2, mean: 0.5, vertexHausdorff: 3 });
  });
});
