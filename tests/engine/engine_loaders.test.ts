/**
 * The loaders of docs/engines, run in the engines themselves, on one hinge whose frequency is known. Jolt is a package of the
 * project; the others are run where a Python has them: $LIMBER_BENCH_PYTHON, build/bench/python or python3. Tests of an engine
 * that is absent are skipped.
 */

import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import initJolt from 'jolt-physics';
import { afterAll, describe, expect, it } from 'vitest';
import { joltSoftBody } from '../../docs/engines/load_jolt.mjs';
import type { TriangleMesh } from '../../web/engine/core/core';
import { MATERIALS } from '../../web/engine/settings/materials';
import { meshFacts } from '../../web/engine/solvers/mesh_facts';
import { completeValues } from '../../web/engine/solvers/profile';
import { profileOf } from '../../web/engine/solvers/profiles';
import { grid } from './support/shapes';

const repository = new URL('../../', import.meta.url).pathname;
const bench = join(repository, 'tests', 'bench', 'engines');
const folder = mkdtempSync(join(tmpdir(), 'limber-loaders-'));
afterAll(() => rmSync(folder, { recursive: true }));

/** Metres in a unit of the file: not 1, so that a loader that forgets them fails. */
const UNIT = 2;
const FLAP = 3;
/** In metres: the edge of the hinge on the x axis, a pinned corner below and the flap above it. */
const PLACES = [0, 0, 0, 1, 0, 0, 0.5, -0.8, 0, 0.4, 0.9, 0];
const [LENGTH, HEIGHT, AREAS] = [1, 0.9, (0.9 + 0.8) / 2];
const MASS = 0.2;

interface Settings {
  schema: string;
  solver: string;
  bodies: {
    mesh: { positions: number[]; triangles: number[] };
    mass: { perVertex: number[] };
    substeps: number;
    stretch: { constant: number; pairs: number[]; factors?: number[] };
    bend: { constant: number; hinges: number[]; factors?: number[] };
    vertex?: { stretch: number[]; bend: number[] };
  }[];
}

function settingsOf(solver: string, engine: object, bend: number): Settings {
  const body = {
    name: 'flap',
    level: 0,
    unit: UNIT,
    mesh: { positions: PLACES.map((x) => x / UNIT), triangles: [0, 1, 3, 1, 0, 2] },
    mass: { rule: 'area', perVertex: [0.5, 0.5, 0.5, MASS] },
    stretch: { constant: 500, pairs: [0, 1, 1, 3, 0, 3, 0, 2, 1, 2] },
    bend: { constant: bend, hinges: [0, 1, 2, 3] },
    pins: [0, 1, 2],
    substeps: 10,
    engine,
  };
  return { schema: 'limber-settings/1', solver, bodies: [body] };
}

/** Hz, of a flap of mass MASS on a hinge of `stiffness` N m: its moment of inertia is MASS HEIGHT^2. */
const flapFrequency = (stiffness: number): number =>
  Math.sqrt(stiffness / (MASS * HEIGHT * HEIGHT)) / (2 * Math.PI);

function writtenSettings(name: string, settings: object): string {
  const file = join(folder, `${name}.json`);
  writeFileSync(file, JSON.stringify(settings));
  return file;
}

/** A Python that imports `module`, or undefined. */
function pythonWith(module: string): string | undefined {
  const own = join(repository, 'build', 'bench', 'python', 'bin', 'python');
  const candidates = [process.env.LIMBER_BENCH_PYTHON, existsSync(own) ? own : undefined, 'python3'];
  const code = `import importlib.util as u, sys; sys.exit(0 if u.find_spec("${module}") and u.find_spec("numpy") else 1)`;
  return candidates.find((python) => python && spawnSync(python, ['-c', code]).status === 0);
}

function flapIn(python: string, engine: string, settings: object): number {
  const file = writtenSettings(engine, settings);
  const program = join(bench, 'flap.py');
  const { status, stdout, stderr } = spawnSync(python, [program, engine, file, String(FLAP)], {
    encoding: 'utf8',
  });
  expect(status, stderr).toBe(0);
  return (JSON.parse(stdout.trim().split('\n').at(-1)!) as { frequency: number }).frequency;
}

