/** The command line as a program: exit codes, files that are kept, pipes, and what is said. */

import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import {
  chmodSync,
  existsSync,
  lstatSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Report } from '../../web/engine/report/report';
import { validateGlb } from '../../web/engine/document/validate';
import { addMesh, floats, glbFile, primitiveOf, readGlb, startDocument } from './support/gltf';
import { grid, toObj, torus } from './support/shapes';

const program = new URL('../../dist/cli/limber.mjs', import.meta.url).pathname;
let folder: string;
const path = (name: string) => join(folder, name);

interface RunOptions {
  input?: Uint8Array;
  env?: Record<string, string>;
}

/** Runs limber in the folder of the test files, on one thread. */
function limber(words: string, { input, env }: RunOptions = {}) {
  const run = spawnSync(process.execPath, [program, ...words.split(' ')], {
    cwd: folder,
    input,
    env: { ...process.env, ...env },
    maxBuffer: 1 << 26,
  });
  return {
    code: run.status,
    bytes: run.stdout,
    stdout: run.stdout.toString(),
    stderr: run.stderr.toString(),
  };
}

/** Names and contents of all files in the folder. */
const state = () =>
  readdirSync(folder)
    .filter((name) => statSync(path(name)).isFile())
    .sort()
    .map((name) => [
      name,
      createHash('sha256')
        .update(readFileSync(path(name)))
        .digest('hex'),
    ]);

beforeAll(async () => {
  if (!existsSync(program)) throw new Error('dist/cli/limber.mjs is missing: run npm run build first.');
  folder = mkdtempSync(join(tmpdir(), 'limber-safety-'));
  writeFileSync(path('torus.obj'), toObj(torus()));
  const points = startDocument();
  const positions = floats(points, 'VEC3', [0, 0, 0, 1, 0, 0]);
  addMesh(points, 'dots', [points.createPrimitive().setAttribute('POSITION', positions).setMode(0)]);
  writeFileSync(path('points.glb'), (await glbFile(points)).bytes);
  const many = startDocument();
  for (let i = 0; i < 30; ++i) {
    const { positions: corners, triangles } = grid(3, 3);
    // Two triangles of each body are there twice.
    const doubled = Uint32Array.from([...triangles, ...triangles.slice(0, 6)]);
    addMesh(many, `part ${i}`, [primitiveOf(many, { positions: corners, triangles: doubled })]);
  }
  writeFileSync(path('many.glb'), (await glbFile(many)).bytes);
});

afterAll(() => rmSync(folder, { recursive: true, force: true }));

describe('a file that is there', () => {
  it('that limber did not write is kept without --force, and nothing else is written', () => {
    writeFileSync(path('mine.glb'), 'precious');
    const before = state();
    expect(limber('optimize torus.obj mine.glb --report new.json')).toMatchObject({
      code: 1,
      stdout: '',
      stderr:
        'limber: mine.glb exists and was not written by limber: name another file, or replace it with --force.\n',
    });
    expect(state()).toEqual(before);
    expect(limber('optimize torus.obj mine.glb --method qem --force').code).toBe(0);
    expect(readFileSync(path('mine.glb'), 'latin1').slice(0, 4)).toBe('glTF');
  });

  it('from an earlier run is replaced: OUT, levels, report, binding and settings', () => {
    const words =
      'optimize torus.obj again.glb --method qem --lods 0.2 --max-deviation 0 --report again.json --bind bind.json --quiet';
    const tuned = 'tune torus.obj again.glb --solver shell --settings tuned.json --quiet';
    for (let i = 0; i < 2; ++i) {
      expect(limber(words)).toMatchObject({ code: 0, stderr: '' });
      expect(limber(tuned)).toMatchObject({ code: 0, stderr: '' });
    }
    expect(limber('modes torus.obj --modes 1 --shapes again.glb').code).toBe(0);
  });

  it('is replaced behind a link, with its permissions', () => {
    expect(limber('optimize torus.obj real.glb --method qem').code).toBe(0);
    chmodSync(path('real.glb'), 0o600);
    symlinkSync('real.glb', path('link.glb'));
    expect(limber('optimize torus.obj link.glb --method qem --ratio 0.2 --max-deviation 0').code).toBe(0);
    expect(lstatSync(path('link.glb')).isSymbolicLink()).toBe(true);
    expect(statSync(path('real.glb')).mode & 0o777).toBe(0o600);
    expect(limber('inspect real.glb --json').stdout).toMatch(/"faces": 11[45],/);
  });
});

