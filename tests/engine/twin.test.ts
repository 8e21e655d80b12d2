import { beforeAll, describe, expect, it } from 'vitest';
import type { Binding, Core, TriangleMesh } from '../../web/engine/core/core';
import { NONE } from '../../web/engine/core/core';
import { defaultSettings } from '../../web/engine/settings/options';
import type { Settings } from '../../web/engine/settings/options';
import { STAGES } from '../../web/engine/stages/stages';
import { simulationOptions } from '../../web/engine/motion/simulation';
import { topCorners } from '../../web/engine/motion/top_corners';
import { Twin } from '../../web/engine/motion/twin';
import type { TwinSample } from '../../web/engine/motion/twin';
import { edgesOf, Stretch } from '../../web/engine/motion/stretch';
import { boundPositions, VertexDistances } from '../../web/engine/motion/vertex_distances';
import { onOptimized, onOriginal, positionOf } from '../../web/engine/motion/twin_points';
import { loadTestCore } from './support/core';
import { grid } from './support/shapes';
import { runOfMesh } from './support/runs';

let core: Core;
beforeAll(async () => {
  core = await loadTestCore(2);
});

const moved = (positions: Float32Array, by: number[], scale = 1): Float32Array =>
  positions.map((value, i) => scale * value + by[i % 3]);

const boundBodies = ({ binding }: Twin, original: TriangleMesh, optimized: TriangleMesh) => ({
  ...{ original, optimized, binding },
});

describe('measures of two bodies', () => {
  const mesh = grid(3, 2);

  it('contain every edge once', () => {
    const edges = edgesOf(mesh);
    const pairs = Array.from({ length: edges.length / 2 }, (_, e) => `${edges[2 * e]} ${edges[2 * e + 1]}`);
    expect(new Set(pairs).size).toBe(pairs.length);
    expect(pairs.length).toBe(3 * 3 * 2 + 3 + 2);
  });

  it('give a stretch of 100 % for twice the size and 0 for a rigid motion', () => {
    const stretch = new Stretch(mesh);
    expect(stretch.mean(moved(mesh.positions, [1, 2, 3], 2))).toBeCloseTo(100, 4);
    expect(stretch.mean(moved(mesh.positions, [1, 2, 3]))).toBeCloseTo(0, 4);
  });

  it('give no distance for vertices that move alike from different rest positions', () => {
    const apart = moved(mesh.positions, [0, 0, 0.5]);
    const distances = new VertexDistances(mesh.positions, apart, 2);
    const now = moved(mesh.positions, [1, 0, 0]);
    for (const value of distances.between(now, moved(apart, [1, 0, 0]))) expect(value).toBeCloseTo(0, 4);
    const values = distances.between(now, moved(apart, [1, 0.1, 0]));
    expect(values).toHaveLength(mesh.positions.length / 3);
    for (const value of values) expect(value).toBeCloseTo(5, 4);
  });
});

describe('a bound surface', () => {
  // One triangle in the plane z = 0, and vertices at its corner, above its middle and unbound.
  const triangle: TriangleMesh = {
    positions: Float32Array.of(0, 0, 0, 3, 0, 0, 0, 3, 0),
    triangles: Uint32Array.of(0, 1, 2),
  };
  const binding: Binding = {
    triangle: Uint32Array.of(0, 0, NONE),
    barycentric: Float32Array.of(1, 0, 0, 1 / 3, 1 / 3, 1 / 3, 0, 0, 0),
    offset: Float32Array.of(0, 0.5, 0),
  };
  const rest = Float32Array.of(0, 0, 0, 1, 1, 0.5, 7, 8, 9);

  it('follows the triangle at its height above it; unbound vertices stay in place', () => {
    const turned = Float32Array.of(0, 0, 0, 0, 3, 0, 0, 0, 3); // the normal is +x now
    const flat = boundPositions(binding, triangle, turned, { rest, offsets: false });
    const lifted = boundPositions(binding, triangle, turned, { rest, offsets: true });
    expect([...flat.subarray(0, 6)].map((x) => Math.round(x * 1e5) / 1e5)).toEqual([0, 0, 0, 0, 1, 1]);
    expect([...lifted.subarray(3)].map((x) => Math.round(x * 1e5) / 1e5)).toEqual([0.5, 1, 1, 7, 8, 9]);
  });
});