describe('a flap in the engine, loaded from a settings file', () => {
  const python = { mujoco: pythonWith('mujoco'), newton: pythonWith('newton'), blender: pythonWith('bpy') };
  const [young, poisson, thickness] = [2e8, 0.3, 0.01];
  const plate = (young * thickness ** 3) / (12 * (1 - poisson * poisson));

  it.skipIf(!python.mujoco)('swings in MuJoCo with the hinge D l^2 / (A1 + A2), within 1 %', () => {
    const stiffness = (plate * LENGTH * LENGTH) / AREAS;
    const found = flapIn(
      python.mujoco!,
      'mujoco',
      settingsOf('mujoco', { young, poisson, thickness }, stiffness),
    );
    expect(Math.abs(found / flapFrequency(stiffness) - 1)).toBeLessThan(0.01);
  });

  it.skipIf(!python.mujoco)('takes the factor of a single hinge in MuJoCo', () => {
    const stiffness = (plate * LENGTH * LENGTH) / AREAS;
    const settings = settingsOf('mujoco', { young, poisson, thickness }, stiffness);
    settings.bodies[0].bend.factors = [2.25];
    const found = flapIn(python.mujoco!, 'mujoco', settings);
    expect(Math.abs(found / flapFrequency(stiffness) - 1.5)).toBeLessThan(0.015);
  });

  it.skipIf(!python.mujoco)('takes the map of --tune vertex in MuJoCo: the mean of the hinge', () => {
    const stiffness = (plate * LENGTH * LENGTH) / AREAS;
    const settings = settingsOf('mujoco', { young, poisson, thickness }, stiffness);
    settings.bodies[0].vertex = { stretch: [1, 1, 1, 1], bend: [1, 1, 1, 6] };
    const found = flapIn(python.mujoco!, 'mujoco', settings);
    expect(Math.abs(found / flapFrequency(stiffness) - 1.5)).toBeLessThan(0.015);
  });

  it.skipIf(!python.mujoco)(
    'has masses and factors of its own beside other bodies in one model of MuJoCo',
    () => {
      const stiffness = (plate * LENGTH * LENGTH) / AREAS;
      const settings = settingsOf('mujoco', { young, poisson, thickness }, stiffness);
      const [first] = settings.bodies;
      const last = structuredClone(first);
      last.bend.factors = [2.25];
      first.bend.factors = [9];
      first.stretch.factors = [4, 4];
      first.mass.perVertex = [5, 5, 5, 5];
      settings.bodies.push(last);
      const found = flapIn(python.mujoco!, 'mujoco', settings);
      expect(Math.abs(found / flapFrequency(stiffness) - 1.5)).toBeLessThan(0.015);
    },
  );

  it.skipIf(!python.newton)(
    'swings in Newton with the hinge edge_ke l, within 1 %',
    () => {
      const engine = { tri_ke: 400, tri_ka: 300, edge_ke: 4, density: 1 };
      const found = flapIn(python.newton!, 'newton', settingsOf('newton', engine, engine.edge_ke));
      expect(Math.abs(found / flapFrequency(engine.edge_ke * LENGTH) - 1)).toBeLessThan(0.01);
    },
    300_000,
  );

  it.skipIf(!python.newton)(
    'has no substeps in Newton in which gravity is lost in the rounding of positions',
    () => {
      const { mesh } = settingsOf('newton', {}, 1).bodies[0];
      const bodies = [1, 50].map((unit) => ({ mesh, unit: unit * UNIT, substeps: 100_000 }));
      const code = `import load_newton as n; b = ${JSON.stringify(bodies)}; print([n.substeps_for(b[:1]), n.substeps_for(b)])`;
      const cwd = join(repository, 'docs', 'engines');
      const { stdout, stderr } = spawnSync(python.newton!, ['-c', code], { cwd, encoding: 'utf8' });
      const numbers = JSON.parse(stdout.trim().split('\n').at(-1)!) as number[];
      const units = numbers.map((substeps, k) => 9.81 / (60 * substeps) ** 2 / (2 ** -23 * [1, 50][k]));
      for (const change of units) expect(change, stderr).toBeGreaterThanOrEqual(16);
    },
    300_000,
  );

  it.skipIf(!python.newton)(
    'takes the map of --tune vertex in Newton: the mean of the hinge',
    () => {
      const engine = { tri_ke: 400, tri_ka: 300, edge_ke: 4, density: 1 };
      const settings = settingsOf('newton', engine, engine.edge_ke);
      settings.bodies[0].vertex = { stretch: [1, 1, 1, 1], bend: [1, 1, 1, 6] };
      const found = flapIn(python.newton!, 'newton', settings);
      expect(Math.abs(found / flapFrequency(engine.edge_ke * LENGTH) - 1.5)).toBeLessThan(0.015);
    },
    300_000,
  );

  it.skipIf(!python.newton)(
    'takes factors in Newton beside a triangle without area, which its builder leaves out',
    () => {
      const engine = { tri_ke: 400, tri_ka: 300, edge_ke: 4, density: 1 };
      const settings = settingsOf('newton', engine, engine.edge_ke);
      const [body] = settings.bodies;
      body.mesh.triangles.unshift(0, 0, 1);
      body.stretch.factors = [9, 1, 1];
      body.bend.factors = [2.25];
      const found = flapIn(python.newton!, 'newton', settings);
      expect(Math.abs(found / flapFrequency(engine.edge_ke * LENGTH) - 1.5)).toBeLessThan(0.015);
    },
    300_000,
  );

  it.skipIf(!python.blender)(
    'swings in Blender with the torque 0.1 bending l h / 3 in N m, within 5 %',
    () => {
      const engine = { tension: 500, bending: 500, mass: 50, air: 0 };
      const settings = settingsOf('blender', engine, 0);
      const found = flapIn(python.blender!, 'blender', settings);
      // Stiffness counts 1000 times in seconds, and every vertex has the mass of the settings.
      const stiffness = (1000 * 0.1 * engine.bending * LENGTH * HEIGHT) / 3;
      const expected = flapFrequency((stiffness * MASS) / engine.mass);
      expect(Math.abs(found / expected - 1)).toBeLessThan(0.05);
      // By a map, Blender takes the mean of the ends of an edge.
      settings.bodies[0].vertex = { stretch: [1, 2, 1, 2], bend: [2.25, 2.25, 1, 1] };
      const mapped = flapIn(python.blender!, 'blender', settings);
      expect(Math.abs(mapped / found - 1.5)).toBeLessThan(0.05);
    },
    60_000,
  );

  const engines = Object.entries(python).filter(([, program]) => program);
  it.skipIf(engines.length === 0)(
    'is refused from the file of another solver, with the cure',
    () => {
      const file = writtenSettings('other', settingsOf('jolt', {}, 1));
      for (const [engine, program] of engines) {
        const found = spawnSync(program!, [join(bench, 'flap.py'), engine, file, String(FLAP)], {
          encoding: 'utf8',
        });
        expect(found.stderr).toContain(
          `ValueError: this settings file is for jolt: write one with --solver ${engine}`,
        );
      }
    },
    60_000,
  );
});

