/** Compares the reference values of docs/validation.md with published ones, and tests some cheap cases of that page. */

import { beforeAll, describe, expect, it } from 'vitest';
import type { Core } from '../../web/engine/core/core';
import { eulerBending, stretch, timoshenkoBending, twist } from '../../scripts/validation/analytic/bar';
import { generalisedEigenvalues } from '../../scripts/validation/analytic/eigenvalues';
import { gaussLegendre, integrate } from '../../scripts/validation/analytic/legendre';
import { plateFrequencies, supportedPlateFrequencies } from '../../scripts/validation/analytic/plate';
import { signChanges } from '../../scripts/validation/analytic/roots';
import { breathing, spheroidal, torsional } from '../../scripts/validation/analytic/sphere';
import {
  rayleighTube,
  ringInPlane,
  ringOutOfPlane,
  tubeFrequencies,
} from '../../scripts/validation/analytic/tube';
import { barRun } from '../../scripts/validation/cases/bars';
import { errorPercent } from '../../scripts/validation/cases/case';
import { plateRun } from '../../scripts/validation/cases/plates';
import { sphereRun } from '../../scripts/validation/cases/sphere';
import { bandRun } from '../../scripts/validation/cases/tubes';
import { box, plate, sphere, squareRing, tube } from '../../scripts/validation/meshes';
import type { MeshKind } from '../../scripts/validation/meshes';
import { loadTestCore } from './support/core';

/** Expects every value within `percent` of its reference. */
function expectNear(values: number[], references: number[], percent: number): void {
  expect(values.length).toBe(references.length);
  values.forEach((value, k) => expect(Math.abs(errorPercent(value, references[k]))).toBeLessThan(percent));
}

describe('reference values', () => {
  it('eigenvalues of K x = lambda M x agree with a pencil solved by hand', () => {
    // det [[2 - l, -1], [-1, 3 - 2 l]] = 2 l^2 - 7 l + 5
    const stiffness = { size: 2, values: Float64Array.of(2, -1, -1, 3) };
    const mass = { size: 2, values: Float64Array.of(1, 0, 0, 2) };
    expectNear(generalisedEigenvalues(stiffness, mass), [1, 2.5], 1e-10);
  });

  it("Gauss's quadrature is exact for polynomials of its degree", () => {
    const quadrature = gaussLegendre(4);
    const cube = quadrature.points.map((x) => x ** 3);
    expect(integrate(quadrature, cube, cube)).toBeCloseTo(2 / 7, 13);
  });

  it('roots are found in order, at most as many as requested', () => {
    expectNear(
      signChanges(Math.sin, 1, 20, 500, 3),
      [1, 2, 3].map((k) => k * Math.PI),
      1e-8,
    );
  });

  it("a free plate has the table's frequencies", () => {
    expectNear(plateFrequencies('free', 0.3, 6), [13.468, 19.596, 24.27, 34.801, 34.801, 61.093], 0.01);
  });

  it("a clamped plate has the table's frequencies", () => {
    expectNear(plateFrequencies('clamped', 0.3, 6), [35.985, 73.39, 73.39, 108.22, 131.58, 132.2], 0.01);
  });

  it('a plate clamped along one side lies just below the upper bounds of Leissa 1973', () => {
    const bounds = [3.4917, 8.5246, 21.429, 27.331, 31.111, 54.443];
    plateFrequencies('cantilever', 0.3, 6).forEach((value, k) => {
      expect(value).toBeLessThan(bounds[k]);
      expect(value).toBeGreaterThan(0.99 * bounds[k]);
    });
  });

  it('a simply supported plate has 2 pi^2 once and 5 pi^2 twice as its lowest values', () => {
    expectNear(
      supportedPlateFrequencies(3),
      [2, 5, 5].map((k) => k * Math.PI ** 2),
      1e-10,
    );
  });

  it("Timoshenko's beam approaches Euler's as it becomes slender, free and clamped", () => {
    for (const isHeld of [true, false]) {
      const slender = { side: 1, length: 100, poisson: 0.3 };
      expectNear(timoshenkoBending(slender, isHeld, 1), [eulerBending(slender, isHeld)], 0.3);
    }
  });

  it("the paper's bar bends at 0.547 (Timoshenko), not 0.718 (Euler), and twists at 0.596", () => {
    const bar = { side: 1, length: 3, poisson: 0.3 };
    expectNear([...timoshenkoBending(bar, false, 1), eulerBending(bar, false)], [0.5477, 0.7176], 0.02);
    expectNear([twist(bar, 1), stretch(bar, 1)], [0.5965, Math.PI / 3], 0.02);
  });

  it("a sphere has Lamb's roots", () => {
    // Lamb 1882 and Love 1944, 194-196: in units of pi, for Poisson's ratio 1/4 where it matters.
    const inPi = (values: number[]) => values.map((value) => value / Math.PI);
    expectNear(inPi([...torsional(2, 1), ...torsional(1, 1)]), [0.7961, 1.8346], 0.01);
    expectNear(inPi(breathing(0.25, 2)), [0.816 * Math.sqrt(3), 1.9285 * Math.sqrt(3)], 0.02);
    expectNear(inPi(spheroidal(2, 0.25, 2)), [0.84, 1.549], 0.05);
  });

  it("a long tube bends as in Rayleigh's formula, a narrow band as a thin ring", () => {
    const long = { radius: 1, length: 20, thickness: 0.01, poisson: 0.3 };
    expectNear(tubeFrequencies(long, 2, 1), [rayleighTube(long, 2)], 0.1);
    const narrow = { radius: 1, length: 0.02, thickness: 0.01, poisson: 0.3 };
    expectNear(tubeFrequencies(narrow, 2, 1), [ringInPlane(1, 0.01 ** 2 / 12, 1, 2)], 0.1);
  });

  it('a ring that cannot twist is no softer out of plane than in plane', () => {
    const [inside, outside] = [ringInPlane(1, 1, 1, 2), ringOutOfPlane(1, 1, 1e9, 2)];
    expect(outside).toBeGreaterThan(inside);
    expect(ringOutOfPlane(1, 1, 0.5, 2)).toBeLessThan(outside);
  });
});

