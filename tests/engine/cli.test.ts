import { spawnSync } from 'node:child_process';
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { validateGlb } from '../../web/engine/document/validate';
import { readBinding } from '../../web/engine/report/binding_file';
import type { Report } from '../../web/engine/report/report';
import { sum } from '../../web/engine/core/mesh';
import { VERSION } from '../../web/engine/core/version';
import { SQUARE_OBJ } from './support/files';
import { addMesh, glbFile, moveNode, primitiveOf, readGlb, startDocument } from './support/gltf';
import { box, grid, toObj, torus } from './support/shapes';
import { together } from './support/bodies';

const program = new URL('../../dist/cli/limber.mjs', import.meta.url).pathname;
let folder: string;

/** Runs limber in the folder of the test files. */
function limber(...args: string[]) {
  const { status, stdout, stderr } = spawnSync(process.execPath, [program, ...args], {
    cwd: folder,
    encoding: 'utf8',
  });
  return { code: status, stdout, stderr };
}

const path = (name: string) => join(folder, name);
const report = (text: string) => JSON.parse(text) as Report;

beforeAll(() => {
  if (!existsSync(program)) throw new Error('dist/cli/limber.mjs is missing: run npm run build first.');
  folder = mkdtempSync(join(tmpdir(), 'limber-test-'));
  mkdirSync(path('folder'));
  writeFileSync(path('torus.obj'), toObj(torus()));
  writeFileSync(path('grid.obj'), toObj(grid(8, 8)));
  writeFileSync(path('square.obj'), SQUARE_OBJ);
  writeFileSync(path('bad.obj'), 'v 0 0 nan\nf 1 1 1\n');
  const two = toObj(together(torus(), grid(8, 8)));
  const lines = two.split('\n');
  const firstOfGrid = lines.filter((line) => line.startsWith('v')).length + torus().triangles.length / 3;
  lines.splice(firstOfGrid, 0, 'o sheet');
  writeFileSync(path('two.obj'), `o ring\n${lines.join('\n')}`);
});

afterAll(() => rmSync(folder, { recursive: true, force: true }));