describe('a sheet of a real material in Blender, with the defaults of the profile', () => {
  const python = pythonWith('bpy');

  /** Of 1 m by 1 m, level but for low waves; the first six vertices are half of an edge. */
  function levelSheet(): TriangleMesh {
    const { positions, triangles } = grid(10, 10);
    const level = positions.map((_, k) => {
      const [x, y] = positions.subarray(k - (k % 3));
      return [x, 0.02 * Math.sin(6 * x) * Math.cos(5 * y), -y][k % 3];
    });
    return { positions: level, triangles };
  }

  it.skipIf(!python).each(['cotton', 'silk'] as const)(
    'stays at rest nearly without gravity, held at an edge, and falls with it: %s',
    (name) => {
      const sheet = levelSheet();
      const original = meshFacts(sheet, 1);
      const { thickness, ...rest } = MATERIALS[name];
      const material = { ...rest, thickness: (thickness / 100) * Math.SQRT2, bendRatio: 0.05 };
      const engine = completeValues(profileOf('blender'), { material, original, given: {} });
      const mesh = { positions: [...sheet.positions], triangles: [...sheet.triangles] };
      const body = {
        name,
        unit: original.unit,
        mesh,
        pins: [0, 1, 2, 3, 4, 5],
        substeps: engine.quality,
        engine,
      };
      const file = writtenSettings(name, { solver: 'blender', bodies: [body] });
      const found = spawnSync(python!, [join(bench, 'blender_sheet.py'), file], { encoding: 'utf8' });
      expect(found.status, found.stderr).toBe(0);
      const way = JSON.parse(found.stdout.trim().split('\n').at(-1)!) as { rest: number; fall: number };
      expect(way.rest).toBeLessThan(1e-5);
      expect(way.fall).toBeGreaterThan(0.2);
    },
    60_000,
  );
});