describe.skipIf(!existsSync('/dev/full'))('a disk that is full', () => {
  it('is refused in one sentence if the system cannot access it', () => {
    const long = `${'a'.repeat(256)}.glb`;
    const reasons = {
      'torus.obj/x.glb': 'a part of its path is a file, not a folder',
      [long]: 'its name is too long',
    };
    for (const [name, reason] of Object.entries(reasons))
      for (const words of [
        `optimize torus.obj ${name}`,
        `inspect torus.obj --report ${name}`,
        `batch torus.obj ${name}`,
        `batch ${name} results`,
      ])
        expect(limber(words)).toMatchObject({
          code: 1,
          stderr: expect.stringMatching(`${name} cannot be reached: ${reason}\\.\n$`) as string,
        });
  });

  it('fails a level, and leaves and names what was written before it', () => {
    symlinkSync('/dev/full', path('full_lod2.glb'));
    const words =
      'optimize torus.obj full.glb --method qem --lods 0.4,0.2,0.1 --max-deviation 0 --report full.json';
    const { code, stdout, stderr } = limber(words);
    expect(code).toBe(1);
    expect(stderr).toBe(
      'limber: full_lod2.glb is not written: the disk is full; full.glb, full_lod1.glb are.\n',
    );
    expect(stdout).toMatch(/-> full\.glb\nfull_lod1\.glb: \d+ faces, .*\n$/);
    const { levels } = JSON.parse(readFileSync(path('full.json'), 'utf8')) as Report;
    expect(levels!.map(({ file }) => file)).toEqual(['full_lod1.glb']);
    expect(existsSync(path('full_lod3.glb'))).toBe(false);
  });

  it('fails a report, and names what was written before it', () => {
    symlinkSync('/dev/full', path('lost.json'));
    const { code, stderr } = limber('optimize torus.obj full.glb --method qem --report lost.json');
    expect(code).toBe(1);
    expect(stderr).toBe('limber: lost.json cannot be written: the disk is full; full.glb is written.\n');
  });
});

describe('exit codes', () => {
  it('are 2 for a missed target that the user gave, and 0 with --soft, with the same message', () => {
    const asked = limber('optimize torus.obj a.glb --method qem --faces 1 --max-deviation 0 --quiet');
    expect(asked.code).toBe(2);
    expect(asked.stderr).toMatch(/^limber: Stopped at \d+ faces, not 1: .*\.\n$/);
    const soft = limber('optimize torus.obj a.glb --method qem --faces 1 --max-deviation 0 --soft');
    expect(soft.code).toBe(0);
    expect(soft.stderr).toBe(asked.stderr);
    expect(limber('optimize torus.obj a.glb --method qem --lods 0.001').code).toBe(2);
    expect(limber('optimize torus.obj a.glb --method qem --lods 0.001 --soft').code).toBe(0);
    const ofPreset = limber('optimize torus.obj a.glb --method qem --preset mobile --ratio 0.9');
    expect(ofPreset.code).toBe(0);
    expect(ofPreset.stderr).toContain('a_lod2.glb: torus stopped at');
    const inside = limber('optimize torus.obj a.glb --method qem --lods 0.001 --lod-style nodes');
    expect(inside.stderr).toContain('a.glb, level 1: torus stopped at');
    expect(inside.stdout).toMatch(/\na\.glb, level 1: \d+ faces, /);
    const finer = limber(
      'optimize torus.obj a.glb --method qem --ratio 0.5 --lods 0.7,0.2 --max-deviation 0',
    );
    expect(finer.code).toBe(0);
    expect(finer.stderr).toMatch(
      /^limber: a_lod1.glb: a further level has \d+ faces, more than the \d+ of the result: give --lods smaller shares of the original\.\n$/,
    );
  });

  it('are 0 where the default of half the faces cannot be reached, with a note', () => {
    // Every vertex is locked.
    const words = 'optimize torus.obj a.glb --method qem --lock low:100';
    const { code, stderr } = limber(words);
    expect([
      code,
      stderr.split('\n').filter((line) => line.includes('Stopped at 576 faces, not 288')),
    ]).toEqual([0, [expect.stringMatching(/^limber: Stopped at 576 faces/)]]);
    expect(limber(`${words} --ratio 0.5`).code).toBe(2);
  });
});

