/** What a user types into an engine amounts to the constants of a solver, and back, whatever the units of the file. */

import { describe, expect, it } from 'vitest';
import type { SolverConstants, TriangleMesh } from '../../web/engine/core/core';
import { engineText, engineValues, parseEngine } from '../../web/engine/settings/engine_text';
import { checkSettings, defaultSettings, OPTIONS } from '../../web/engine/settings/options';
import type { Settings } from '../../web/engine/settings/options';
import { meshFacts } from '../../web/engine/solvers/mesh_facts';
import { hingeOfPlate, plateConstants, plateOf, springOfPlate } from '../../web/engine/solvers/plate';
import { completeValues, nativeValues, totalMass } from '../../web/engine/solvers/profile';
import type { NativeValues, SolverState } from '../../web/engine/solvers/profile';
import { profileOf, SOLVER_NAMES } from '../../web/engine/solvers/profiles';
import type { SolverName } from '../../web/engine/solvers/profiles';
import { substepsNeeded } from '../../web/engine/solvers/substeps';
import { statesOf, tunedConstants } from '../../web/engine/solvers/tuned_body';
import { grid, torus } from './support/shapes';

const MATERIAL = { young: 2e5, poisson: 0.3, density: 900, thickness: 0.01, bendRatio: 0.05 };
const [fine, coarse] = [meshFacts(torus(40, 24), 1), meshFacts(torus(16, 10), 1)];

function stateOf(name: SolverName, facts = fine, given: NativeValues = {}): SolverState {
  const profile = profileOf(name);
  const values = completeValues(profile, { material: MATERIAL, original: fine, given });
  return { values, facts, constants: profile.constants(values, facts) };
}

const expectClose = (found: object, expected: object) =>
  Object.entries(expected).forEach(([key, value]) => {
    const actual = (found as Record<string, number>)[key];
    expect(Math.abs(actual - value), key).toBeLessThanOrEqual(1e-9 * Math.abs(value));
  });

function failureOf(run: () => unknown): string {
  try {
    run();
  } catch (error) {
    return (error as Error).message;
  }
  return '';
}

describe('facts of a mesh', () => {
  const square: TriangleMesh = {
    positions: Float32Array.from([0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0]),
    triangles: Uint32Array.from([0, 1, 2, 0, 2, 3]),
  };

  it('count each edge once, in metres', () => {
    const facts = meshFacts(square, 0.1);
    expectClose(facts, { area: 0.04, meanEdge: (4 * 0.2 + 0.2 * Math.SQRT2) / 5 });
    expect(facts).toMatchObject({ vertices: 4, faces: 2, unit: 0.1 });
  });

  it('do not depend on the unit of the file', () => {
    const scaled = torus(16, 10);
    scaled.positions.forEach((value, i) => (scaled.positions[i] = 128 * value));
    const { unit, ...facts } = meshFacts(scaled, 1 / 128);
    expect(unit).toBe(1 / 128);
    expectClose(facts, { area: coarse.area, meanEdge: coarse.meanEdge });
  });
});

describe.each(SOLVER_NAMES)('the profile %s', (name) => {
  const profile = profileOf(name);

  it('has defaults for all of its parameters, within their ranges', () => {
    const { values } = stateOf(name);
    expect(Object.keys(values).sort()).toEqual(profile.parameters.map((parameter) => parameter.name).sort());
    for (const { name: key, min, max } of profile.parameters) {
      expect(values[key], key).toBeGreaterThanOrEqual(min);
      expect(values[key], key).toBeLessThanOrEqual(max);
    }
  });

  it('turns parameters into constants and back', () => {
    const state = stateOf(name);
    expectClose(nativeValues(profile, state, state), state.values);
  });

  it('gives a coarse mesh the constants and the mass that are asked for', () => {
    const original = stateOf(name);
    const untouched = { ...stateOf(name, coarse), values: original.values };
    const constants = tunedConstants(original, untouched, { stretchFactor: 1.3, bendFactor: 0.4 });
    const values = nativeValues(profile, original, { constants, facts: coarse });
    expectClose(profile.constants(values, coarse), {
      stretch: constants.stretch,
      secondStretch: constants.secondStretch,
      bend: constants.bend,
      surfaceDensity: constants.surfaceDensity,
    });
    const mass = totalMass(profile.constants(values, coarse), coarse);
    expect(mass / totalMass(original.constants, fine)).toBeCloseTo(1, 9);
  });

  it('has a mass that is the material times its volume', () => {
    const { constants } = stateOf(name);
    const expected = MATERIAL.density * MATERIAL.thickness * fine.area;
    expect(totalMass(constants, fine) / expected).toBeCloseTo(1, 9);
  });

  it('accepts its own parameters, and only these', () => {
    const [{ name: first, min }] = profile.parameters;
    expect(engineValues(name, `${first}=${Math.max(min, 0.25)}`)).toEqual({ [first]: Math.max(min, 0.25) });
    expect(() => engineValues(name, 'stickiness=1')).toThrow(
      `“Your parameters” names stickiness, which ${name} does not have: it has ${first}, `,
    );
  });
});