describe('meshes of the validation', () => {
  const kinds: MeshKind[] = ['regular', 'irregular', 'graded'];
  let core: Core;
  beforeAll(async () => {
    core = await loadTestCore(1);
  });

  it.each(kinds)('%s bodies are closed and consistently oriented, and sheets have their borders', (kind) => {
    const closed = [box([1, 1, 3], [3, 3, 9], kind), squareRing(24, 2, kind, [1, 0.2]), sphere(4, kind)];
    for (const mesh of closed)
      expect(core.inspect(mesh)).toMatchObject({
        components: 1,
        boundaryLoops: 0,
        nonManifoldEdges: 0,
        orientationClashes: 0,
      });
    expect(core.inspect(plate(5, kind, 'all')).boundaryLoops).toBe(1);
    expect(core.inspect(tube(12, 4, kind, [1, 2])).boundaryLoops).toBe(2);
  });
});

describe('computed against analytic values', () => {
  let core: Core;
  beforeAll(async () => {
    core = await loadTestCore(2);
  });

  it.each(['regular', 'irregular', 'graded'] as const)(
    'a free plate of 32 x 32 %s cells is within 4 %, and always too soft',
    (kind) => {
      const { computed } = plateRun(core, 'free', 32, kind);
      const references = plateFrequencies('free', 0.3, 6);
      expectNear(computed, references, 4);
      computed.forEach((value, k) => expect(value).toBeLessThan(references[k]));
    },
  );

  it('pinned faces clamp, and a pinned line is a hinge', () => {
    expectNear(plateRun(core, 'clamped', 32, 'regular').computed.slice(0, 3), [35.985, 73.394, 73.394], 2.5);
    const hinged = plateRun(core, 'supported', 32, 'regular').computed.slice(0, 3);
    expectNear(hinged, supportedPlateFrequencies(3), 1);
  });

  it('a thin band bends as a ring within 0.5 %', () => {
    const { computed } = bandRun(core, 2, 'irregular');
    const band = { radius: 1, length: 0.1, thickness: 0.01, poisson: 0.3 };
    expectNear(
      [computed[0], computed[2]],
      [2, 3].map((n) => tubeFrequencies(band, n, 1)[0]),
      0.5,
    );
  });

  it('a solid bar bends, twists and stretches as in beam theories, whatever its triangles', () => {
    const bar = { side: 1, length: 3, poisson: 0.3 };
    const references = [...timoshenkoBending(bar, false, 2), twist(bar, 1), stretch(bar, 1)];
    for (const kind of ['regular', 'irregular', 'graded'] as const)
      expectNear(barRun(core, false, 4, kind).computed, references, 1.5);
  });

  it('a solid beam is clamped by its end, however few vertices that has', () => {
    const bar = { side: 1, length: 6, poisson: 0.3 };
    const references = [...timoshenkoBending(bar, true, 2), twist(bar, 0.5), stretch(bar, 0.5)];
    expectNear(barRun(core, true, 2, 'irregular').computed, references, 1.5);
  });

  it("a solid sphere has Lamb's frequencies within 2 %, including the breathing mode", () => {
    const references = [
      ...torsional(2, 1),
      ...torsional(3, 1),
      ...[2, 1, 3].flatMap((l) => spheroidal(l, 0.25, 1)),
      ...breathing(0.25, 1),
    ];
    expectNear(sphereRun(core, 12, 'irregular').computed, references, 2);
  });
});
