/** Results and coarse meshes of other tools are tuned to solvers, by the command line and the real core. */

import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { parseArguments } from '../../web/cli/arguments';
import type { Arguments } from '../../web/cli/arguments';
import { describeFailure } from '../../web/cli/failure';
import { runOptimize } from '../../web/cli/optimize';
import { runTune } from '../../web/cli/tune';
import type { TriangleMesh } from '../../web/engine/core/core';
import { sum } from '../../web/engine/core/mesh';
import { validateGlb } from '../../web/engine/document/validate';
import type { Report } from '../../web/engine/report/report';
import type { BodySettings, SettingsFile } from '../../web/engine/report/settings_file';
import { readSettingsFile } from '../../web/engine/report/settings_reader';
import { createGltfIo } from '../../web/engine/document/gltf_io';
import { addMesh, glbFile, primitiveOf, readGlb, startDocument } from './support/gltf';
import { grid, toObj, torus } from './support/shapes';

let folder: string;
const path = (name: string) => join(folder, name);
const bytes = (name: string) => new Uint8Array(readFileSync(path(name)));
const text = (name: string) => readFileSync(path(name), 'utf8');
const settingsIn = (name: string): SettingsFile => readSettingsFile(name, text(name));

/** Runs a command in this process, in the folder of the files. */
async function run(...words: string[]): Promise<number> {
  const named = words.map((word) => (/\.(obj|glb|json|txt)$/.test(word) ? path(word) : word));
  const args = parseArguments([...named, '--quiet']) as Arguments;
  return args.command === 'tune' ? runTune(args) : runOptimize(args);
}

async function failureOf(...words: string[]): Promise<string> {
  try {
    await run(...words);
  } catch (error) {
    return describeFailure(error).line;
  }
  return '';
}

/** A bent sheet: no direction is free of stiffness. */
function wave(n: number): TriangleMesh {
  const mesh = grid(n, n);
  const side = Math.max(...mesh.positions);
  for (let i = 0; i < mesh.positions.length; i += 3)
    mesh.positions[i + 2] =
      0.2 * side * Math.sin((2 * mesh.positions[i]) / side + mesh.positions[i + 1] / side);
  return mesh;
}

/** An OBJ of two bent sheets, a coarser one beside the first. */
function twoWaves(): string {
  const [first, second] = [wave(12), wave(8)];
  const positions = second.positions.map((x) => x + 5);
  const triangles = second.triangles.map((v) => v + first.positions.length / 3);
  return `o first\n${toObj(first)}o second\n${toObj({ positions, triangles })}`;
}

/** A torus that no rotation takes to itself, so that its modes come one by one. */
function unevenTorus(): TriangleMesh {
  const mesh = torus();
  for (let i = 0; i < mesh.positions.length; i += 3) mesh.positions[i] *= 1.3 + 0.2 * mesh.positions[i + 1];
  return mesh;
}

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'limber-tune-'));
  writeFileSync(path('torus.obj'), toObj(unevenTorus()));
  writeFileSync(path('wave.obj'), toObj(wave(12)));
});

afterAll(() => rmSync(folder, { recursive: true, force: true }));