describe('limber optimize', () => {
  it('writes a GLB and sums up the result in one line', async () => {
    const { code, stdout, stderr } = limber('optimize', 'torus.obj', 'out.glb', '--fit', 'modal');
    expect([code, stderr]).toEqual([0, '']);
    expect(stdout).toMatch(
      /^torus\.obj: 576 -> 288 faces \(-50\.0 %\), topology kept, deviation \d+\.\d\d % \(mean \d+\.\d\d %\), smallest angle \d+\.\d deg, frequencies off \d+\.\d\d % \(\d+\.\d\d % before the fit\), \d+\.\d s -> out\.glb\n$/,
    );
    expect(await validateGlb(readFileSync(path('out.glb')))).toMatchObject({ errors: 0, warnings: 0 });
  });

  it('gives the same bytes on any number of threads', () => {
    const bytes = ['1', '2', '3'].map((threads) => {
      expect(limber('optimize', 'two.obj', `${threads}.glb`, '--threads', threads, '--fields').code).toBe(0);
      return readFileSync(path(`${threads}.glb`));
    });
    expect(bytes[1].equals(bytes[0])).toBe(true);
    expect(bytes[2].equals(bytes[0])).toBe(true);
  });

  it('prints nothing but the report to stdout with --report - and with --json', () => {
    for (const flags of [['--report', '-'], ['--json'], ['--json', '--report=-']]) {
      const { code, stdout } = limber(
        'optimize',
        'torus.obj',
        'out.glb',
        '--faces',
        '200',
        '--max-deviation',
        '0',
        ...flags,
      );
      expect(code).toBe(0);
      const { schema, version, command, options, input, output, stop, surface, timings, ...others } =
        report(stdout);
      expect([schema, version, command]).toEqual(['limber-report/1', VERSION, 'optimize']);
      expect(options).toMatchObject({
        faces: 200,
        method: 'limber',
        model: 'auto',
        modes: [1, 2, 3, 4, 5, 6],
        fields: false,
      });
      expect(options).not.toHaveProperty('ratio');
      expect(input).toMatchObject({ faces: 576, vertices: 288, genus: 1, components: 1, boundaryLoops: 0 });
      expect(output!.faces).toBeLessThanOrEqual(200);
      expect(output!.genus).toBe(1);
      expect(stop!.reason).toBe('target');
      expect(surface!.hausdorff).toBeGreaterThanOrEqual(surface!.mean);
      expect(Object.keys(timings)).toEqual(
        expect.arrayContaining(['load', 'modes', 'fields', 'simplify', 'export']),
      );
      expect(Object.keys(others).sort()).toEqual(
        ['components', 'fit', 'model', 'modes', 'peakHeapBytes', 'solve', 'threads', 'zeroModes'].sort(),
      );
      expect(others.zeroModes).toEqual({ expected: 6, found: 6 });
      for (const { residual } of others.modes!) expect(residual).toBeLessThan(1e-7);
    }
  });

  it('writes the report to a file and still prints the summary', () => {
    const { stdout } = limber(
      'optimize',
      'torus.obj',
      'out.glb',
      '--method',
      'qem',
      '--report',
      'report.json',
    );
    expect(stdout).toMatch(/^torus\.obj: /);
    const written = report(readFileSync(path('report.json'), 'utf8'));
    expect(written.options.ratio).toBe(0.5);
    expect(written).not.toHaveProperty('modes');
  });

  it('prints nothing with --quiet', () => {
    expect(limber('optimize', 'two.obj', 'out.glb', '--quiet')).toEqual({ code: 0, stdout: '', stderr: '' });
  });

  it('writes OUT, gives the reason and exits with 2 if the target cannot be reached', () => {
    const { code, stdout, stderr } = limber(
      'optimize',
      'torus.obj',
      'floor.glb',
      '--faces',
      '1',
      '--max-deviation',
      '0',
      '--quiet',
      '--json',
    );
    expect(code).toBe(2);
    expect(stderr).toMatch(
      /^limber: Stopped at \d+ faces, not 1: of the remaining edges \d+ % would .*\.\n$/,
    );
    expect(report(stdout).stop!.reason).toBe('exhausted');
    expect(existsSync(path('floor.glb'))).toBe(true);
  });

  it('says how to go further if seams stop it, and goes further with that option', () => {
    // Every face has its own part of the texture.
    const lines = toObj(torus()).trim().split('\n');
    const faces = lines.filter((line) => line.startsWith('f'));
    const own = faces.map((line, t) => {
      const [a, b, c] = line.split(' ').slice(1);
      const [u, v] = [(t % 24) / 24, Math.floor(t / 24) / 24];
      const uvs = [
        [u, v],
        [u + 0.04, v],
        [u, v + 0.04],
      ];
      const texture = uvs.map((uv) => `vt ${uv.join(' ')}`).join('\n');
      return `${texture}\nf ${a}/${3 * t + 1} ${b}/${3 * t + 2} ${c}/${3 * t + 3}`;
    });
    writeFileSync(path('quilt.obj'), [...lines.filter((line) => line.startsWith('v')), ...own].join('\n'));
    const kept = limber('optimize', 'quilt.obj', 'out.glb', '--ratio', '0.25');
    expect(kept.code).toBe(2);
    expect(kept.stderr).toMatch(
      /Stopped at 576 faces, not 144: .* 100 % break a seam, a border or a lock; --seams cross lets collapses cross seams\.\n$/,
    );
    const level = limber('optimize', 'quilt.obj', 'out.glb', '--ratio', '1', '--lods', '0.25');
    expect(level.stderr).toMatch(
      /out_lod1\.glb: Stopped at 576 faces, not 144: .*; --seams cross lets collapses cross seams\.\n$/,
    );
    const crossed = limber(
      ...'optimize quilt.obj out.glb --ratio 0.25 --max-deviation 0 --seams cross'.split(' '),
    );
    expect(crossed.code).toBe(0);
    expect(crossed.stdout).toMatch(/^quilt\.obj: 576 -> 144 faces/);
  });

  it('distributes --faces over bodies in proportion and uses the larger of two targets', () => {
    const faces = (...flags: string[]) =>
      report(limber('optimize', 'two.obj', 'out.glb', '--json', ...flags).stdout).output!.faces;
    expect(faces('--faces', '352')).toBeGreaterThan(345);
    expect(faces('--faces', '352')).toBeLessThanOrEqual(352);
    expect(faces('--faces', '352', '--ratio', '0.25')).toBe(faces('--faces', '352'));
    expect(faces('--faces', '50', '--ratio', '0.5')).toBe(faces('--ratio', '0.5'));
    expect(faces('--ratio', '1')).toBe(704);
  });

  it('accepts a largest deviation as the only target', () => {
    const { code, stdout } = limber('optimize', 'torus.obj', 'near.glb', '--max-deviation', '0.5', '--json');
    expect(code).toBe(0);
    const { options, output, surface, stop } = report(stdout);
    expect(options).not.toHaveProperty('ratio');
    expect(stop!.reason).toBe('deviation');
    expect(stop!.guarded).toEqual([
      { body: 'torus', faces: output!.faces, limit: 0.5, deviation: expect.any(Number) as number },
    ]);
    expect(stop!.guarded![0].deviation).toBeLessThanOrEqual(0.5);
    expect(surface!.hausdorff).toBeLessThanOrEqual(0.5);
    expect(output!.faces).toBeLessThan(576);
  });

  it('gives the faces of one body that stopped at the largest deviation, and counts the others', () => {
    const twice = toObj(together(torus(), torus(30, 15))).split('\n');
    const first = twice.findIndex((line) => line.startsWith('f')) + torus().triangles.length / 3;
    twice.splice(first, 0, 'o other');
    writeFileSync(path('rings.obj'), `o ring\n${twice.join('\n')}`);
    const { stderr } = limber('optimize', 'rings.obj', 'few.glb', '--faces', '20', '--method', 'qem');
    expect(stderr).toMatch(
      /stopped at \d+ faces, [\d.]+ % of its diagonal from the original, and 1 other body stopped at that limit, too: the next/,
    );
  });

  it('accepts a smallest angle as the only target', () => {
    const words = 'optimize torus.obj round.glb --min-angle 25 --max-deviation 0 --json';
    const { code, stdout } = limber(...words.split(' '));
    expect(code).toBe(0);
    const { input, output, stop } = report(stdout);
    expect(stop!.reason).toBe('angle');
    expect(output!.minAngle!).toBeGreaterThanOrEqual(Math.min(25, input.minAngle!) - 1e-4);
  });

  it('accepts a largest frequency error as the only target and reports what it found', () => {
    const words = 'optimize torus.obj true.glb --max-frequency-error 4 --fit off --report true.json';
    const { code, stdout } = limber(...words.split(' '));
    expect(code).toBe(0);
    const { options, output, stop, timings } = report(readFileSync(path('true.json'), 'utf8'));
    expect(options).not.toHaveProperty('ratio');
    expect(stop).toMatchObject({ reason: 'frequency', frequency: { limit: 4 } });
    const { error, beyond, tried } = stop!.frequency!;
    expect(stdout).toContain(
      `, frequencies within ${error.toFixed(2)} % of 4 % (${beyond!.faces} faces: ${beyond!.error.toFixed(2)} %), `,
    );
    expect(beyond!.faces).toBeGreaterThan(0.95 * output!.faces);
    expect(tried).toBeGreaterThan(3);
    expect(timings.search).toBeGreaterThan(0);
    const compared = report(limber(...'compare torus.obj true.glb --modes 6 --json'.split(' ')).stdout);
    expect(compared.fidelity!.frequencyErrorMax).toBeCloseTo(error, 4);
    expect(error).toBeLessThanOrEqual(4);
  });

  it('writes a file for each level of --lods, from the same history', async () => {
    const words =
      'optimize two.obj chain.glb --ratio 0.8 --lods 0.5,0.25 --method qem --max-deviation 0 --report chain.json';
    const { code, stdout } = limber(...words.split(' '));
    expect(code).toBe(0);
    const { output, levels } = report(readFileSync(path('chain.json'), 'utf8'));
    expect(levels!.map(({ file, ratio }) => [file, ratio])).toEqual([
      ['chain_lod1.glb', 0.5],
      ['chain_lod2.glb', 0.25],
    ]);
    const lines = stdout.trim().split('\n');
    expect(lines).toHaveLength(3);
    for (const [i, { file, ratio, output: level, surface, stop }] of levels!.entries()) {
      expect(level.faces).toBeLessThanOrEqual(704 * ratio);
      expect(level.faces).toBeGreaterThan(704 * ratio - 6);
      expect([level.components, level.genus, stop.reason]).toEqual([2, 1, 'target']);
      expect(lines[i + 1]).toContain(
        `${file}: ${level.faces} faces, deviation ${surface.hausdorff.toFixed(2)} %`,
      );
      expect(await validateGlb(readFileSync(path(file)))).toMatchObject({ errors: 0, warnings: 0 });
    }
    expect(output!.faces).toBeGreaterThan(levels![0].output.faces);
    limber(...'optimize two.obj alone.glb --ratio 0.25 --method qem --max-deviation 0'.split(' '));
    expect(readFileSync(path('alone.glb')).equals(readFileSync(path('chain_lod2.glb')))).toBe(true);
  });

  it('calibrates the stiffness of every level with --calibrate', async () => {
    const words = 'optimize grid.obj soft.glb --method qem --lods 0.25 --calibrate --json';
    const { calibration } = report(limber(...words.split(' ')).stdout);
    const factorIn = async (name: string) => {
      const [mesh] = (await readGlb(readFileSync(path(name)))).getRoot().listMeshes();
      return mesh.getExtras().limberCalibration;
    };
    expect(await factorIn('soft.glb')).toBe(calibration![0].factor);
    expect(await factorIn('soft_lod1.glb')).toBeGreaterThan(0);
    expect(await factorIn('soft_lod1.glb')).not.toBe(calibration![0].factor);
  });

  it('reports a level that cannot be reached', () => {
    const words = 'optimize torus.obj chain.glb --method qem --lods 0.5,0.001 --max-deviation 0 --quiet';
    const { code, stderr } = limber(...words.split(' '));
    expect(code).toBe(2);
    expect(stderr).toMatch(
      /^limber: chain_lod2\.glb: Stopped at \d+ faces, not 1: of the remaining edges .*\.\n$/,
    );
  });

  it('warns if quads are cut along the other diagonal for a symmetry, and if there is no symmetry to keep', () => {
    const tellOf = (file: string) => {
      const { code, stderr } = limber('optimize', file, 'out.glb', '--method', 'qem', '--symmetry', 'z');
      expect(code).toBe(0);
      return stderr;
    };
    expect(tellOf('torus.obj')).toBe(
      'limber: 144 quads cut the other way, so that both sides are mirror images.\n',
    );
    expect(tellOf('grid.obj')).toBe(
      'limber: "grid" has no mirror symmetry across z to keep: 81 vertices would have no image.\n',
    );
  });

  it('fits to the modes with --fit modal, but not with --fit off', () => {
    const errorOf = (ratio: number, fit: string) => {
      const words = `optimize torus.obj fit.glb --ratio ${ratio} --max-deviation 0 --fit ${fit}`;
      expect(limber(...words.split(' ')).code).toBe(0);
      return report(limber('compare', 'torus.obj', 'fit.glb', '--json').stdout).fidelity!.frequencyErrorMean!;
    };
    // What a fit gains depends on the collapses before it: .44 to .6 of the error is left on this coarse torus.
    const meanOf = (fit: string) => sum([0.25, 0.3, 0.35].map((ratio) => errorOf(ratio, fit))) / 3;
    expect(meanOf('modal')).toBeLessThan(0.6 * meanOf('off'));
  });

  it('fits to the surface by default, which takes it nearer than --fit off, and says so', () => {
    const reduce = (...flags: string[]) => {
      const words = 'optimize torus.obj fit.glb --ratio 0.3 --max-deviation 0 --report fit.json'.split(' ');
      const { code, stdout } = limber(...words, ...flags);
      expect(code).toBe(0);
      return { stdout, ...report(readFileSync(path('fit.json'), 'utf8')) };
    };
    const [fitted, off] = [reduce(), reduce('--fit', 'off')];
    expect(fitted.surface!.mean).toBeLessThan(0.95 * off.surface!.mean);
    expect(fitted.fit).toEqual({ kind: 'surface', flips: fitted.fit!.flips });
    expect(off.fit).toBeUndefined();
    expect(fitted.stdout).toMatch(/, fitted to the surface \(\d+ edges? flipped\), /);
  });

  it('takes --fit on of version 0.1 for --fit modal, and says so', () => {
    const bytesOf = (fit: string) => {
      const words = `optimize torus.obj fit.glb --ratio 0.3 --max-deviation 0 --fit ${fit}`;
      const { code, stderr } = limber(...words.split(' '));
      expect(code).toBe(0);
      return { stderr, bytes: readFileSync(path('fit.glb')) };
    };
    const [former, modal] = [bytesOf('on'), bytesOf('modal')];
    expect(former.bytes.equals(modal.bytes)).toBe(true);
    expect(modal.stderr).toBe('');
    expect(former.stderr).toBe('limber: --fit on of earlier versions is now modal (default: surface).\n');
  });

  it('optimizes only the body of --mesh', async () => {
    const { stdout } = limber('optimize', 'two.obj', 'one.glb', '--mesh', 'sheet', '--json');
    const { input, output } = report(stdout);
    expect(input.faces).toBe(128);
    expect(output!.faces).toBeLessThanOrEqual(64);
    expect(output!.faces).toBeGreaterThan(60);
    const meshes = (await readGlb(readFileSync(path('one.glb')))).getRoot().listMeshes();
    const faces = meshes.map((mesh) => mesh.listPrimitives()[0].getIndices()!.getCount() / 3);
    expect(meshes.map((mesh) => mesh.getName())).toEqual(['ring', 'sheet']);
    expect(faces).toEqual([576, output!.faces]);
    expect(limber('optimize', 'two.obj', 'one.glb', '--mesh', 'sheets')).toEqual({
      code: 1,
      stdout: '',
      stderr: 'limber: two.obj has no body "sheets": it has "ring", "sheet".\n',
    });
  });

  it('binds every original vertex to the optimized mesh with --bind', () => {
    const words = 'optimize two.obj two.glb --ratio 0.3 --max-deviation 0 --bind two.json';
    expect(limber(...words.split(' ')).code).toBe(0);
    const bodies = readBinding('two.json', readFileSync(path('two.json'), 'utf8'));
    expect(bodies.map(({ name, mesh, binding }) => [name, mesh, binding.triangle.length])).toEqual([
      ['ring', 0, 288],
      ['sheet', 1, 81],
    ]);
    for (const { faces, binding } of bodies)
      for (const triangle of binding.triangle) expect(triangle).toBeLessThan(faces);
    expect(limber('optimize', 'torus.obj', 'a.glb', '--bind', 'none/a.json').stderr).toBe(
      'limber: The folder none does not exist: create it first.\n',
    );
  });

  it('carries fields with --fields', async () => {
    limber(
      'optimize',
      'torus.obj',
      'fields.glb',
      '--fields',
      '--model',
      'shell',
      '--mode',
      '1,2',
      '--p',
      'inf',
    );
    const [mesh] = (await readGlb(readFileSync(path('fields.glb')))).getRoot().listMeshes();
    expect(mesh.listPrimitives()[0].listSemantics()).toEqual(['POSITION', 'NORMAL', '_STRAIN', '_CURVATURE']);
  });

  it('leaves an old OUT unchanged and no other file if it fails', () => {
    writeFileSync(path('old.glb'), 'precious');
    expect(limber('optimize', 'bad.obj', 'old.glb').code).toBe(1);
    expect(readFileSync(path('old.glb'), 'utf8')).toBe('precious');
    expect(readdirSync(folder).filter((name) => name.endsWith('.part'))).toEqual([]);
  });
});

