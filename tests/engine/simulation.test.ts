import { beforeAll, describe, expect, it } from 'vitest';
import type { Collider, Core, SimulationOptions, TriangleMesh } from '../../web/engine/core/core';
import { SCENARIO_NAMES } from '../../web/engine/core/scenarios';
import type { ScenarioName } from '../../web/engine/core/scenarios';
import { defaultSettings, OPTIONS } from '../../web/engine/settings/options';
import { defaultModelOf } from '../../web/engine/motion/default_model';
import { SimulatedBodies } from '../../web/engine/motion/simulated_bodies';
import {
  calibrationOf,
  simulationOptions,
  untouchedSolversOf,
  STEP_SECONDS,
} from '../../web/engine/motion/simulation';
import { materialOf } from '../../web/engine/body/material';
import { simulationReport } from '../../web/engine/report/motion_report';
import { profileOf, SOLVER_NAMES } from '../../web/engine/solvers/profiles';
import { prepareBody } from '../../web/engine/stages/prepared';
import { bodyOf, together } from './support/bodies';
import { loadTestCore } from './support/core';
import { failureOf } from './support/files';
import { box, grid } from './support/shapes';

let core: Core;
let single: Core;
beforeAll(async () => {
  core = await loadTestCore(2);
  single = await loadTestCore(1);
});

const settings = { ...defaultSettings(), substeps: 10 };
const sheet = grid(12, 12);
const coarse = grid(6, 6);
const optionsFor = (mesh: TriangleMesh, scenario: ScenarioName): SimulationOptions =>
  simulationOptions(prepareBody(core, bodyOf(mesh), settings), { ...settings, scenario }, null);

const modesCallOf = (mesh: TriangleMesh): Parameters<Core['findModes']> => {
  const prepared = prepareBody(core, bodyOf(mesh), settings);
  const request = { model: 'auto' as const, modeCount: 3, direction: 2, pinned: new Uint32Array() };
  return [prepared.mesh, { ...request, exact: false, ...materialOf(prepared, settings) }];
};

function run(body: SimulatedBodies, steps: number): void {
  for (let i = 0; i < steps; i++) body.step();
}