describe('limber optimize --solver springs', () => {
  let file: SettingsFile;
  let body: BodySettings;
  beforeAll(async () => {
    const flags = [
      '--ratio',
      '0.4',
      '--max-deviation',
      '0',
      '--solver',
      'springs',
      '--settings',
      'out.json',
      '--report',
      'report.json',
    ];
    expect(await run('optimize', 'torus.obj', 'out.glb', ...flags, '--threads', '1')).toBe(0);
    file = settingsIn('out.json');
    [body] = file.bodies;
  });

  it('writes masses with the sum of the original, and the factors that the constants have', () => {
    expect(sum(body.mass.perVertex) / body.original.totalMass).toBeCloseTo(1, 6);
    expect(body.mass.perVertex).toHaveLength(body.mesh.positions.length / 3);
    for (const kind of ['stretch', 'bend'] as const) {
      const factor = body[kind].constant / body.original[kind];
      expect(factor).toBeGreaterThanOrEqual(0.1 - 1e-9);
      expect(factor).toBeLessThanOrEqual(10 + 1e-9);
      expect(file.engine[kind]).toBe(body[kind].constant);
    }
    expect(body.stretch.pairs).toHaveLength((2 * 3 * body.mesh.triangles.length) / 6);
  });

  it('brings the frequencies nearer to the original, or keeps factors of 1', () => {
    const { errorTuned, errorUntouched } = file.frequencies;
    if (file.motion?.kept === 'untouched')
      expect(body.stretch.constant).toBeCloseTo(body.original.stretch, 6);
    else expect(errorTuned!).toBeLessThan(0.6 * errorUntouched!);
    expect(file.motion!.noiseFloor).toBeGreaterThanOrEqual(0);
  });

  it('writes a valid GLB whose vertices are those of the solver', async () => {
    expect(await validateGlb(bytes('out.glb'))).toMatchObject({ errors: 0, warnings: 0 });
    const [mesh] = (await readGlb(bytes('out.glb'))).getRoot().listMeshes();
    const [primitive] = mesh.listPrimitives();
    const positions = primitive.getAttribute('POSITION')!.getArray()!;
    const masses = primitive.getAttribute('_LIMBER_MASS')!.getArray()!;
    expect(body.renderVertices).toHaveLength(positions.length / 3);
    body.renderVertices.forEach((vertex, i) => {
      const mass = body.mass.perVertex[vertex];
      expect(Math.abs(masses[i] - mass)).toBeLessThan(1e-6 * mass);
      for (let c = 0; c < 3; ++c)
        expect(Math.fround(body.mesh.positions[3 * vertex + c])).toBe(positions[3 * i + c]);
    });
    const { limberSettings } = mesh.getExtras() as { limberSettings: Partial<BodySettings> };
    expect(limberSettings).toMatchObject({ engine: body.engine, substeps: body.substeps });
  });

  it('reports the errors', () => {
    const report = JSON.parse(text('report.json')) as Report;
    expect(report.schema).toBe('limber-report/2');
    const found = report.fidelity!.solvers!.springs!;
    expect(found.frequencies.errorTuned).toBeCloseTo(file.frequencies.errorTuned!, 6);
    expect(report.timings.tune).toBeGreaterThan(0);
  });

  it('writes the same bytes again, on any number of threads', async () => {
    const flags = ['--ratio', '0.4', '--max-deviation', '0', '--solver', 'springs'];
    expect(
      await run('optimize', 'torus.obj', 'two.glb', ...flags, '--settings', 'two.json', '--threads', '2'),
    ).toBe(0);
    expect(text('two.json')).toBe(text('out.json'));
    expect(bytes('two.glb')).toEqual(bytes('out.glb'));
  });

  it('writes what limber tune finds for the same two meshes', async () => {
    expect(await run('tune', 'torus.obj', 'out.glb', '--solver', 'springs', '--settings', 'tuned.json')).toBe(
      0,
    );
    const again = settingsIn('tuned.json');
    expect(again.frequencies.errorUntouched).toBeCloseTo(file.frequencies.errorUntouched!, 4);
    expect(again.bodies[0].stretch.constant / body.stretch.constant).toBeCloseTo(1, 3);
    expect(again.bodies[0].bend.constant / body.bend.constant).toBeCloseTo(1, 3);
  });
});