describe('a plate', () => {
  it('follows from its constants', () => {
    const plate = { young: 3e6, poisson: 0.2, thickness: 0.004 };
    expectClose(plateOf(plateConstants(plate)), plate);
    expectClose(plateOf(plateConstants({ ...plate, poisson: -0.4 })), { ...plate, poisson: -0.4 });
  });

  it('stretches like its net of springs', () => {
    // Springs along three directions: C_1111 and C_1122 of the net, and with them Young's modulus times the thickness.
    const directions = [0, 60, 120].map((degrees) => (degrees * Math.PI) / 180);
    const cell = Math.sqrt(3) / 2;
    const sumOf = (term: (angle: number) => number) =>
      (springOfPlate(MATERIAL) / cell) * directions.reduce((total, angle) => total + term(angle), 0);
    const along = sumOf((angle) => Math.cos(angle) ** 4);
    const across = sumOf((angle) => Math.cos(angle) ** 2 * Math.sin(angle) ** 2);
    expect((along - across ** 2 / along) / (MATERIAL.young * MATERIAL.thickness)).toBeCloseTo(1, 9);
  });

  it('has hinges that do not depend on the length of their edges', () => {
    const { bend } = plateConstants(MATERIAL);
    for (const edge of [0.1, 7]) {
      const area = (Math.sqrt(3) / 4) * edge * edge;
      expect((3 * bend * edge * edge) / (2 * area) / hingeOfPlate(MATERIAL)).toBeCloseTo(1, 12);
    }
  });
});

describe('mujoco', () => {
  it('has the stiffness that MuJoCo 4.0 compiles', () => {
    // A triangle and a hinge of a flex with young 1000, poisson 0.3, thickness 0.1, by finite differences of its forces.
    const given = { young: 1000, poisson: 0.3, thickness: 0.1 };
    const { constants } = stateOf('mujoco', fine, given);
    expect(constants.stretch).toBeCloseTo(38.4615, 3);
    expect(constants.secondStretch + 2 * constants.stretch).toBeCloseTo(109.8901, 3);
    expect(constants.bend).toBeCloseTo(0.030525, 6);
  });

  it('takes two factors as thickness and as Young’s modulus', () => {
    const original = stateOf('mujoco');
    const untouched = { ...stateOf('mujoco', coarse) };
    const constants = tunedConstants(original, untouched, { stretchFactor: 2, bendFactor: 0.5 });
    const values = nativeValues(profileOf('mujoco'), original, { constants, facts: coarse });
    expectClose(values, { thickness: 0.01 * Math.sqrt(0.25), young: 2e5 * 2 * Math.sqrt(4), poisson: 0.3 });
  });
});