describe('a running simulation', () => {
  it('starts in the shape of the mesh and moves with every step', () => {
    const simulation = new SimulatedBodies(core, sheet, coarse, optionsFor(sheet, 'hang'));
    expect(simulation.positions(0)).toEqual(sheet.positions);
    expect(simulation.positions(1)).toEqual(coarse.positions);
    run(simulation, 6);
    expect(simulation.time).toBeCloseTo(6 * STEP_SECONDS, 12);
    expect(simulation.positions(0)).not.toEqual(sheet.positions);
    simulation.end();
  });

  it('lays a sheet flat above the ball to drape it', () => {
    const simulation = new SimulatedBodies(core, sheet, coarse, optionsFor(sheet, 'drape'));
    const { ground, colliders } = simulation.collisionScene;
    for (const body of [0, 1]) {
      const heights = simulation.positions(body).filter((_, i) => i % 3 === 1);
      expect(Math.max(...heights) - Math.min(...heights)).toBeLessThan(1e-6);
      expect(heights[0]).toBeGreaterThan(colliders[0].from[1] + colliders[0].radius);
    }
    expect(ground).toBeCloseTo(colliders[0].from[1] - colliders[0].radius, 12);
    simulation.end();
  });

  it.each(SCENARIO_NAMES)('gives the same bits with one thread and with two: %s', (scenario) => {
    const mesh = box(2, 2, 6);
    const all = [core, single].map((one) => {
      const simulation = new SimulatedBodies(one, mesh, null, optionsFor(mesh, scenario));
      run(simulation, 10);
      const positions = simulation.positions(0);
      simulation.end();
      return positions;
    });
    expect(all[0].every(Number.isFinite)).toBe(true);
    expect(all[0]).toEqual(all[1]);
  });

  it('moves a dragged point to its target and lets it leave once released', () => {
    const simulation = new SimulatedBodies(core, sheet, null, optionsFor(sheet, 'sway'));
    const corner = sheet.triangles.indexOf(sheet.positions.length / 3 - 1);
    const barycentric = [0, 1, 2].map((c) => Number(c === corner % 3)) as [number, number, number];
    const last = () => Array.from(simulation.positions(0).slice(-3));
    const target = last().map((value) => value + 0.3) as [number, number, number];
    simulation.drag(0, { triangle: Math.floor(corner / 3), barycentric }, target);
    run(simulation, 60);
    last().forEach((value, c) => expect(value).toBeCloseTo(target[c], 3));
    simulation.release(0);
    run(simulation, 10);
    expect(last().some((value, c) => Math.abs(value - target[c]) > 0.01)).toBe(true);
    simulation.end();
  });

  it('collides with the given scene and with that of the scenario', () => {
    const added = { ground: -3, colliders: [{ from: [0, 1, 2], to: [3, 4, 5], radius: 0.5 }] as Collider[] };
    const touched = (scenario: ScenarioName, given: object) => {
      const simulation = new SimulatedBodies(core, sheet, coarse, {
        ...optionsFor(sheet, scenario),
        ...given,
      });
      simulation.end();
      return simulation.collisionScene;
    };
    expect(touched('twist', {})).toEqual({ ground: null, colliders: [] });
    expect(touched('twist', added)).toEqual(added);
    expect(touched('drop', {}).ground).toBeLessThan(0);
    expect(touched('drape', {}).ground).toBeLessThan(0);
    const { colliders } = touched('drape', added);
    expect(colliders).toHaveLength(2);
    expect(colliders[1].from).toEqual(colliders[1].to);
  });

  it('rests on a given capsule', () => {
    const collider: Collider = { from: [0.5, -0.3, -9], to: [0.5, -0.3, 9], radius: 0.2 };
    const options = { ...optionsFor(sheet, 'drop'), colliders: [collider] };
    const simulation = new SimulatedBodies(core, sheet, coarse, options);
    run(simulation, 40);
    for (const body of [0, 1]) {
      const positions = simulation.positions(body);
      for (let v = 0; v < positions.length; v += 3)
        expect(Math.hypot(positions[v] - 0.5, positions[v + 1] + 0.3)).toBeGreaterThan(0.199);
    }
    simulation.end();
  });

  it('is changed by a calibration for the optimized body, not for the original', () => {
    const positionsOf = (calibration: number) => {
      const simulation = new SimulatedBodies(core, sheet, coarse, {
        ...optionsFor(sheet, 'hang'),
        calibration,
      });
      run(simulation, 20);
      const found = [0, 1].map((body) => simulation.positions(body));
      simulation.end();
      return found;
    };
    const [soft, stiff] = [positionsOf(1), positionsOf(4)];
    expect(stiff[0]).toEqual(soft[0]);
    expect(stiff[1]).not.toEqual(soft[1]);
  });

  it('refuses a step once it has ended', async () => {
    const simulation = new SimulatedBodies(core, sheet, null, optionsFor(sheet, 'drop'));
    simulation.end();
    expect(await failureOf(() => simulation.step())).toBe('The simulation has ended: start it again.');
  });

  it('refuses unusable options and pins with a sentence', async () => {
    const options = { ...optionsFor(sheet, 'twist'), substeps: 0 };
    for (const substeps of [0, OPTIONS.substeps.max + 1])
      expect(await failureOf(() => new SimulatedBodies(core, sheet, null, { ...options, substeps }))).toBe(
        'A step has 1 to 10,000 substeps.',
      );
    const pinned = Uint32Array.of(99999);
    expect(
      await failureOf(() => new SimulatedBodies(core, sheet, null, { ...options, substeps: 5, pinned })),
    ).toBe('A pin names a vertex that the mesh does not have.');
  });
});