describe('faces that lie on others', () => {
  it('are counted in the same way in all lines, which say that they are in the result', () => {
    const faces = toObj(torus()).match(/^f .*$/gm)!;
    writeFileSync(path('double.obj'), `${toObj(torus())}\n${faces.join('\n')}\n`);
    const locked = limber('optimize double.obj a.glb --method qem --lock low:100');
    expect(locked.stdout).toContain('double.obj: 1,152 -> 1,152 faces');
    expect(locked.stderr).toContain('576 duplicate faces set aside and put back on each face that is left.');
    expect(locked.stderr).toContain('Stopped at 1,152 faces (576 without duplicates), not ');
    expect(limber('inspect double.obj').stdout).toContain('- 576 duplicate faces set aside\n');
    const guarded = limber('optimize double.obj a.glb --method qem --ratio 0.05');
    const [, after] = /-> (\d+) faces/.exec(guarded.stdout)!;
    expect(guarded.stderr).toContain(`stopped at ${after} faces (${Number(after) / 2} without duplicates)`);
  });
});

describe('many bodies', () => {
  it('with the same warning share one line, or have a line each with --verbose', () => {
    const words = 'optimize many.glb a.glb --method qem';
    const put = 'and put back on each face that is left';
    expect(limber(words).stderr).toBe(`limber: each of 30 bodies: 2 duplicate faces set aside ${put}.\n`);
    const lines = limber(`${words} --verbose`).stderr.trim().split('\n');
    expect(lines).toHaveLength(30);
    expect(lines[7]).toBe(`limber: part 7: 2 duplicate faces set aside ${put}.`);
    expect(limber(`${words} --quiet`).stderr).toBe('');
  });

  it('are chosen by patterns; the others stay, and the report has the patterns', async () => {
    const words = 'optimize many.glb a.glb --method qem --mesh part?1* --exclude part?1 --json';
    const { code, stdout } = limber(words);
    expect(code).toBe(0);
    const { options, input } = JSON.parse(stdout) as Report;
    expect(options).toMatchObject({ mesh: 'part?1*', exclude: 'part?1' });
    expect(input.faces).toBe(10 * 20);
    const meshes = (await readGlb(readFileSync(path('a.glb')))).getRoot().listMeshes();
    const left = meshes.map((mesh) => mesh.listPrimitives()[0].getIndices()!.getCount() / 3);
    expect(left.filter((faces) => faces === 20)).toHaveLength(20);
    expect(left.slice(10, 20).every((faces) => faces < 18)).toBe(true);
  });
});