describe('a compressed file', () => {
  it.each(['quantized', 'meshopt'])('has positions where the settings have them: %s', async (kind) => {
    const flags = ['--ratio', '0.5', '--solver', 'jolt', '--compress', kind, '--settings', 'c.json'];
    expect(await run('optimize', 'wave.obj', 'c.glb', ...flags)).toBe(0);
    const [body] = settingsIn('c.json').bodies;
    const io = await createGltfIo(['EXT_meshopt_compression']);
    const [mesh] = (await io.readBinary(bytes('c.glb'))).getRoot().listMeshes();
    const positions = mesh.listPrimitives()[0].getAttribute('POSITION')!.getArray()!;
    body.renderVertices.forEach((vertex, i) => {
      for (let c = 0; c < 3; ++c)
        expect(Math.fround(body.mesh.positions[3 * vertex + c])).toBe(positions[3 * i + c]);
    });
  });
});

describe('pins', () => {
  it('are carried over to results and to coarse meshes of other tools alike', async () => {
    const flags = ['--solver', 'hinge-shell', '--pins', 'low:20'];
    expect(
      await run('optimize', 'wave.obj', 'w.glb', '--ratio', '0.5', ...flags, '--settings', 'w.json'),
    ).toBe(0);
    expect(await run('tune', 'wave.obj', 'w.glb', ...flags, '--settings', 'w2.json')).toBe(0);
    const [first, second] = ['w.json', 'w2.json'].map((name) => settingsIn(name).bodies[0]);
    const pinned = ({ pins, mesh: { positions } }: BodySettings) =>
      pins.map((v) => positions.slice(3 * v, 3 * v + 3).join(' ')).sort();
    expect(pinned(first).length).toBeGreaterThan(3);
    expect(pinned(second)).toEqual(pinned(first));
  });
});

describe('further levels', () => {
  it('have settings of their own', async () => {
    const flags = ['--ratio', '0.6', '--lods', '0.4,0.25', '--solver', 'jolt', '--settings', 'lods.json'];
    expect(await run('optimize', 'wave.obj', 'lods.glb', ...flags)).toBe(0);
    const { bodies } = settingsIn('lods.json');
    expect(bodies.map(({ level }) => level)).toEqual([0, 1, 2]);
    for (const { mass, original } of bodies)
      expect(sum(mass.perVertex) / original.totalMass).toBeCloseTo(1, 6);
    const [mesh] = (await readGlb(bytes('lods_lod2.glb'))).getRoot().listMeshes();
    const { limberSettings } = mesh.getExtras() as { limberSettings: Partial<BodySettings> };
    expect(limberSettings.engine).toEqual(bodies[2].engine);
    expect(bodies.map(({ meshNumber }) => meshNumber)).toEqual([0, 0, 0]);
  });

  it.each(['nodes', 'msft'])(
    'inside one file as %s are found by the numbers of their meshes',
    async (style) => {
      writeFileSync(path('two.obj'), twoWaves());
      const flags = ['--ratio', '0.6', '--lods', '0.4,0.25', '--lod-style', style, '--solver', 'jolt'];
      expect(await run('optimize', 'two.obj', 'in.glb', ...flags, '--settings', 'in.json')).toBe(0);
      const { bodies } = settingsIn('in.json');
      const meshes = (await readGlb(bytes('in.glb'))).getRoot().listMeshes();
      const numbers = bodies.map(({ meshNumber }) => meshNumber!);
      expect(numbers.toSorted((a, b) => a - b)).toEqual([...meshes.keys()]);
      bodies.forEach(({ name, level, engine, renderVertices }, i) => {
        const mesh = meshes[numbers[i]];
        expect(mesh.getName()).toBe(level === 0 ? name : `${name}_LOD${level}`);
        expect((mesh.getExtras().limberSettings as BodySettings).engine).toEqual(engine);
        const [primitive] = mesh.listPrimitives();
        expect(primitive.getAttribute('POSITION')!.getCount()).toBe(renderVertices.length);
      });
    },
  );
});

describe('a map of factors', () => {
  it('is written as attributes if requested', async () => {
    const flags = ['--ratio', '0.5', '--solver', 'newton', '--tune', 'vertex', '--settings', 'map.json'];
    expect(await run('optimize', 'torus.obj', 'map.glb', ...flags)).toBe(0);
    const [body] = settingsIn('map.json').bodies;
    const [primitive] = (await readGlb(bytes('map.glb'))).getRoot().listMeshes()[0].listPrimitives();
    const bend = primitive.getAttribute('_LIMBER_BEND')!.getArray()!;
    body.renderVertices.forEach((v, i) => expect(bend[i]).toBeCloseTo(body.vertex!.bend[v], 5));
  });
});