describe('the scenarios of TypeScript', () => {
  it('equal those of the core, in the same order', async () => {
    const options = { ...optionsFor(sheet, 'twist'), scenario: 'fall' as ScenarioName };
    expect(await failureOf(() => core.scenarioCollisionScene(sheet, options))).toBe(
      `There is no scenario "fall": take one of ${SCENARIO_NAMES.join(', ')}.`,
    );
  });
});

describe('a calibration', () => {
  it('equals that of compareFidelity, and is 1 for a body and itself', () => {
    const original = prepareBody(core, bodyOf(sheet), settings);
    const options = { modeCount: 10, ...materialOf(original, settings) };
    const factor = calibrationOf(core, original, coarse, settings);
    expect(factor).toBe(core.compareFidelity(original.mesh, coarse, options).calibrationFactor);
    expect(factor).not.toBeCloseTo(1, 3);
    expect(calibrationOf(core, original, original.mesh, settings)).toBeCloseTo(1, 9);
  });
});

describe('a comparison of motions', () => {
  it('finds no deviation of a body from itself', () => {
    const options = { ...optionsFor(sheet, 'sway'), seconds: 0.2, records: false, binding: null };
    const motion = core.compareMotion(sheet, sheet, options);
    expect([motion.deviationMean, motion.deviationMax]).toEqual([0, 0]);
    expect(motion.noiseFloor).toBeGreaterThan(0);
    expect(motion.original.positions).toHaveLength(0);
  });

  it('has the keys of the report', () => {
    const options = { ...optionsFor(sheet, 'twist'), seconds: 0.2, records: true, binding: null };
    const motion = core.compareMotion(sheet, coarse, options);
    expect(motion.original.positions).toHaveLength(12 * sheet.positions.length);
    const report = simulationReport([motion], { material: options.material, scenario: options.scenario });
    expect(report.original.edges).toBe(12 * 12 * 3 + 24);
    expect(report.original.constraints).toBe(2 * 288);
    expect(report.edgeRatio).toBeCloseTo(456 / 120, 12);
    expect(report.speedup).toBeGreaterThan(1);
    expect(report.original.nanosecondsPerConstraint).toBeGreaterThan(0);
    expect(report.deviation!.mean).toBeLessThan(report.deviation!.max);
    expect(report.deviation!.substeps).toBe(motion.substepDeviation);
    expect(report.deviation!.converged).toBe(motion.isConverged);
    expect(report.substeps).toBe(options.substeps);
  });

  it('tells whether the original has converged, and doubles the substeps until it has', () => {
    const options = { ...optionsFor(sheet, 'sway'), seconds: 0.2, records: false, binding: null };
    const few = core.compareMotion(sheet, coarse, { ...options, substeps: 1 });
    expect(few.isConverged).toBe(false);
    expect(few.substepDeviation).toBeGreaterThan(0.25 * few.deviationMean);
    const enough = core.compareMotion(sheet, coarse, { ...options, substeps: 1, doublesSubsteps: true });
    expect(enough.isConverged).toBe(true);
    expect(Math.log2(enough.substeps) % 1).toBe(0);
    expect(enough.substepDeviation).toBeLessThanOrEqual(0.25 * enough.deviationMean);
  });
});