describe('limber simulate', () => {
  it('calibrates the second body by the factor that optimize writes for engines', async () => {
    const { stdout } = limber(
      'optimize',
      'torus.obj',
      'soft.glb',
      ...'--method qem --calibrate --json'.split(' '),
    );
    const [{ body, factor }] = report(stdout).calibration!;
    expect(factor).not.toBeCloseTo(1, 3);
    const document = await readGlb(readFileSync(path('soft.glb')));
    const [mesh] = document.getRoot().listMeshes();
    expect(mesh.getExtras()).toEqual({ limberCalibration: factor });
    const words = 'simulate torus.obj soft.glb --calibrate --seconds 0.1 --colliders ground:-9 --json';
    const simulated = report(limber(...words.split(' ')).stdout);
    expect(simulated.calibration).toEqual([{ body, factor: expect.closeTo(factor, 9) as number }]);
    expect(simulated.options).toMatchObject({ calibrate: true, colliders: 'ground:-9', friction: 0.5 });
  });

  it('simulates a body and reports the cost', () => {
    const { code, stdout, stderr } = limber('simulate', 'grid.obj', '--scenario', 'hang', '--seconds', '0.2');
    expect([code, stderr]).toEqual([0, '']);
    expect(stdout).toMatch(
      /^scenario +hang, 0\.2 s, solid where closed, 20 substeps, grid\ngrid\.obj +256 constraints, 208 edges, \S+ ms a step, \S+ ns a constraint\n$/,
    );
    expect(limber(...'simulate grid.obj --seconds 0.05 --unit 1000'.split(' ')).stderr).toMatch(
      /^limber: grid: the body is .* km across: set --unit if the file is not in metres\.\n$/,
    );
  });

  it('moves closed bodies as solids, and calibrated ones as shells', () => {
    writeFileSync(path('bar.obj'), toObj(box(4, 4, 12)));
    const madeOf = (words: string): string[] =>
      limber(...`simulate ${words} --scenario sway --seconds 0.05`.split(' '))
        .stdout.split(/, +/)
        .slice(0, 3);
    expect(madeOf('bar.obj')).toEqual(['scenario  sway', '0.05 s', 'solid where closed']);
    const constraintsOf = (words: string): number =>
      report(limber(...`simulate bar.obj --seconds 0.05 --json ${words}`.trim().split(' ')).stdout)
        .simulation!.original.constraints;
    expect(constraintsOf('')).toBe(constraintsOf('--material=solid'));
    expect(constraintsOf('')).not.toBe(constraintsOf('--material=shell'));
    expect(madeOf('bar.obj bar.obj --calibrate')[2]).toBe('shell');
  });

  it('reports how much two bodies deviate, next to the noise floor', () => {
    limber('optimize', 'torus.obj', 'half.glb', '--quiet');
    const words = 'simulate torus.obj half.glb --scenario sway --material springs --seconds 0.3 --json';
    const { code, stdout } = limber(...words.split(' '));
    expect(code).toBe(0);
    const { simulation, output, options } = report(stdout);
    expect(output!.faces).toBe(288);
    expect(options).toMatchObject({ scenario: 'sway', material: 'springs', seconds: 0.3, substeps: 20 });
    expect(simulation).toMatchObject({
      material: 'springs',
      scenario: 'sway',
      substeps: 20,
      original: { constraints: 864, edges: 864 },
      optimized: { constraints: 432, edges: 432 },
      edgeRatio: 2,
    });
    const { mean, max, noiseFloor } = simulation!.deviation!;
    expect(noiseFloor).toBeLessThan(mean);
    expect(mean).toBeLessThan(max);
  });

  it('records the motion of both as a GLB without errors', async () => {
    limber(...'optimize torus.obj half.glb --bind half.json --quiet'.split(' '));
    const words =
      'simulate torus.obj half.glb --scenario twist --seconds 0.2 --bind half.json --record motion.glb';
    expect(limber(...words.split(' ')).code).toBe(0);
    const bytes = readFileSync(path('motion.glb'));
    expect(await validateGlb(bytes)).toMatchObject({ errors: 0, warnings: 0 });
    const document = (await readGlb(bytes)).getRoot();
    expect(document.listMeshes().map((mesh) => mesh.listPrimitives()[0].listTargets().length)).toEqual([
      12, 12,
    ]);
    expect(document.listAnimations()[0].listChannels()).toHaveLength(2);
  });

  it('accepts pins in the same syntax as the other commands', () => {
    const { code, stdout } = limber(
      ...'simulate torus.obj torus.obj --pins high:10 --seconds 0.1 --json'.split(' '),
    );
    expect(code).toBe(0);
    expect(report(stdout).simulation!.deviation).toMatchObject({ mean: 0, max: 0 });
  });

  it('warns where pins leave nothing that the scenario could move', () => {
    const warned = (words: string): string =>
      limber(...`simulate torus.obj --seconds 0.1 ${words}`.trim().split(' ')).stderr;
    expect(warned('--scenario pull --pins low:10')).toContain(
      'nothing moves: --scenario pull moves pins of the upper half, and --pins has none there',
    );
    expect(warned('--scenario pull --pins low:10+high:10')).toBe('');
    expect(warned('--scenario sway --pins low:10')).toBe('');
  });
});