describe('pipes', () => {
  it('carry a model in and out, with the same bytes as files', () => {
    expect(limber('optimize torus.obj torus.glb --method qem --ratio 1').code).toBe(0);
    expect(limber('optimize torus.glb file.glb --method qem').code).toBe(0);
    const piped = limber('optimize - - --method qem', { input: readFileSync(path('torus.glb')) });
    expect(piped.code).toBe(0);
    expect(piped.bytes.equals(readFileSync(path('file.glb')))).toBe(true);
    expect(piped.stderr).toMatch(/^stdin: 576 -> 288 faces .* -> stdout\n$/);
    const quiet = limber('optimize - - --method qem --quiet', { input: readFileSync(path('torus.glb')) });
    expect([quiet.stderr, quiet.bytes.equals(piped.bytes)]).toEqual(['', true]);
  });

  it.skipIf(!existsSync('/dev/stderr'))('are written to by the names that the system has for them', () => {
    const words = 'optimize torus.obj named.glb --method qem --quiet --report /dev/stderr';
    const line = `"${process.execPath}" "${program}" ${words} 2>&1 | cat`;
    const { stdout } = spawnSync('sh', ['-c', line], { cwd: folder, encoding: 'utf8' });
    expect((JSON.parse(stdout) as { command: string }).command).toBe('optimize');
    expect(existsSync(path('named.glb'))).toBe(true);
  });

  it('are sniffed: the format of a text without a name follows from its beginning', () => {
    const { code, stdout } = limber('inspect -', { input: readFileSync(path('torus.obj')) });
    expect([code, stdout.split('\n')[0]]).toEqual([0, 'stdin: OBJ, 1 body']);
    for (const words of ['inspect -', 'inspect - --from obj'])
      expect(limber(words, { input: new Uint8Array() })).toMatchObject({
        code: 1,
        stderr: 'limber: stdin is empty: pipe a model into it, or name a file.\n',
      });
    expect(limber('compare - -').stderr).toMatch(/^limber: stdin can be read only once/);
    expect(limber('optimize torus.obj - --json').stderr).toMatch(
      /^limber: stdout takes the model or the report/,
    );
  });
});

