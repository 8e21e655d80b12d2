import { beforeAll, describe, expect, it } from 'vitest';
import type { Core } from '../../web/engine/core/core';
import { fewestFacesWithin } from '../../web/engine/stages/budget/frequency_target';
import { defaultSettings } from '../../web/engine/settings/options';
import type { Settings } from '../../web/engine/settings/options';
import { materialOf } from '../../web/engine/body/material';
import { BodyRun } from '../../web/engine/stages/body_run';
import { bodyOf } from './support/bodies';
import { loadTestCore } from './support/core';
import { optimized as optimizedBy, runOfMesh } from './support/runs';
import { cube, grid, torus } from './support/shapes';

const search = (errorAt: (faces: number) => number, fewest = 4, most = 10_000, limit = 1) =>
  fewestFacesWithin((faces) => ({ faces, error: errorAt(faces) }), { fewest, most, limit });

describe('the search for the fewest faces', () => {
  it('ends within 2 % of the crossing of errors and limit', () => {
    for (const crossing of [7, 123, 4567, 9990]) {
      const { best, finding } = search((faces) => crossing / faces);
      expect(best.faces).toBeGreaterThanOrEqual(crossing);
      expect(best.faces).toBeLessThanOrEqual(Math.max(1.02 * crossing, crossing + 1));
      expect(finding).toMatchObject({ limit: 1, error: best.error, isBinding: true });
      expect(finding.tried.length).toBeLessThan(20);
    }
  });

  it('takes the fewest faces allowed after one solve if they are within the limit', () => {
    const { best, finding } = search(() => 0.5, 300);
    expect(best.faces).toBe(300);
    expect(finding).toEqual({ limit: 1, error: 0.5, isBinding: false, tried: [{ faces: 300, error: 0.5 }] });
  });

  it('takes the whole mesh if nothing smaller is within the limit, and tries that too', () => {
    const { best, finding } = search((faces) => (faces === 10_000 ? 0 : 5));
    expect([best.faces, finding.error]).toEqual([10_000, 0]);
    expect(finding.tried.at(-1)).toEqual({ faces: 10_000, error: 0 });
  });

  it('finds a lower range within the limit below one outside of it', () => {
    // Fails from 900 to 1,000, succeeds from 800 to 900, fails below.
    const { best } = search((faces) => (faces < 800 || (faces > 900 && faces < 1000) ? 2 : 0.5));
    expect(best.faces).toBeLessThanOrEqual(816);
  });

  it('returns a count that was tried and is within the limit, however errors jump', () => {
    for (let seed = 1; seed <= 50; ++seed) {
      const errorAt = (faces: number) =>
        faces >= 10_000 ? 0 : (Math.abs(Math.sin(seed * faces)) * 2000) / faces;
      const { best, finding } = search(errorAt);
      expect(errorAt(best.faces)).toBeLessThanOrEqual(1);
      expect(finding.tried).toContainEqual({ faces: best.faces, error: best.error });
      expect(finding.tried.length).toBeLessThanOrEqual(60);
    }
  });

  it('works on histories with few face counts', () => {
    const counts = [4, 50, 60, 1000, 10_000];
    const evaluate = (faces: number) => {
      const reached = counts.filter((count) => count <= faces).at(-1) ?? counts[0];
      return { faces: reached, error: 55 / reached };
    };
    expect(fewestFacesWithin(evaluate, { fewest: 1, most: 10_000, limit: 1 }).best.faces).toBe(60);
  });
});

describe('a largest frequency error', () => {
  let core: Core;
  beforeAll(async () => {
    core = await loadTestCore(1);
  });

  const optimize = (mesh: ReturnType<typeof torus>, change: Partial<Settings>, targetFaces = 1) => {
    const settings = { ...defaultSettings(), ...change };
    const run = runOfMesh(core, mesh);
    const optimized = optimizedBy(run, settings, targetFaces);
    const { prepared } = optimized;
    const errorOf = (faces: number) => {
      const other = optimizedBy(run, { ...settings, maxFrequencyError: 0 }, faces);
      const options = { modeCount: 6, ...materialOf(prepared, settings) };
      return core.compareFidelity(prepared.mesh, other.result.mesh, options).frequencyErrorMax;
    };
    const faces = optimized.result.mesh.triangles.length / 3;
    return { faces, errorOf, frequency: optimized.frequency!, optimized };
  };

  it.each([
    ['with the fit to the modes', torus(16, 8), { maxFrequencyError: 8, fit: 'modal' as const }],
    ['without the fit', torus(), { maxFrequencyError: 4, fit: 'off' as const }],
    ['of a sheet', grid(10, 14), { maxFrequencyError: 3, method: 'qem' as const }],
  ])('holds %s, and fewer faces break it', (_, mesh, change) => {
    const { faces, errorOf, frequency } = optimize(mesh, change);
    expect(frequency.isBinding).toBe(true);
    expect(errorOf(faces)).toBeCloseTo(frequency.error, 6);
    expect(frequency.error).toBeLessThanOrEqual(change.maxFrequencyError);
    // Errors jump from count to count, the more so with a fit: a count just below was tried, and is beyond the limit.
    const below = frequency.tried.filter((tried) => tried.faces < faces && tried.faces >= 0.97 * faces);
    expect(below.length).toBeGreaterThan(0);
    for (const tried of below) expect(errorOf(tried.faces)).toBeGreaterThan(change.maxFrequencyError);
  });

  it('accepts a requested number of faces that is within it', () => {
    const { faces, frequency } = optimize(torus(), { maxFrequencyError: 50, fit: 'off' }, 400);
    expect(faces).toBeLessThanOrEqual(400);
    expect(faces).toBeGreaterThan(396);
    expect(frequency).toMatchObject({ isBinding: false });
    expect(frequency.tried).toHaveLength(1);
  });

  it('reports every number of faces that is tried', () => {
    const settings = { ...defaultSettings('qem'), maxFrequencyError: 5 };
    const asked: number[] = [];
    const onTry = (faces: number) => asked.push(faces);
    const run = new BodyRun({ core, body: bodyOf(torus()), document: null, onTry });
    const { frequency } = optimizedBy(run, settings, 1);
    expect(asked).toHaveLength(frequency!.tried.length);
  });

  it('keeps a mesh that cannot be reduced', () => {
    const { faces, frequency } = optimize(cube(), { maxFrequencyError: 0.01, method: 'qem' });
    expect(faces).toBe(12);
    expect(frequency.error).toBeLessThan(0.01);
  });
});