describe('the user’s own parameters', () => {
  it('can come from a file instead of the flag', async () => {
    writeFileSync(path('mine.txt'), 'young = 3e5 # soft\nthickness=0.02\n');
    writeFileSync(path('mine.json'), '{ "young": 3e5, "thickness": 0.02 }');
    const of = (value: string) =>
      (
        parseArguments([
          'tune',
          'a',
          'b',
          '--solver',
          'mujoco',
          '--settings',
          's',
          '--engine',
          value,
        ]) as Arguments
      ).settings.engine;
    expect(of(path('mine.txt')).replaceAll(' ', '')).toBe('young=3e5,thickness=0.02');
    expect(of(path('mine.json'))).toBe('young=300000,thickness=0.02');
    expect(of('young=3e5')).toBe('young=3e5');
  });
});

describe('meshes that cannot be tuned are refused with one sentence:', () => {
  it.each([
    [
      ['optimize', 'torus.obj', 'x.glb', '--settings', 'x.json'],
      /^--settings needs a solver: --solver shell\|/,
    ],
    [
      ['tune', 'torus.obj', 'wave.obj', '--settings', 'x.json'],
      /^limber tune needs a solver: --solver shell\|/,
    ],
    [
      ['tune', 'torus.obj', 'wave.obj', '--solver', 'jolt'],
      /^limber tune needs a file for what it finds: --settings FILE\.$/,
    ],
    [
      ['optimize', 'torus.obj', 'x.glb', '--solver', 'jolt', '--engine', 'stiffness=2'],
      /^--engine names stiffness, which jolt does not have: it has compliance, bendCompliance, /,
    ],
    [
      ['tune', 'wave.obj', 'torus.obj', '--solver', 'jolt', '--settings', 'x.json'],
      /faces in wave\.obj and .* in torus\.obj: name the original first\.$/,
    ],
  ])('%j', async (words, sentence) => {
    expect(await failureOf(...words)).toMatch(sentence);
  });

  it('a mesh of something else, elsewhere, or of another size', async () => {
    const scaled = torus(10, 6);
    scaled.positions.forEach((value, i) => (scaled.positions[i] = 3 * value));
    writeFileSync(path('scaled.obj'), toObj(scaled));
    writeFileSync(path('sheet.obj'), toObj(grid(3, 3)));
    for (const other of ['scaled.obj', 'sheet.obj'])
      expect(await failureOf('tune', 'torus.obj', other, '--solver', 'jolt', '--settings', 'x.json')).toMatch(
        /^[^.]+\.?[^.]*(original|place and pose)/,
      );
  });

  it('one of several bodies, by its name', async () => {
    const small = torus(10, 6);
    small.positions.forEach((value, i) => (small.positions[i] = 3 * value));
    const [document, coarse] = [startDocument(), startDocument()];
    for (const [name, mesh] of [['ring', torus()], ['band', torus()]] as const) addMesh(document, name, [primitiveOf(document, mesh)]); // prettier-ignore
    for (const [name, mesh] of [['ring', torus(10, 6)], ['band', small]] as const) addMesh(coarse, name, [primitiveOf(coarse, mesh)]); // prettier-ignore
    writeFileSync(path('two.glb'), (await glbFile(document)).bytes);
    writeFileSync(path('two_coarse.glb'), (await glbFile(coarse)).bytes);
    const words = ['tune', 'two.glb', 'two_coarse.glb', '--solver', 'jolt', '--settings', 'x.json'];
    expect(await failureOf(...words)).toMatch(
      /^"band": The coarse mesh is .* times as large as the original/,
    );
  });
});
