import { beforeAll, describe, expect, it } from 'vitest';
import type { Core, TriangleMesh } from '../../web/engine/core/core';
import { optimizeBody } from '../../web/engine/stages/optimize';
import { defaultSettings } from '../../web/engine/settings/options';
import type { Settings } from '../../web/engine/settings/options';
import { prepareBody } from '../../web/engine/stages/pipeline';
import { bodyOf } from './support/bodies';
import { loadTestCore } from './support/core';
import { torus } from './support/shapes';

let core: Core;
beforeAll(async () => {
  core = await loadTestCore(1);
});

function reduced(mesh: TriangleMesh, targetFaces: number, change: Partial<Settings>) {
  const settings = { ...defaultSettings(), modeCount: 6, ...change };
  const prepared = prepareBody(core, bodyOf(mesh), settings);
  const { fitted, measured } = optimizeBody(core, prepared, settings, { targetFaces });
  return { fitted, ...measured };
}

/** Each limit is one that the fit would break if it did not know of it. */
describe('a fit with limits', () => {
  it('keeps the largest deviation', () => {
    const free = reduced(torus(), 200, {});
    const maxDeviation = 0.8 * free.distance.hausdorff;
    const held = reduced(torus(), 200, { maxDeviation });
    expect(held.fitted.unfitted).toBe('');
    expect(held.distance.hausdorff).toBeLessThanOrEqual(maxDeviation);
    expect(held.fitted.errorAfter[0]).toBeLessThan(0.8 * held.fitted.errorBefore[0]);
  });

  it('keeps the smallest angle', () => {
    const minAngle = 25;
    expect(reduced(torus(), 200, {}).quality.minAngle).toBeLessThan(minAngle);
    const held = reduced(torus(), 200, { minAngle });
    expect(held.fitted.unfitted).toBe('');
    expect(held.quality.minAngle).toBeGreaterThanOrEqual(minAngle);
    expect(held.fitted.errorAfter[0]).toBeLessThan(0.8 * held.fitted.errorBefore[0]);
  });
});