describe('--dry-run', () => {
  it('says what would be written and writes nothing', () => {
    const before = state();
    const { code, stdout, stderr } = limber(
      'optimize many.glb dry.glb --mesh part?1 --lods 0.2 --report dry.json --dry-run',
    );
    expect([code, stderr]).toEqual([0, '']);
    expect(stdout.split('\n')).toEqual([
      'many.glb: GLB, 1 of 30 bodies, 20 faces',
      'would write dry.glb',
      'would write dry_lod1.glb (a level of --lods)',
      'would write dry.json (--report)',
      '',
    ]);
    expect(state()).toEqual(before);
  });

  it('names the target of a link, and only of a link', () => {
    symlinkSync('end.glb', path('leading.glb'));
    const written = (out: string) => limber(`optimize torus.obj ${out} --dry-run`).stdout.split('\n')[1];
    expect(written('leading.glb')).toBe(`would write leading.glb, which leads to ${path('end.glb')}`);
    for (const out of [`../${basename(folder)}/dry.glb`, './dry.glb', path('dry.glb')])
      expect(written(out)).toBe(`would write ${out}`);
    rmSync(path('leading.glb'));
  });

  it('names the files beside OUT, and refuses where they are the user’s', () => {
    expect(limber('optimize torus.obj beside.gltf --dry-run').stdout).toContain(
      'would write beside.gltf\nwould write beside.bin, which belongs to OUT\n',
    );
    writeFileSync(path('beside.bin'), 'precious');
    for (const words of ['--dry-run', ''])
      expect(limber(`optimize torus.obj beside.gltf ${words}`.trim())).toMatchObject({
        code: 1,
        stderr: expect.stringContaining('beside.bin, which belongs to beside.gltf, exists') as string,
      });
    rmSync(path('beside.bin'));
  });

  it('leaves out the compression of a preset where the format has none, as the run does', () => {
    const note = 'OBJ cannot be compressed: meshopt of --preset web is left out';
    expect(limber('optimize torus.obj web.obj --preset web --dry-run').stdout).toContain(`\n${note}\n`);
    expect(limber('optimize torus.obj web.obj --method qem --preset web')).toMatchObject({
      code: 0,
      stderr: `limber: ${note}.\n`,
    });
    limber('optimize torus.obj plain.obj --method qem');
    expect(readFileSync(path('web.obj'), 'utf8')).toBe(readFileSync(path('plain.obj'), 'utf8'));
    expect(limber('optimize torus.obj web2.obj --preset web --compress draco').stderr).toBe(
      'limber: OBJ cannot be compressed by draco: write .glb or .gltf, or leave it out.\n',
    );
    limber('optimize torus.obj like.glb --method qem --preset web --like-input');
    limber('optimize torus.obj default.glb --method qem');
    expect(readFileSync(path('like.glb')).equals(readFileSync(path('default.glb')))).toBe(true);
  });

  it('refuses what the run would refuse', () => {
    writeFileSync(path('kept.json'), 'precious');
    expect(limber('optimize torus.obj dry.glb --report kept.json --dry-run')).toMatchObject({
      code: 1,
      stdout: '',
    });
    expect(limber('optimize torus.obj dry.glb --mesh door --dry-run').stderr).toMatch(/has no body "door"/);
    expect(limber('inspect torus.obj --dry-run').stdout).toBe(
      'torus.obj: OBJ, 1 body, 576 faces\nwould write no file\n',
    );
    for (const words of [
      'inspect points.glb',
      'optimize points.glb dry.glb --report dry.json',
      'simulate torus.obj torus.obj --settings none.json',
      'simulate torus.obj torus.obj --bind none.json',
    ])
      expect(limber(`${words} --dry-run`)).toEqual(limber(words));
  });

  it('refuses what is not in the bodies, and bodies that are no pair', () => {
    limber('optimize torus.obj half.glb --method qem');
    limber(
      'optimize torus.obj half.ply --method qem --bind half.bind.json --solver jolt --settings half.json',
    );
    for (const words of [
      'optimize torus.obj dry.glb --pins vertices:99999',
      'optimize torus.obj dry.glb --lock attribute:_NONE',
      'optimize torus.obj dry.glb --keep _NONE',
      'modes torus.obj --pins attribute:_NONE',
      'tune torus.obj half.glb --solver jolt --settings dry.json --pins vertices:99999',
      'tune half.glb torus.obj --solver jolt --settings dry.json',
      'tune torus.obj many.glb --solver jolt --settings dry.json',
      'compare torus.obj many.glb',
      'simulate torus.obj --pins vertices:99999',
      'simulate many.glb many.glb --mesh part?1 --bind half.bind.json',
      'simulate many.glb many.glb --mesh part?1 --settings half.json',
      'modes torus.obj --memory 100K',
    ]) {
      const run = limber(words);
      expect([words, run.code, run.stdout]).toEqual([words, 1, '']);
      expect(limber(`${words} --dry-run`)).toEqual(run);
    }
  });
});

describe('a file without triangles', () => {
  it('is passed through unchanged, also repeatedly, and refused with options that need triangles', async () => {
    for (let i = 0; i < 2; ++i)
      expect(limber('optimize points.glb passed.glb')).toMatchObject({
        code: 0,
        stdout:
          'points.glb has no triangles (mesh "dots" has no triangles (1 primitive of points skipped)) and is written unchanged -> passed.glb\n',
      });
    expect(await validateGlb(readFileSync(path('passed.glb')))).toMatchObject({ errors: 0 });
    expect(limber('inspect points.glb')).toMatchObject({ code: 1 });
    for (const words of ['--report points.json', '--solver jolt --settings points.json'])
      expect(limber(`optimize points.glb passed.glb ${words}`)).toMatchObject({
        code: 1,
        stderr: expect.stringContaining('leave out --report, --lods, --bind and --settings') as string,
      });
    expect(existsSync(path('points.json'))).toBe(false);
  });
});

describe('words on the terminal', () => {
  it('have no escape sequence, whatever the environment asks for', () => {
    const environments: Record<string, string>[] = [
      {},
      { NO_COLOR: '1' },
      { TERM: 'dumb' },
      { FORCE_COLOR: '1' },
    ];
    for (const env of environments) {
      const { stdout, stderr } = limber('optimize torus.obj a.glb --method qem', { env });
      expect(stdout + stderr).not.toContain('\u001b');
    }
  });
});
