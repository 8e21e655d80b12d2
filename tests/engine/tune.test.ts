import { describe, expect, it } from 'vitest';
import type { Core, TuneOptions } from '../../web/engine/core/core';
import { loadTestCore } from './support/core';
import { grid, torus } from './support/shapes';

const core: Core = await loadTestCore(1);
const original = core.weld(torus(28, 16).positions, torus(28, 16).triangles, { tolerance: 0 }).mesh;
const coarse = core.weld(torus(20, 10).positions, torus(20, 10).triangles, { tolerance: 0 }).mesh;
const vertexCount = coarse.positions.length / 3;
const edgeCount = coarse.triangles.length / 2; // of a closed surface

const constants = { stretch: 400, secondStretch: 340, bend: 0.2, poisson: 0.3, surfaceDensity: 20, unit: 1 };
const options: TuneOptions = {
  model: { stretch: 'membrane', bend: 'hinge-length', mass: 'area' },
  original: constants,
  result: constants,
  pinnedOriginal: new Uint32Array(),
  pinnedResult: new Uint32Array(),
  tune: 'global',
  tunedMass: 'area',
  runsTrial: false,
};

describe('tuning through the core', () => {
  it('reduces frequency errors with two factors', () => {
    const tuned = core.tuneSolver(original, coarse, options);
    expect(tuned.frequencies.errorTuned).toBeLessThan(tuned.frequencies.errorUntouched);
    expect(tuned.motion).toBeNull();
    expect(tuned.stretchFactors).toHaveLength(0);
    expect(tuned.stretchField).toHaveLength(0);
    expect(tuned.masses).toHaveLength(vertexCount);
    expect(tuned.stretchVertices).toEqual(coarse.triangles);
    expect(tuned.bendVertices).toHaveLength(4 * edgeCount);
  });

  it('gives factors per vertex and per constraint if requested', () => {
    const fields = core.tuneSolver(original, coarse, { ...options, tune: 'vertex' });
    expect(fields.bendField).toHaveLength(vertexCount);
    const springs = { stretch: 'edge-springs', bend: 'cross-springs', mass: 'vertex' } as const;
    const factors = core.tuneSolver(original, coarse, { ...options, model: springs, tune: 'constraint' });
    expect(factors.stretchFactors).toHaveLength(edgeCount);
    expect(factors.bendVertices).toHaveLength(2 * factors.bendFactors.length);
  });

  it('reports the motion deviation both untouched and tuned', () => {
    const { motion } = core.tuneSolver(coarse, coarse, {
      ...options,
      result: { ...constants, bend: 0.05 },
      runsTrial: true,
    });
    expect(motion?.scene).toBe('sway');
    expect(motion?.kept).toBe('tuned');
    expect(motion?.tuned).toBeLessThan(motion?.untouched ?? 0);
  });

  it('has no frequencies for a flat sheet of springs', () => {
    const sheet = (cells: number) =>
      core.weld(grid(cells, cells).positions, grid(cells, cells).triangles, { tolerance: 0 }).mesh;
    const model = { stretch: 'edge-springs', bend: 'cross-springs', mass: 'area' } as const;
    const tuned = core.tuneSolver(sheet(12), sheet(6), { ...options, model });
    expect(tuned.bendFactor).toBe(1);
    expect(tuned.frequencies.errorTuned).toBeNaN();
  });

  it('refuses invalid input with one sentence', () => {
    expect(() => core.tuneSolver(coarse, original, options)).toThrow('give the finer mesh as the original.');
    const model = { ...options.model, bend: 'rubber' } as unknown as TuneOptions['model'];
    expect(() => core.tuneSolver(original, coarse, { ...options, model })).toThrow('bending element');
  });
});