describe('blender', () => {
  const untuned = (given: NativeValues = {}) => {
    const original = stateOf('blender', fine, given);
    const constants: SolverConstants = { ...original.constants };
    const result = {
      facts: coarse,
      constants: { ...constants, surfaceDensity: constants.surfaceDensity * (fine.area / coarse.area) },
    };
    return { original, values: nativeValues(profileOf('blender'), original, result) };
  };
  const faceAreas = coarse.area / coarse.faces / (fine.area / fine.faces);
  const [edges, vertices] = [coarse.meanEdge / fine.meanEdge, coarse.vertices / fine.vertices];

  it('needs tension by the edge, and mass and air by the vertices, for the same stiffness and mass', () => {
    const { original, values } = untuned();
    expectClose(values, {
      tension: original.values.tension * edges,
      mass: original.values.mass / vertices,
      air: Math.min(10, original.values.air / vertices),
      bending: (original.values.bending * edges) / faceAreas,
      bending_damping: original.values.bending_damping,
      friction: 5,
    });
  });

  it('has Blender’s default damping and air for a vertex of 0.3 kg, and less in proportion for a lighter one', () => {
    const { values } = stateOf('blender', fine, { mass: 0.3 });
    expectClose(values, { air: 1, tension_damping: 5, bending_damping: 0.5 });
    const share = stateOf('blender').values.mass / 0.3;
    expectClose(stateOf('blender').values, {
      air: share,
      tension_damping: 5 * share,
      bending_damping: 0.5 * share,
    });
    expectClose(stateOf('blender', fine, { mass: 0.003, air: 1 }).values, { air: 1, bending_damping: 0.005 });
    expect(stateOf('blender', fine, { mass: 300 }).values).toMatchObject({ air: 10, tension_damping: 50 });
  });

  it('keeps distances within what it accepts', () => {
    const { values } = untuned({ self_distance_min: 0.09, distance_min: 0.02 });
    expect(values.self_distance_min).toBe(0.1);
    expect(values.distance_min).toBeCloseTo(0.02 * edges, 12);
  });

  it('with the same numbers typed in again has the mass of fewer vertices', () => {
    const { untouched, original } = statesOf(
      profileOf('blender'),
      { original: torus(40, 24), result: torus(16, 10), unit: 1 },
      { material: MATERIAL, given: {} },
    );
    const ratio =
      totalMass(untouched.constants, untouched.facts) / totalMass(original.constants, original.facts);
    expect(ratio).toBeCloseTo(vertices, 9);
    expect(untouched.constants.stretch * edges).toBeCloseTo(original.constants.stretch, 6);
  });
});

describe('springs and dihedral', () => {
  it('have a bend constant by their ratio, unless it is given', () => {
    const { constants } = stateOf('springs', fine, { stretch: 80 });
    expect(constants).toMatchObject({ stretch: 80, bend: 4 });
    expect(stateOf('dihedral', fine, { stretch: 80 }).constants.bend).toBeCloseTo(4 * fine.meanEdge ** 2, 12);
    expect(stateOf('springs', fine, { stretch: 80, bend: 1 }).constants.bend).toBe(1);
  });
});

describe('parameters as text', () => {
  it('come back as they were', () => {
    const values = { young: 1.5e6, poisson: -0.2 };
    expect(parseEngine(engineText(values))).toEqual(values);
    expect(parseEngine(' young = 2e5 , poisson=.3,')).toEqual({ young: 2e5, poisson: 0.3 });
    expect(parseEngine('')).toEqual({});
  });

  it.each([
    ['young', '“Your parameters” has “young”: give name=value,name=value.'],
    ['young=soft', '“Your parameters” has soft for young: give a number.'],
    ['young=1,young=2', '“Your parameters” names young twice: give it once.'],
  ])('are refused where they are %s', (text, sentence) => {
    expect(failureOf(() => parseEngine(text))).toBe(sentence);
  });

  it('are known by the names of the engine’s scripts too', () => {
    expect(engineValues('blender', 'tension_stiffness=15,air_damping=2')).toEqual({ tension: 15, air: 2 });
    expect(failureOf(() => engineValues('blender', 'tension=1,tension_stiffness=15'))).toBe(
      '“Your parameters” names tension twice: give it once.',
    );
    expect(failureOf(() => engineValues('mujoco', 'poisson=0.7'))).toBe(
      '“Your parameters” has 0.7 for poisson: give a number from -0.99 to 0.49.',
    );
  });
});

describe('settings of a solver', () => {
  const check = (change: Partial<Settings>) => checkSettings({ ...defaultSettings(), ...change });

  it('offer every profile', () => {
    expect(OPTIONS.solver.choices).toEqual(['none', ...SOLVER_NAMES]);
    for (const name of SOLVER_NAMES) expect(profileOf(name).name).toBe(name);
  });

  it('are refused where the solver cannot take them', () => {
    expect(failureOf(() => check({ solver: 'blender', tune: 'constraint' }))).toBe(
      '“Tuned by” is constraint, but blender takes maps of vertices at best: give global or vertex.',
    );
    expect(failureOf(() => check({ solver: 'blender', massRule: 'area' }))).toBe(
      '“Mass of a vertex” is area, but blender has one mass for all vertices: give vertex or auto.',
    );
    expect(failureOf(() => check({ solver: 'newton', engine: 'young=1' }))).toMatch(
      /^“Your parameters” names young, which newton does not have: it has tri_ke, /,
    );
    expect(() => check({ solver: 'none', engine: 'young=1' })).not.toThrow();
  });
});