describe('the corners that a body hangs by', () => {
  it('are the upper ones of an upright sheet and the back ones of a horizontal sheet', () => {
    const upright = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0.5, 1, 0);
    const flat = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 1);
    const none = new Uint32Array();
    expect([...topCorners({ positions: upright, triangles: none })]).toEqual([2, 3]);
    expect([...topCorners({ positions: flat, triangles: none })]).toEqual([0, 1]);
  });
});

describe('twins', () => {
  const sheet = grid(12, 12);
  const settings = { ...defaultSettings('qem'), substeps: 8, scenario: 'hang' as const };

  function makeTwin(
    faces: number,
    { pinned, core: own = core, ...change }: Partial<Settings> & { pinned?: Uint32Array; core?: Core } = {},
  ) {
    const run = runOfMesh(core, sheet);
    const prepared = run.get(STAGES.prepared, settings);
    const result = run.get(STAGES.level, { ...settings, targetFaces: faces });
    const options = simulationOptions(prepared, { ...settings, ...change }, pinned ?? null);
    const { mesh, diagonal } = prepared;
    const twin = new Twin(own, mesh, result, { ...options, diagonal, measuresNoise: true });
    return { twin, mesh, result, options };
  }

  function steps(twin: Twin, count: number): TwinSample[] {
    return Array.from({ length: count }, () => twin.step().sample!);
  }

  it('of the same mesh stay together, while another order of constraints does not', () => {
    const { twin } = makeTwin(288);
    const last = steps(twin, 20).at(-1)!;
    expect(last.max).toBeLessThan(1e-4);
    expect(last.noise).toBeGreaterThan(0);
    twin.end();
  });

  it('are measured after every step, including their costs', () => {
    const { twin, mesh } = makeTwin(120);
    expect(twin.stepSeconds('original')).toBe(0);
    const samples = steps(twin, 20);
    expect(samples.map(({ time }) => Math.round(60 * time))).toEqual(samples.map((_, i) => i + 1));
    const { mean, max, noise } = samples.at(-1)!;
    expect(mean).toBeGreaterThan(noise!);
    expect(max).toBeGreaterThan(mean);
    expect(twin.vertexDistances()).toHaveLength(mesh.positions.length / 3);
    // Vertices of the border move more than the points between them.
    expect(Math.max(...twin.vertexDistances()) / max).toBeGreaterThan(0.8);
    expect(twin.stretchOf('original')).toBeGreaterThan(0);
    for (const name of ['original', 'optimized'] as const) expect(twin.stepSeconds(name)).toBeGreaterThan(0);
    twin.end();
  });

  it('move without the noise floor exactly as with it', () => {
    const [{ twin: a }, { twin: b }] = [makeTwin(120), makeTwin(120)];
    steps(a, 5);
    a.endNoise();
    const samples = steps(a, 5);
    expect(samples.every(({ noise }) => noise === null)).toBe(true);
    expect(samples.at(-1)!.mean).toBe(steps(b, 10).at(-1)!.mean);
    a.end();
    b.end();
  });

  it('transfer pins by the binding, and move them alike on both bodies', () => {
    const { twin, mesh } = makeTwin(60, { pinned: topCorners(sheet), scenario: 'pull', seconds: 0.2 });
    const before = twin.pins('original');
    expect(before).toHaveLength(6);
    steps(twin, 10);
    const after = twin.pins('original');
    const ways = [0, 1].map((pin) =>
      Math.hypot(...[0, 1, 2].map((c) => after[3 * pin + c] - before[3 * pin + c])),
    );
    expect(Math.min(...ways)).toBe(0);
    expect(Math.max(...ways)).toBeCloseTo(0.2, 5);
    twin.pins('optimized').forEach((value, i) => expect(value).toBeCloseTo(after[i], 5));
    expect(twin.driven()).toHaveLength(mesh.positions.length);
    twin.end();
  });

  it('have the deviation of the report, to the last bit', () => {
    const { twin, mesh, result, options } = makeTwin(120, { scenario: 'sway' });
    const compared = (count: number) =>
      core.compareMotion(mesh, result.mesh, {
        ...options,
        seconds: count / 60,
        records: false,
        binding: twin.binding,
      });
    const samples = steps(twin, 12);
    const first = compared(1);
    const { mean, max, noise } = samples[0];
    expect([mean, max, noise]).toEqual([first.deviationMean, first.deviationMax, first.noiseFloor]);
    const all = compared(12);
    expect(Math.max(...samples.map((sample) => sample.max))).toBe(all.deviationMax);
    const average = (key: 'mean' | 'noise') => samples.reduce((sum, sample) => sum + sample[key]!, 0) / 12;
    expect(average('mean') / all.deviationMean).toBeCloseTo(1, 12);
    expect(average('noise') / all.noiseFloor).toBeCloseTo(1, 12);
    twin.end();
  });

  it('are dragged to the same target by a point of either body', () => {
    for (const name of ['original', 'optimized'] as const) {
      const { twin, mesh, result } = makeTwin(120);
      const own = name === 'original' ? mesh : result.mesh;
      const point = {
        triangle: own.triangles.length / 3 - 1,
        barycentric: [0.2, 0.3, 0.5] as [number, number, number],
      };
      const other =
        name === 'original'
          ? onOptimized(core, boundBodies(twin, mesh, result.mesh), point)
          : onOriginal(core, boundBodies(twin, mesh, result.mesh), point);
      const target = positionOf(own.triangles, own.positions, point).map((x) => x + 0.2) as [
        number,
        number,
        number,
      ];
      const move = twin.drag(name, point);
      move(target);
      steps(twin, 60);
      const points = [
        positionOf(own.triangles, twin.positions(name), point),
        positionOf(
          (name === 'original' ? result.mesh : mesh).triangles,
          twin.positions(name === 'original' ? 'optimized' : 'original'),
          other,
        ),
      ];
      for (const at of points) at.forEach((x, c) => expect(x).toBeCloseTo(target[c], 2));
      twin.release();
      twin.end();
    }
  });

  it('map a point to the other body and back to where it was', () => {
    const { twin, mesh, result } = makeTwin(120);
    for (let triangle = 0; triangle < mesh.triangles.length / 3; triangle += 17) {
      const point = { triangle, barycentric: [0.25, 0.25, 0.5] as [number, number, number] };
      const bound = boundBodies(twin, mesh, result.mesh);
      const back = onOriginal(core, bound, onOptimized(core, bound, point));
      const [from, to] = [
        positionOf(mesh.triangles, mesh.positions, point),
        positionOf(mesh.triangles, mesh.positions, back),
      ];
      from.forEach((x, c) => expect(to[c]).toBeCloseTo(x, 1));
    }
    twin.end();
  });

  it('collide with the scene of the scenario and with what is added', () => {
    const { twin } = makeTwin(120, { scenario: 'drop', colliders: 'ball:0.5,0.5,-0.4,0.2' });
    const { ground, colliders } = twin.collisionScene;
    expect(ground).toBeLessThan(0);
    expect(colliders).toHaveLength(1);
    expect(colliders[0].radius).toBeCloseTo(0.2, 6);
    twin.end();
  });

  it.each(['original', 'optimized'] as const)('name only the %s if only it has diverged', (name) => {
    const numbers: number[] = [];
    const broken: Core = {
      ...core,
      startSimulation: (...values) => {
        numbers.push(core.startSimulation(...values));
        return numbers[numbers.length - 1];
      },
      stepSimulations: () => {
        throw new Error('diverged');
      },
      simulationDiverged: (number) => number === numbers[name === 'original' ? 0 : 1],
    };
    const { twin } = makeTwin(120, { core: broken });
    expect(twin.step()).toEqual({ sample: null, diverged: [name] });
    twin.end();
  });

  it('diverge if they are dragged far beyond their size, and both are named', () => {
    const { twin, result } = makeTwin(120);
    const point = {
      triangle: result.mesh.triangles.length / 3 - 1,
      barycentric: [1, 0, 0] as [number, number, number],
    };
    twin.drag('optimized', point)([1e4, 0, 0]);
    let diverged: string[] = [];
    for (let i = 0; i < 60 && diverged.length === 0; i++) diverged = twin.step().diverged;
    expect(diverged).toEqual(['original', 'optimized']);
    twin.end();
  });
});