describe('a wrong command line', () => {
  it.each([
    [
      '',
      'There is no command "": use optimize, batch, tune, modes, compare, simulate, inspect (limber --help).',
    ],
    ['optimise', 'There is no command "optimise": did you mean "optimize"?'],
    [
      'optimize',
      'IN is missing: give the model to read, as in limber optimize IN OUT (options: limber help optimize).',
    ],
    [
      'optimize torus.obj',
      'OUT is missing: give the file to write, as in limber optimize torus.obj OUT (options: limber help optimize).',
    ],
    [
      'batch src',
      'OUT is missing: give the folder for the results, as in limber batch src OUT (options: limber help batch).',
    ],
    ['optimize torus.obj a.glb b.glb', '"b.glb" is one file too many: limber optimize IN OUT.'],
    [
      'optimize torus.obj a.stl',
      'a.stl does not end in the name of a format that can be written: give a name that ends in .glb, .gltf, .obj, .ply or .zip.',
    ],
    ['optimize torus.obj none/a.glb', 'The folder none does not exist: create it first.'],
    ['optimize none.obj a.glb', 'none.obj cannot be read: there is no such file.'],
    ['optimize folder a.glb', 'folder is a folder: give the model file in it.'],
    ['optimize bad.obj a.glb', 'bad.obj, line 1: z is nan, not a finite number.'],
    ['optimize torus.obj a.glb --ratoi 0.5', 'limber optimize has no --ratoi: did you mean --ratio?'],
    [
      'optimize torus.obj a.glb --substance',
      'limber optimize has no --substance: see limber optimize --help.',
    ],
    ['optimize torus.obj a.glb --ratio', '--ratio needs a value: --ratio R.'],
    ['optimize torus.obj a.glb --ratio --json', '--ratio needs a value: --ratio R.'],
    ['optimize torus.obj a.glb --engine', '--engine needs a value: --engine FILE|NAME=VALUE,...'],
    ['optimize torus.obj a.glb --ratio 2', '--ratio is 2: give a number above 0 and up to 1.'],
    ['optimize torus.obj a.glb --faces 0', '--faces is 0: give a whole number of at least 1.'],
    ['optimize torus.obj a.glb --json=yes', '--json takes no value.'],
    [
      'optimize torus.obj a.glb --poisson half',
      '--poisson is half: give a number from -0.99 to 0.49 (default: 0.3).',
    ],
    [
      'optimize torus.obj a.glb --mode 1,x',
      '--mode is 1,x: give auto, all, or numbers from 1 to 100 separated by commas (default: auto).',
    ],
    [
      'modes grid.obj --model solid',
      'Part 1 of the mesh is not closed, so it has no inside for the solid model: close its holes, or use the model shell or auto.',
    ],
    [
      'modes torus.obj --material-preset wood',
      '--material-preset is wood: give one of rubber, foam, cotton, silk, leather, paper.',
    ],
    ['modes torus.obj --direction w', '--direction is w: give one of all, x, y, z (default: all).'],
    [
      'modes torus.obj --pins low',
      '--pins has "low": give low:PCT, high:PCT, box:x0,y0,z0,x1,y1,z1, attribute:NAME or vertices:i,j, joined by +.',
    ],
    [
      'optimize torus.obj a.glb --max-frequency-error -1',
      '--max-frequency-error is -1: give a number from 0 to 100 (default: 0).',
    ],
    [
      'optimize torus.obj a.glb --lods 0.5,0',
      '--lods is 0.5,0: give numbers from 0.0001 to 1 separated by commas (default: none).',
    ],
    [
      'optimize torus.obj a.glb --lock low',
      '--lock has "low": give low:PCT, high:PCT, box:x0,y0,z0,x1,y1,z1, attribute:NAME or vertices:i,j, joined by +.',
    ],
    ['inspect torus.obj --faces 10', 'limber inspect has no --faces: see limber inspect --help.'],
    [
      'simulate',
      'A is missing: give the original, as in limber simulate A [B] (options: limber help simulate).',
    ],
    ['simulate a.obj b.obj c.obj', '"c.obj" is one file too many: limber simulate A [B].'],
    [
      'simulate torus.obj --scenario fall',
      '--scenario is fall: give one of twist, sway, hang, drop, pull, wind, drape (default: twist).',
    ],
    [
      'simulate torus.obj --colliders floor:1',
      '--colliders has "floor:1": give ground:HEIGHT, ball:x,y,z,R or capsule:x0,y0,z0,x1,y1,z1,R, joined by +.',
    ],
    ['simulate torus.obj --calibrate', '--calibrate matches B to A: name both files.'],
    [
      'simulate torus.obj torus.obj --calibrate --settings s.json',
      '--calibrate cannot be combined with --settings, which is tuned for a solver: leave one of them out.',
    ],
    [
      'simulate torus.obj torus.obj --calibrate --material springs',
      '--calibrate does not work with --material springs, which has no bending stiffness to scale: give --material shell.',
    ],
    ['simulate torus.obj --bind a.json', '--bind transfers pins to B, which is missing: name both files.'],
    [
      'tune torus.obj torus.obj --solver jolt --settings s.json --engine compliance',
      '--engine compliance is neither name=value nor a file: give name=value, separated by commas.',
    ],
    [
      'tune torus.obj torus.obj --solver mujoco --settings s.json --bend-ratio 0.1',
      '--bend-ratio is for springs and dihedral if no bend constant is given in --engine: leave it out, and give mujoco its own numbers by --engine.',
    ],
    [
      'simulate torus.obj torus.obj --solver jolt --settings s.json --engine compliance=1',
      '--engine is given together with a settings file, which already has the parameters of the original: leave one of them out.',
    ],
    [
      'simulate torus.obj torus.obj --solver jolt --settings s.json --mass area',
      '--mass is given together with a settings file, which already has the parameters of the original: leave one of them out.',
    ],
    ['simulate torus.obj torus.obj --bind none.json', 'none.json cannot be read: there is no such file.'],
    ['compare torus.obj two.obj', 'torus.obj has 1 body and two.obj has 2: compare one with --mesh NAME.'],
    [
      'tune two.obj torus.obj --solver shell --settings s.json',
      'two.obj has 2 bodies and torus.obj has 1: tune one with --mesh NAME.',
    ],
  ])('limber %s', (words, message) => {
    expect(limber(...words.split(' '))).toEqual({ code: 1, stdout: '', stderr: `limber: ${message}\n` });
  });

  it('without any argument shows the help and fails', () => {
    expect(limber()).toMatchObject({ code: 1, stderr: '' });
  });
});