describe('substeps', () => {
  const none = {
    stretchFactors: new Float64Array(),
    bendFactors: new Float64Array(),
    stretchField: new Float64Array(),
    bendField: new Float64Array(),
  };
  const model = { stretch: 'edge-springs', bend: 'hinge', mass: 'area' } as const;
  const constants = { stretch: 1000, secondStretch: 0, bend: 0, poisson: 0, surfaceDensity: 1, unit: 1 };

  it('follow the fastest vibration: exactly, for two masses on a spring', () => {
    const mesh = { positions: Float32Array.from([0, 0, 0, 1, 0, 0]), triangles: new Uint32Array() };
    const tuned = {
      ...none,
      masses: Float64Array.of(0.01, 0.01),
      stretchVertices: Uint32Array.of(0, 1),
      bendVertices: new Uint32Array(),
    };
    // omega = sqrt(2 k / m) = 447.2 rad/s
    expect(substepsNeeded({ mesh, model, constants, tuned })).toBe(Math.ceil(Math.sqrt(2e5) / 60));
    const stiffer = { ...tuned, stretchFactors: Float64Array.of(4) };
    expect(substepsNeeded({ mesh, model, constants, tuned: stiffer })).toBe(
      Math.ceil((2 * Math.sqrt(2e5)) / 60),
    );
  });

  it('bound those of a hinge, whose corner moves against two ends', () => {
    // Two right triangles across the edge from (0, 0) to (1, 0): a corner of mass m vibrates with k / (height^2 m) and more.
    const mesh = {
      positions: Float32Array.from([0, 0, 0, 1, 0, 0, 0.5, 0.1, 0, 0.5, -0.1, 0]),
      triangles: Uint32Array.from([0, 1, 2, 1, 0, 3]),
    };
    const tuned = {
      ...none,
      masses: Float64Array.of(1, 1, 1, 1),
      stretchVertices: new Uint32Array(),
      bendVertices: Uint32Array.of(0, 1, 2, 3),
    };
    // Gradient: 1 / height at each corner, the mean of both at the ends: |g|^2 = 4 / height^2, omega^2 = k |g|^2 / m.
    const omega = Math.sqrt((5000 * 4) / 0.1 ** 2);
    const needed = substepsNeeded({ mesh, model, constants: { ...constants, bend: 5000 }, tuned });
    expect(needed).toBeGreaterThanOrEqual(Math.ceil(omega / 60));
    expect(needed).toBeLessThanOrEqual(Math.ceil((1.01 * omega) / 60));
  });

  it('are unknown with a triangle of zero area, for which no step is short enough', () => {
    const mesh = {
      positions: Float32Array.from([0, 0, 0, 1, 0, 0, 0.5, 0.1, 0, 0.5, 0, 0]),
      triangles: Uint32Array.from([0, 1, 2, 1, 0, 3]),
    };
    const masses = Float64Array.of(1, 1, 1, 1);
    const hinges = Uint32Array.of(0, 1, 2, 3);
    const bent = { ...none, masses, stretchVertices: new Uint32Array(), bendVertices: hinges };
    expect(substepsNeeded({ mesh, model, constants, tuned: bent })).toBeNull();
    const membrane = { stretch: 'membrane', bend: 'hinge-area', mass: 'area' } as const;
    const stretched = { ...none, masses, stretchVertices: mesh.triangles, bendVertices: new Uint32Array() };
    expect(substepsNeeded({ mesh, model: membrane, constants, tuned: stretched })).toBeNull();
  });

  it('are more on a finer mesh of the same sheet', () => {
    const membrane = { stretch: 'membrane', bend: 'hinge-area', mass: 'area' } as const;
    const of = (n: number) => {
      const mesh = grid(n, n);
      const count = mesh.positions.length / 3;
      const masses = new Float64Array(count).fill(1 / count);
      const tuned = { ...none, masses, stretchVertices: mesh.triangles, bendVertices: new Uint32Array() };
      return substepsNeeded({ mesh, model: membrane, constants: { ...constants, stretch: 1e5 }, tuned })!;
    };
    expect(of(16) / of(8)).toBeGreaterThan(1.8);
    expect(of(16) / of(8)).toBeLessThan(2.2);
  });
});
