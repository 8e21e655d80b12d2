import { beforeAll, describe, expect, it } from 'vitest';
import type { Core, TriangleMesh } from '../../web/engine/core/core';
import type { BodySettings, SettingsFile } from '../../web/engine/report/settings_file';
import { solversOfSettings } from '../../web/engine/report/solvers_of_settings';
import { defaultSettings } from '../../web/engine/settings/options';
import { constraintVertices } from '../../web/engine/solvers/constraint_vertices';
import { factorsOf } from '../../web/engine/solvers/solver_pair';
import { prepareBody } from '../../web/engine/stages/prepared';
import { bodyOf } from './support/bodies';
import { loadTestCore } from './support/core';
import { failureOf } from './support/files';
import { grid } from './support/shapes';

let core: Core;
beforeAll(async () => {
  core = await loadTestCore(1);
});

const mesh = grid(3, 2);
const count = mesh.positions.length / 3;
const NET = { stretch: 'edge-springs', bend: 'cross-springs' } as const;

/** The settings have the vertices of the mesh in the opposite order. */
const turned = (v: number): number => count - 1 - v;
const turnedMesh: TriangleMesh = {
  positions: Float32Array.from(
    { length: mesh.positions.length },
    (_, i) => mesh.positions[3 * turned(Math.floor(i / 3)) + (i % 3)],
  ),
  triangles: mesh.triangles.map(turned),
};

/** A factor that tells which vertices of `mesh` a constraint has. */
const mark = (vertices: number[]): number => 1 + vertices.reduce((sum, v) => sum + 2 ** (v % 16) / 7, 0);

function entry(): BodySettings {
  const { stretch, bend } = constraintVertices(turnedMesh, NET);
  const marks = (lists: number[][]) => lists.map((vertices) => mark(vertices.map(turned)));
  return {
    name: 'body',
    level: 0,
    unit: 1,
    mesh: { positions: [...turnedMesh.positions], triangles: [...turnedMesh.triangles] },
    renderVertices: Array.from({ length: count }, (_, v) => turned(v)),
    mass: { rule: 'area', perVertex: Array.from({ length: count }, (_, v) => 10 + turned(v)) },
    stretch: { constant: 7, pairs: stretch.flat(), factors: marks(stretch) },
    bend: { constant: 0.5, pairs: bend.flat(), factors: marks(bend) },
    pins: [],
    substeps: 20,
    engine: { stretch: 7, bend: 0.5 },
    original: { vertices: 9, faces: 8, totalMass: 3, stretch: 5, bend: 0.25, density: 3 },
    frequencies: {},
  };
}

const fileOf = (body: BodySettings): SettingsFile => ({
  ...{ schema: 'limber-settings/1', version: '0', solver: 'springs', status: 'generic', tune: 'constraint' },
  units: { length: 1 },
  ...{ engine: body.engine, original: body.original, bodies: [body], frequencies: {} },
});

const solversFor = (body: BodySettings, unit = 1) =>
  solversOfSettings(fileOf(body), grid(2, 2), prepareBody(core, bodyOf(mesh), defaultSettings()), unit);