describe('help', () => {
  it('exists for every command and fits into 100 columns', () => {
    for (const words of [
      ['--help'],
      ['completion', '--help'],
      ...['optimize', 'modes', 'compare', 'simulate', 'inspect'].map((name) => [name, '--help']),
    ]) {
      const { code, stdout, stderr } = limber(...words);
      expect([code, stderr]).toEqual([0, '']);
      for (const line of stdout.split('\n')) expect(line.length).toBeLessThanOrEqual(100);
    }
    for (const name of ['batch', 'completion']) expect(limber('help', name)).toEqual(limber(name, '--help'));
    expect(limber('help')).toEqual(limber('--help'));
    expect(limber('help', 'optimise').stderr).toContain('did you mean "optimize"?');
    expect(limber('help', 'modes', 'compare').stderr).toContain('"compare" is one command too many');
    expect(limber('--version').stdout).toBe(`${VERSION}\n`);
  });
});

describe('limber modes', () => {
  it('lists the modes with their names, ascending', () => {
    const { code, stdout } = limber('modes', 'grid.obj', '--modes', '4');
    expect(code).toBe(0);
    expect(stdout).toMatch(
      /^grid\.obj: shell model, 6 of 6 zero modes found, \d+\.\d s\nmode +name +frequency +omega +residual\n/,
    );
    expect(stdout).toMatch(/\n1 +(bend|twist) +\d/);
    expect(stdout.trim().split('\n')).toHaveLength(6);
  });

  it('uses the solid model for closed bodies: a bar bends, bends, twists, stretches, bends and bends', () => {
    writeFileSync(path('bar.obj'), toObj(box(4, 4, 12)));
    const { model, modes, zeroModes } = report(limber('modes', 'bar.obj', '--modes', '6', '--json').stdout);
    expect([model, zeroModes]).toEqual(['solid', { expected: 6, found: 6 }]);
    expect(modes!.map(({ name }) => name)).toEqual(['bend', 'bend', 'twist', 'stretch', 'bend', 'bend']);
  });

  it('refuses a body without area, and warns of one among others', () => {
    const line = 'o line\nv 0 0 9\nv 1 0 9\nv 2 0 9\nf -3 -2 -1\n';
    writeFileSync(path('line.obj'), line);
    expect(limber('modes', 'line.obj')).toEqual({
      code: 1,
      stdout: '',
      stderr:
        'limber: Body "line" has no modes: its triangles have no area, so repair the mesh and export it again.\n',
    });
    writeFileSync(path('lines.obj'), `${toObj(grid(2, 2))}${line}`);
    const { code, stderr } = limber('modes', 'lines.obj');
    expect([code, stderr]).toEqual([
      0,
      'limber: line: no modes: its triangles have no area, so repair the mesh and export it again.\n',
    ]);
    const held = limber('modes', 'grid.obj', '--pins', 'low:100');
    expect([held.code, held.stderr]).toEqual([
      1,
      'limber: Body "grid" has no modes: its pins hold everything that could move, so pin fewer vertices.\n',
    ]);
  });

  it('pins the vertices that --pins names, and scales with the material', () => {
    const run = (...flags: string[]) =>
      report(limber('modes', 'grid.obj', '--modes', '2', '--json', ...flags).stdout);
    const clamped = run('--pins', 'low:20');
    expect(clamped.zeroModes).toEqual({ expected: 0, found: 0 });
    expect(clamped.options.pins).toBe('low:20');
    const stiff = run('--material-preset', 'rubber', '--young', '4e6');
    expect(stiff.options).toMatchObject({ young: 4e6, density: 1000 });
    expect(stiff.modes![0].omega / run().modes![0].omega).toBeCloseTo(2, 6);
  });

  it('moves a laplacian along one axis with --direction', () => {
    const { modes, zeroModes } = report(
      limber('modes', 'grid.obj', '--model', 'laplacian', '--direction', 'z', '--modes', '2', '--json')
        .stdout,
    );
    expect(zeroModes).toEqual({ expected: 1, found: 1 });
    expect(modes!.every((mode) => mode.along === undefined)).toBe(true);
  });

  it('reports the modes, and nothing that it does not compute', () => {
    const found = report(limber('modes', 'two.obj', '--modes', '4', '--json').stdout);
    expect(found).toMatchObject({ command: 'modes', model: 'mixed', zeroModes: { expected: 12, found: 12 } });
    expect(found.modes).toHaveLength(8);
    for (const key of ['output', 'surface', 'stop', 'fidelity']) expect(found).not.toHaveProperty(key);
  });

  it('marks the frequencies of the laplacian as nominal, and lists each scalar mode three times', () => {
    const { stdout } = limber('modes', 'grid.obj', '--modes', '6', '--model', 'laplacian', '--json');
    const { modes } = report(stdout);
    expect(modes!.every(({ nominal }) => nominal === true)).toBe(true);
    expect(modes![0].omega).toBe(modes![2].omega);
    expect(modes!.map(({ along }) => along).slice(0, 3)).toEqual(['shortest', 'middle', 'longest']);
  });

  it('writes the modes as morph targets with --shapes', async () => {
    expect(limber('modes', 'two.obj', '--modes', '3', '--shapes', 'shapes.glb').code).toBe(0);
    const bytes = readFileSync(path('shapes.glb'));
    expect(await validateGlb(bytes)).toEqual({ errors: 0, warnings: 0, messages: [] });
    const root = (await readGlb(bytes)).getRoot();
    expect(root.listAnimations()).toHaveLength(3);
    for (const mesh of root.listMeshes()) expect(mesh.listPrimitives()[0].listTargets()).toHaveLength(3);
  });
});