describe('the Jolt loader', () => {
  const program = join(bench, 'jolt_run.mjs');
  const stiffness = 3;

  function heights(settings: object, iterations: number): number[] {
    const [body] = (settings as { bodies: object[] }).bodies;
    const start = [...PLACES];
    start[3 * FLAP + 2] = 0.01;
    const [step, frames] = [1 / 120, 240];
    const still = new Array<number>(12).fill(0);
    const job = { body, start, velocity: still, step, frames, iterations, forces: null };
    const [source, target] = [writtenSettings('job', job), join(folder, 'result.bin')];
    const { status, stderr } = spawnSync(process.execPath, [program, source, target], { encoding: 'utf8' });
    expect(status, stderr).toBe(0);
    const { buffer, byteOffset, length } = readFileSync(target);
    const values = new Float32Array(buffer.slice(byteOffset, byteOffset + length));
    return Array.from({ length: frames }, (_, frame) => values[12 * frame + 3 * FLAP + 2]);
  }

  function frequencyOf(series: number[], step: number): number {
    const times = series.flatMap((value, k) => {
      const next = series[k + 1];
      return k + 1 < series.length && value > 0 !== next > 0 ? [(k + value / (value - next)) * step] : [];
    });
    return (times.length - 1) / (2 * (times.at(-1)! - times[0]));
  }

  it('makes a flap swing with the frequency of its hinge, within 1 %', () => {
    const found = frequencyOf(heights(settingsOf('jolt', {}, stiffness), 10), 1 / 120);
    expect(Math.abs(found / flapFrequency(stiffness) - 1)).toBeLessThan(0.01);
  });

  it('takes the factors of single constraints', () => {
    const settings = settingsOf('jolt', {}, stiffness);
    settings.bodies[0].bend.factors = [4];
    const found = frequencyOf(heights(settings, 10), 1 / 120);
    expect(Math.abs(found / flapFrequency(stiffness) - 2)).toBeLessThan(0.02);
  });

  it('takes the map of --tune vertex: the mean of the hinge', () => {
    const settings = settingsOf('jolt', {}, stiffness);
    settings.bodies[0].vertex = { stretch: [1, 1, 1, 1], bend: [1, 1, 1, 13] };
    const found = frequencyOf(heights(settings, 10), 1 / 120);
    expect(Math.abs(found / flapFrequency(stiffness) - 2)).toBeLessThan(0.02);
  });

  it('scales the iterations to the step, and leaves nothing in the memory of Jolt but the body', async () => {
    const Jolt = await initJolt();
    const settings = settingsOf('jolt', {}, stiffness);
    const made = (step: number): number => {
      const creation = joltSoftBody(Jolt, settings, { step });
      const iterations = creation.mNumIterations;
      Jolt.destroy(creation);
      return iterations;
    };
    expect([1 / 60, 1 / 180, 1 / 30, 1e-6].map(made)).toEqual([10, 4, 20, 1]);
    const { sGetFreeMemory } = Jolt.JoltInterface.prototype as { sGetFreeMemory(): number };
    const free = sGetFreeMemory();
    for (let k = 0; k < 20; k++) made(1 / 60);
    expect(sGetFreeMemory()).toBe(free);
  });

  it('makes no substeps in which gravity is lost in the rounding of positions', async () => {
    const Jolt = await initJolt();
    const settings = settingsOf('jolt', {}, stiffness);
    const [body] = settings.bodies;
    body.substeps = 100_000;
    for (const farthest of [0.5, 1, 100]) {
      body.mesh.positions = PLACES.map((x) => (farthest * x) / UNIT);
      const creation = joltSoftBody(Jolt, settings);
      const change = 9.81 / (60 * creation.mNumIterations) ** 2;
      Jolt.destroy(creation);
      expect(change / (2 ** -23 * farthest)).toBeGreaterThanOrEqual(16);
      expect(change / (2 ** -23 * farthest)).toBeLessThan(64);
    }
  });

  it('refuses the file of another solver, with the cure', () => {
    expect(() => joltSoftBody(undefined as never, settingsOf('mujoco', {}, 1))).toThrow(
      /^This settings file is for mujoco: write one with --solver jolt\.$/,
    );
  });
});