describe('the settings of a mesh that was read from its own file', () => {
  it('are found by vertices, however these are numbered', () => {
    const { result } = solversFor(entry());
    const here = constraintVertices(mesh, NET);
    expect([...result.masses!]).toEqual(Array.from({ length: count }, (_, v) => 10 + v));
    result.stretchFactors!.forEach((factor, c) => expect(factor).toBeCloseTo(mark(here.stretch[c]), 9));
    result.bendFactors!.forEach((factor, c) => expect(factor).toBeCloseTo(mark(here.bend[c]), 9));
    expect(result.stretchFactors).toHaveLength(here.stretch.length);
    expect(result.constants).toMatchObject({ stretch: 7, bend: 0.5 });
  });

  it('are found where primitives share a list of vertices, which the settings have once for each', () => {
    const body = bodyOf(mesh);
    const [span] = body.spans;
    body.spans.push({ ...span, primitive: 1, first: 4 });
    const settings = entry();
    settings.renderVertices.push(...settings.renderVertices);
    const { result } = solversOfSettings(
      fileOf(settings),
      grid(2, 2),
      prepareBody(core, body, defaultSettings()),
      1,
    );
    expect([...result.masses!]).toEqual(Array.from({ length: count }, (_, v) => 10 + v));
  });

  it('are those of the nearest of several bodies with one name and size', () => {
    const other = entry();
    other.mesh.positions = other.mesh.positions.map((value) => value + 3);
    other.mass.perVertex = other.mass.perVertex.map(() => 1);
    const file = { ...fileOf(entry()), bodies: [other, entry()] };
    const { result } = solversOfSettings(
      file,
      grid(2, 2),
      prepareBody(core, bodyOf(mesh), defaultSettings()),
      1,
    );
    expect([...result.masses!]).toEqual(Array.from({ length: count }, (_, v) => 10 + v));
  });

  it('are those of the mesh in the file where several bodies are equal', () => {
    const copies = [2, 1, 0].map((meshNumber) => {
      const mass = { rule: 'area' as const, perVertex: Array<number>(count).fill(1 + meshNumber) };
      return { ...entry(), meshNumber, mass };
    });
    const massOf = (number: number, bodies: BodySettings[]) => {
      const prepared = prepareBody(core, { ...bodyOf(mesh), mesh: number }, defaultSettings());
      return solversOfSettings({ ...fileOf(bodies[0]), bodies }, grid(2, 2), prepared, 1).result.masses![0];
    };
    expect([0, 1, 2].map((number) => massOf(number, copies))).toEqual([1, 2, 3]);
    // Files of the first versions do not have it, and a mesh may have moved to another place.
    expect(
      massOf(
        0,
        copies.map(({ meshNumber: _, ...earlier }) => earlier),
      ),
    ).toBe(3);
    expect(massOf(9, copies)).toBe(3);
  });

  it('leave the original the parameters that it was tuned to', () => {
    const { original } = solversFor(entry());
    expect(original).toEqual({
      model: { ...NET, mass: 'area' },
      constants: { stretch: 5, secondStretch: 0, bend: 0.25, poisson: 0, surfaceDensity: 3, unit: 1 },
    });
  });

  it('leave the original its rule of masses', () => {
    const body = entry();
    body.mass.original = 'vertex';
    const { original, result } = solversFor(body);
    expect([original.model.mass, result.model.mass]).toEqual(['vertex', 'area']);
  });

  it('spread maps of vertices over the constraints', () => {
    const body = entry();
    const field = Array.from({ length: count }, (_, v) => 1 + turned(v));
    body.vertex = { stretch: field, bend: field.map((value) => 2 * value) };
    delete body.stretch.factors;
    delete body.bend.factors;
    const { result } = solversFor(body);
    const here = constraintVertices(mesh, NET);
    const mean = ([a, b]: number[]): number => 1 + (a + b) / 2;
    expect([...result.stretchFactors!]).toEqual(here.stretch.map(mean));
    expect([...result.bendFactors!]).toEqual(here.bend.map((pair) => 2 * mean(pair)));
  });

  it('are refused with a sentence where they are of another mesh or unit', async () => {
    const other = { ...entry(), name: 'sleeve' };
    expect(await failureOf(() => solversFor(other))).toBe(
      'The settings are not of "body" with 12 faces: take those that were written with this file.',
    );
    expect(await failureOf(() => solversFor(entry(), 0.01))).toBe(
      '“One unit of the file” makes 0.01 m of a unit of "body", but its settings are for 1 m: give the unit that they were made with.',
    );
    const finer = { ...entry(), original: { ...entry().original, vertices: 25, faces: 32 } };
    expect(await failureOf(() => solversFor(finer))).toBe(
      'The settings of "body" are for an original of 25 vertices and 32 faces, but this one has 9 vertices and 8 faces: name the mesh that they were made from.',
    );
  });
});

describe('constraints by their vertices', () => {
  it('are in the order of the core', () => {
    const square = { positions: new Float32Array(12), triangles: Uint32Array.of(2, 0, 1, 1, 3, 2) };
    expect(constraintVertices(square, NET)).toEqual({
      stretch: [
        [0, 1],
        [0, 2],
        [1, 2],
        [1, 3],
        [2, 3],
      ],
      bend: [[0, 3]],
    });
    expect(constraintVertices(square, { stretch: 'membrane', bend: 'hinge' })).toEqual({
      stretch: [
        [2, 0, 1],
        [1, 3, 2],
      ],
      bend: [[1, 2, 0, 3]],
    });
  });

  it('take the mean of a map over their vertices', () => {
    const none = new Float64Array();
    const tuned = {
      ...{ stretchFactors: none, bendFactors: none, bendField: none },
      stretchField: Float64Array.of(1, 2, 6),
      stretchVertices: Uint32Array.of(0, 1, 1, 2),
      bendVertices: new Uint32Array(),
    };
    const model = { ...NET, mass: 'area' } as const;
    expect(factorsOf(model, tuned)).toEqual({ stretchFactors: Float64Array.of(1.5, 4) });
  });
});