describe('the solver of an engine', () => {
  const arch = (mesh: TriangleMesh): TriangleMesh => ({
    ...mesh,
    positions: mesh.positions.map((value, i) =>
      i % 3 === 2 ? Math.sin(3 * mesh.positions[i - 2]) / 4 : value,
    ),
  });
  const [original, result] = [arch(sheet), arch(coarse)];
  const inSolver = (solver: (typeof SOLVER_NAMES)[number], massRule: 'auto' | 'vertex' = 'auto') => {
    const size = prepareBody(core, bodyOf(original), settings);
    return untouchedSolversOf(size, { original, result }, { ...settings, solver, massRule })!;
  };

  it('is none where none is asked for', () => {
    const size = prepareBody(core, bodyOf(original), settings);
    expect(untouchedSolversOf(size, { original, result }, settings)).toBeNull();
  });

  it.each(SOLVER_NAMES)('moves original and result: %s', (name) => {
    const pair = inSolver(name);
    const { stretch, bend } = profileOf(name);
    expect(pair.original.model).toMatchObject({ stretch, bend });
    const options = { ...optionsFor(original, 'hang'), seconds: 0.1, records: true, binding: null };
    const motion = core.compareMotion(original, result, {
      ...options,
      solver: pair.original,
      otherSolver: pair.result,
    });
    expect(motion.original.positions.every(Number.isFinite)).toBe(true);
    expect(motion.original.positions).not.toEqual(original.positions);
    const [edges, bends, triangles] = [456, 408, 288];
    const constraints =
      (stretch === 'membrane' ? triangles : edges) + (bend === 'morley' ? triangles : bends);
    expect(motion.original).toMatchObject({ constraints, edges });
  });

  it('gives the optimized body its own constants, masses and factors', () => {
    const pair = inSolver('springs');
    const options = { ...optionsFor(original, 'sway'), seconds: 0.1, records: false, binding: null };
    const deviationOf = (otherSolver: typeof pair.result): number =>
      core.compareMotion(original, original, { ...options, solver: pair.original, otherSolver })
        .deviationMean;
    const { model, constants } = pair.original;
    expect(deviationOf(pair.original)).toBe(0);
    const soft = { ...constants, stretch: constants.stretch / 2, bend: constants.bend / 2 };
    expect(deviationOf({ model, constants: soft })).toBeGreaterThan(0.01);
    const [stretchFactors, bendFactors] = [new Float64Array(456).fill(2), new Float64Array(408).fill(2)];
    expect(deviationOf({ model, constants: soft, stretchFactors, bendFactors })).toBe(0);
    const heavy = new Float64Array(169).fill(1);
    expect(deviationOf({ model, constants, masses: heavy })).toBeGreaterThan(0.01);
  });

  it('can give every vertex the same mass', () => {
    const byArea = inSolver('springs');
    const byVertex = inSolver('springs', 'vertex');
    expect(byVertex.original.model.mass).toBe('vertex');
    expect({ ...byVertex.original.model, mass: 'area' }).toEqual(byArea.original.model);
  });

  it('refuses factors that are not of the mesh', async () => {
    const { model, constants } = inSolver('springs').original;
    const solver = { model, constants, stretchFactors: new Float64Array(3).fill(1) };
    expect(
      await failureOf(() => new SimulatedBodies(core, sheet, null, { ...optionsFor(sheet, 'hang'), solver })),
    ).toBe(
      'The factors on stretching are 3, but the mesh needs 456: take the settings that were written for this mesh.',
    );
  });
});

describe('the default model of a body', () => {
  const closed = box(2, 2, 2);
  const open = grid(3, 3);
  const modelOf = (mesh: TriangleMesh) =>
    defaultModelOf(prepareBody(core, bodyOf(mesh), settings).inspection);

  it.each([
    ['a closed body', closed, 'solid'],
    ['a sheet', open, 'shell'],
    ['two closed parts', together(closed, closed), 'solid'],
    ['two sheets', together(open, open), 'shell'],
    ['a closed part beside a sheet', together(closed, open), 'both'],
  ] as const)('is that of its parts: %s', (_, mesh, expected) => {
    expect(modelOf(mesh)).toBe(expected);
    // The core divides the parts in the same way.
    const { components } = core.findModes(...modesCallOf(mesh));
    const models = new Set(components.map(({ model }) => model));
    expect(models.size > 1 ? 'both' : [...models][0]).toBe(expected);
  });

  it('counts a part with an edge of three faces as open', () => {
    const { positions, triangles } = closed;
    const fin = { positions, triangles: Uint32Array.from([...triangles, 0, 1, positions.length / 3 - 1]) };
    expect(modelOf(together(fin, closed))).toBe('both');
  });

  it('counts a closed part without volume as a shell, as the simulation does', () => {
    const { positions } = closed;
    const flat = { ...closed, positions: positions.map((x, i) => (i % 3 === 2 ? 0 : x)) };
    expect(modelOf(together(flat, closed))).toBe('both');
  });
});