describe('limber compare', () => {
  it('finds a mesh identical to itself', () => {
    const { code, stdout } = limber('compare', 'torus.obj', 'torus.obj', '--json');
    expect(code).toBe(0);
    const { fidelity, surface, options, input, output } = report(stdout);
    expect(options).toMatchObject({ modeCount: 10, thickness: 2, model: 'shell' });
    expect(input).toEqual(output);
    expect(surface!.hausdorff).toBeLessThan(1e-4);
    expect(fidelity!.frequencyErrorMax).toBeLessThan(1e-4);
    expect(fidelity!.macMin).toBeGreaterThan(0.9999);
  });

  it('says which of the two models a warning is about', async () => {
    const scene = startDocument();
    addMesh(scene, 'ring', [primitiveOf(scene, torus())]);
    moveNode(scene, scene.getRoot().listNodes()[0]);
    writeFileSync(path('moved.glb'), (await glbFile(scene)).bytes);
    const { stderr } = limber('compare', 'torus.obj', 'moved.glb');
    expect(stderr).toBe('limber: moved.glb: 1 animation: the rest pose is used.\n');
    expect(limber('inspect', 'moved.glb').stderr).toBe('limber: 1 animation: the rest pose is used.\n');
  });

  it('reports what an optimized mesh has lost', () => {
    limber('optimize', 'torus.obj', 'half.glb');
    const { code, stdout } = limber('compare', 'torus.obj', 'half.glb', '--modes', '5');
    expect(code).toBe(0);
    expect(stdout).toMatch(/^torus\.obj -> half\.glb +576 -> 288 faces \(-50\.0 %\)\ntopology +the same\n/);
    expect(stdout).toMatch(/frequency error, modes 1-5 +mean/);
  });

  it('measures distances and says why frequencies are missing where modes do not converge', () => {
    const { positions, triangles } = grid(200, 2);
    const strip = toObj({ positions: positions.map((x, i) => (i % 3 === 1 ? 1e-4 * x : x)), triangles });
    writeFileSync(path('strip.obj'), strip);
    const { code, stdout } = limber('compare', 'strip.obj', 'strip.obj');
    expect(code).toBe(0);
    expect(stdout).toMatch(/topology +the same\nsurface deviation +0\.000 %/);
    expect(stdout).toMatch(/frequency error, modes 1-10 +unknown: The modes did not converge: .*\.\n$/);
    const { fidelity, surface } = report(limber('compare', 'strip.obj', 'strip.obj', '--json').stdout);
    expect(surface!.hausdorff).toBeLessThan(1e-4);
    expect(fidelity).toEqual({ failure: expect.stringMatching(/^The modes did not converge/) });
  });

  it('leaves out the error of modes that the original does not have', () => {
    writeFileSync(path('triangle.obj'), 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n');
    const { stdout } = limber('compare', 'triangle.obj', 'triangle.obj');
    expect(stdout).toMatch(/at twice the thickness +mean 0\.000 %\nshape agreement/);
    const { fidelity } = report(limber('compare', 'triangle.obj', 'triangle.obj', '--json').stdout);
    expect(fidelity).not.toHaveProperty('frequencyErrorHigh');
  });
});

describe('limber inspect', () => {
  it('reports what is in a file', () => {
    const { code, stdout } = limber('inspect', 'two.obj');
    expect(code).toBe(0);
    expect(stdout).toMatch(
      /^two\.obj: OBJ, 2 bodies\nbody +vertices +faces +parts +borders +genus +smallest angle +mean\nring +288 +576 +1 +0 +1 /,
    );
    expect(stdout).toMatch(/- sheet: 1 open border\n$/);
  });

  it('reports on a mesh without any usable face', () => {
    writeFileSync(path('flat.obj'), 'v 0 0 0\nv 1 0 0\nv 1 0 0\nf 1 2 3\n');
    const { code, stdout } = limber('inspect', 'flat.obj', '--json');
    expect(code).toBe(0);
    expect(report(stdout).input).toMatchObject({ faces: 0, degenerateFaces: 1 });
    expect(report(stdout).input).not.toHaveProperty('minAngle');
    expect(limber('optimize', 'flat.obj', 'a.glb')).toMatchObject({ code: 1 });
  });
});
