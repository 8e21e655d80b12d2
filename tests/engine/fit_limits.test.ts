import { beforeAll, describe, expect, it } from 'vitest';
import type { Core, TriangleMesh } from '../../web/engine/core/core';
import { fitReport } from '../../web/engine/report/result_report';
import { defaultSettings } from '../../web/engine/settings/options';
import type { Settings } from '../../web/engine/settings/options';
import { fitResult, fitSettings } from '../../web/engine/stages/fit';
import { STAGES } from '../../web/engine/stages/stages';
import { loadTestCore } from './support/core';
import { optimized, runOfMesh } from './support/runs';
import { torus } from './support/shapes';

let core: Core;
beforeAll(async () => {
  core = await loadTestCore(1);
});

function reduced(mesh: TriangleMesh, targetFaces: number, change: Partial<Settings>) {
  const settings = { ...defaultSettings(), fit: 'modal' as const, modeCount: 6, ...change };
  const { fitted, measured } = optimized(runOfMesh(core, mesh), settings, targetFaces);
  return { fitted, ...measured };
}

/** Each limit is one that the fit would violate if it ignored it. */
describe('a fit to the surface with limits', () => {
  const fit = 'surface' as const;

  it('respects the largest deviation', () => {
    const free = reduced(torus(), 200, { fit });
    const maxDeviation = 0.8 * free.distance.hausdorff;
    const limited = reduced(torus(), 200, { fit, maxDeviation });
    expect(limited.fitted.unfitted).toBe('');
    expect(limited.distance.hausdorff).toBeLessThanOrEqual(maxDeviation);
  });

  it('stays one to the surface where it would break a limit', () => {
    const run = runOfMesh(core, torus());
    const all = { ...defaultSettings(), fit, minAngle: 1, modeCount: 6, targetFaces: 200 };
    const [prepared, result] = [run.get(STAGES.prepared, all), run.get(STAGES.level, all)];
    const flattened: Core = Object.assign(Object.create(core), {
      measureQuality: (mesh: TriangleMesh) => ({
        ...core.measureQuality(mesh),
        minAngle: mesh === result.mesh ? 30 : 0,
      }),
    });
    const fitted = fitResult(flattened, prepared, result, { constraints: {}, settings: fitSettings(all) });
    expect(fitted.unfitted).toMatch(/would break a limit/);
    expect(fitReport([fitted])).toEqual({ fit: { kind: 'surface', unfitted: [fitted.unfitted] } });
  });

  it('is none where it changes nothing', () => {
    const { fitted } = reduced(torus(), torus().triangles.length / 3, { fit });
    expect(fitReport([fitted])).toEqual({});
    expect(fitReport([fitted, reduced(torus(), 200, { fit }).fitted])).toMatchObject({
      fit: { kind: 'surface' },
    });
  });

  it('respects the smallest angle', () => {
    const minAngle = 25;
    expect(reduced(torus(), 200, { fit }).quality.minAngle).toBeLessThan(minAngle);
    const limited = reduced(torus(), 200, { fit, minAngle });
    expect(limited.fitted.unfitted).toBe('');
    expect(limited.quality.minAngle).toBeGreaterThanOrEqual(minAngle);
  });
});

/** Each limit is one that the fit would violate if it ignored it. */
describe('a fit to the modes with limits', () => {
  it('respects the largest deviation', () => {
    const free = reduced(torus(), 200, {});
    const maxDeviation = 0.8 * free.distance.hausdorff;
    const limited = reduced(torus(), 200, { maxDeviation });
    expect(limited.fitted.unfitted).toBe('');
    expect(limited.distance.hausdorff).toBeLessThanOrEqual(maxDeviation);
    expect(limited.fitted.errorAfter[0]).toBeLessThan(0.8 * limited.fitted.errorBefore[0]);
  });

  it('respects the smallest angle', () => {
    const minAngle = 25;
    expect(reduced(torus(), 200, {}).quality.minAngle).toBeLessThan(minAngle);
    const limited = reduced(torus(), 200, { minAngle });
    expect(limited.fitted.unfitted).toBe('');
    expect(limited.quality.minAngle).toBeGreaterThanOrEqual(minAngle);
    expect(limited.fitted.errorAfter[0]).toBeLessThan(0.8 * limited.fitted.errorBefore[0]);
  });
});
