/** limber batch as a program. */

import { spawn, spawnSync } from 'node:child_process';
import {
  appendFileSync,
  copyFileSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  symlinkSync,
  utimesSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeEach, describe, expect, it } from 'vitest';
import type { Summary } from '../../web/cli/batch/summary';
import { validateGlb } from '../../web/engine/document/validate';
import { glbFile } from './support/gltf';
import { tableScene } from './support/scenes';
import { grid, toObj, torus } from './support/shapes';

const program = new URL('../../dist/cli/limber.mjs', import.meta.url).pathname;
const kills = new URL('../bench/batch_kills.mjs', import.meta.url).pathname;
const top = mkdtempSync(join(tmpdir(), 'limber-batch-'));
let folder: string;
let runs = 0;
const path = (name: string) => join(folder, name);

function limber(...words: string[]) {
  const { status, stdout, stderr } = spawnSync(process.execPath, [program, ...words], {
    cwd: folder,
    encoding: 'utf8',
  });
  return { code: status, stdout, stderr };
}

const batch = (...words: string[]) => limber('batch', 'src', 'out', '--jobs', '2', ...words);
const summary = () => JSON.parse(readFileSync(path('out/summary.json'), 'utf8')) as Summary;
const totals = () => summary().totals;
const rowOf = (asset: string) => summary().assets.find((row) => row.asset === asset)!;
const bytes = (name: string) => readFileSync(path(name));
const write = (name: string, text: string) => {
  mkdirSync(join(path(name), '..'), { recursive: true });
  writeFileSync(path(name), text);
};

beforeEach(() => {
  folder = join(top, String(++runs));
  write('src/ring.obj', toObj(torus()));
  write('src/sheets/sheet.obj', toObj(grid(8, 8)));
});
afterAll(() => rmSync(top, { recursive: true, force: true }));

describe('limber batch', () => {
  it('writes what limber optimize writes, in the same tree, with a summary', async () => {
    writeFileSync(path('src/table.glb'), (await glbFile(tableScene())).bytes);
    const { code, stdout, stderr } = batch('--ratio', '0.4', '--frequencies', '--soft');
    expect([code, stderr.split('\n').length]).toEqual([0, 5]);
    expect(stdout).toMatch(
      /^3 assets: 3 optimized, 0 up to date; [\d,]+ -> [\d,]+ faces \(-\d+\.\d %\); \d+\.\d s -> out/,
    );
    for (const name of ['ring', 'sheets/sheet']) {
      limber('optimize', `src/${name}.obj`, 'alone.glb', '--ratio', '0.4', '--soft');
      expect(bytes(`out/${name}.glb`).equals(bytes('alone.glb'))).toBe(true);
    }
    expect(await validateGlb(bytes('out/table.glb'))).toMatchObject({ errors: 0 });
    const { facesBefore, facesAfter, frequencyError, deviation } = rowOf('ring.obj');
    expect(facesBefore).toBe(576);
    expect(facesAfter).toBeGreaterThanOrEqual(230);
    expect(facesAfter).toBeLessThan(576);
    expect(frequencyError).toBeGreaterThan(0);
    expect(deviation).toBeGreaterThan(0);
    const html = bytes('out/summary.html').toString();
    expect(html.match(/<img src="data:image\/png;base64,iVBOR/g)).toHaveLength(3);
    expect(html).not.toMatch(/src="(?!data:)/);
    const links = Array.from(html.matchAll(/href="([^"]*)"/g), ([, address]) => address);
    expect(links.sort()).toEqual(['ring.glb', 'sheets/sheet.glb', 'table.glb']);
    for (const size of [statSync(path('src/ring.obj')).size, bytes('out/ring.glb').length])
      expect(html).toContain(`<td>${size.toLocaleString('en-US')}</td>`);
    expect(bytes('out/summary.csv').toString().split('\r\n')).toHaveLength(5);
    expect(readdirSync(path('out/.limber-batch')).sort()).toEqual(['manifest.json', 'pictures']);
  });

  it('treats a limit of a preset as no target, but one that is given by name as one', () => {
    const isAs = (...words: string[]) => {
      limber('optimize', 'src/sheets/sheet.obj', 'alone.glb', ...words);
      return bytes('out/sheets/sheet.glb').equals(bytes('alone.glb'));
    };
    batch('--preset', 'print');
    expect(isAs('--preset', 'print')).toBe(true);
    batch('--preset', 'print', '--max-deviation', '0.1');
    expect(isAs('--preset', 'print')).toBe(false);
    expect(isAs('--preset', 'print', '--max-deviation', '0.1')).toBe(true);
    write('batch.json', '{"schema":"limber-batch/1","options":{"maxDeviation":0.1}}');
    expect(batch('--preset', 'print').code).toBe(0);
    batch('--preset', 'print', '--config', 'batch.json');
    expect(isAs('--preset', 'print', '--max-deviation', '0.1')).toBe(true);
  });

  it('repeats assets whose content has changed, and nothing else', () => {
    batch();
    const written = statSync(path('out/ring.glb')).mtimeMs;
    utimesSync(path('src/ring.obj'), new Date(), new Date());
    expect([batch().code, totals().unchanged]).toEqual([0, 2]);
    expect(statSync(path('out/ring.glb')).mtimeMs).toBe(written);
    appendFileSync(path('src/ring.obj'), '# changed\n');
    rmSync(path('out/sheets/sheet.glb'));
    write('src/new.obj', toObj(grid(4, 4)));
    const dry = batch('--dry-run');
    expect(dry.stdout).toMatch(
      /new\.obj \(new\) -> out\/new\.glb\nsrc\/ring\.obj \(changed\).*\nsrc\/sheets\/sheet\.obj \(result missing\)/,
    );
    expect(existsSync(path('out/new.glb'))).toBe(false);
    expect(batch('--dry-run', '--again').stdout).toMatch(/would optimize 3 assets; 0 up to date/);
    batch();
    expect(totals()).toMatchObject({ assets: 3, done: 3, unchanged: 0 });
    expect([batch('--ratio', '0.3', '--soft').code, totals().unchanged]).toEqual([0, 0]);
    expect([batch('--ratio', '0.3', '--soft', '--threads', '2').code, totals().unchanged]).toEqual([0, 3]);
    expect([batch('--ratio', '0.3', '--soft', '--again').code, totals().unchanged]).toEqual([0, 0]);
  });

  it('fails only a bad asset, and reports it with its error', () => {
    write('src/bad.obj', 'v 0 0 nan\nf 1 1 1\n');
    write('src/=1+1.obj', 'nothing');
    const { code, stderr } = batch('--quiet');
    expect(code).toBe(1);
    expect(stderr.trim().split('\n')).toEqual([
      'limber: =1+1.obj, line 1: "nothing" is not OBJ, and the file has no faces: check that it is a mesh file.',
      'limber: bad.obj, line 1: z is nan, not a finite number.',
    ]);
    expect(totals()).toMatchObject({ assets: 4, done: 2, failed: 2 });
    expect(bytes('out/summary.csv').toString()).toContain(`'=1+1.obj,failed`);
    write('src/bad.obj', toObj(grid(3, 3)));
    rmSync(path('src/=1+1.obj'));
    expect([batch().code, totals().unchanged, totals().failed]).toEqual([0, 2, 0]);
  });

  it('takes a configuration with overrides, and tells what misses a target', () => {
    write(
      'batch.json',
      JSON.stringify({
        schema: 'limber-batch/1',
        options: { reports: true, bindings: true },
        overrides: [
          { files: '*.obj', options: { soft: false } },
          { files: 'ring.*', options: { faces: 1, maxDeviation: 0, reports: false } },
        ],
        exclude: ['skip/**'],
      }),
    );
    write('src/skip/x.obj', 'nothing');
    const { code, stderr } = batch('--config', 'batch.json', '--quiet');
    expect([code, stderr]).toEqual([
      2,
      expect.stringMatching(/^limber: ring\.obj: Stopped at \d+ faces, not 1: /),
    ]);
    expect([rowOf('sheets/sheet.obj').state, rowOf('ring.obj').state]).toEqual(['done', 'missed']);
    expect(readdirSync(path('out')).filter((name) => name.startsWith('ring'))).toEqual([
      'ring.bind.json',
      'ring.glb',
    ]);
    expect(readdirSync(path('out/sheets'))).toEqual(['sheet.bind.json', 'sheet.glb', 'sheet.report.json']);
    expect(JSON.parse(bytes('out/sheets/sheet.report.json').toString())).toMatchObject({
      schema: 'limber-report/1',
    });
    expect(batch('--config', 'batch.json').code).toBe(2);
    expect(totals().unchanged).toBe(2);
  });

  it('overwrites nothing that it has not written', () => {
    write('out/ring.glb', 'mine');
    write('out/summary.csv', 'mine');
    expect(batch()).toMatchObject({
      code: 1,
      stderr: expect.stringMatching(/summary\.csv exists and was not written/),
    });
    rmSync(path('out/summary.csv'));
    expect(batch('--quiet')).toMatchObject({
      code: 1,
      stderr: expect.stringMatching(/^limber: ring\.obj: .*ring\.glb exists/),
    });
    expect(bytes('out/ring.glb').toString()).toBe('mine');
    expect(batch('--report', 'src/ring.obj', '--force').stderr).toMatch(
      /src\/ring\.obj, .*is also the input/,
    );
    expect(limber('batch', 'src', 'src')).toMatchObject({
      code: 1,
      stderr: expect.stringContaining('is also SRC'),
    });
    expect(limber('batch', 'src/*.obj', 'src')).toEqual({
      code: 1,
      stdout: '',
      stderr: 'limber: src is also the folder of src/*.obj: choose another folder for the results.\n',
    });
    expect(batch('--force').code).toBe(0);
  });

  it('overwrites none of its input models, even if limber wrote them', () => {
    mkdirSync(path('out/src/src'), { recursive: true });
    for (const name of ['out/src/x.glb', 'out/src/src/x.glb'])
      limber('optimize', 'src/ring.obj', name, '--quiet');
    const before = bytes('out/src/x.glb');
    for (const words of [[], ['--force']])
      expect(limber('batch', 'out/src', 'out', '--quiet', ...words)).toMatchObject({
        code: 1,
        stderr: expect.stringContaining('src/x.glb: out/src/x.glb is also a model of this batch') as string,
      });
    expect(bytes('out/src/x.glb').equals(before)).toBe(true);
  });

  it('passes over links that lead nowhere or back to themselves', () => {
    symlinkSync('gone.obj', path('src/dangling.obj'));
    symlinkSync('loop.obj', path('src/loop.obj'));
    const { code, stdout, stderr } = batch('--dry-run', '--p', 'inf');
    expect([code, stderr]).toEqual([0, '']);
    expect(stdout).toMatch(/^src\/ring\.obj \(new\) -> out\/ring\.glb {"p":"inf"}$/m);
  });

  it('takes files, patterns and unusual names', () => {
    write('src/Ünï cødé 🦊/it’s; $(touch x) & "q".obj', toObj(grid(4, 4)));
    write('src/-rf.obj', toObj(grid(4, 4)));
    write('src/two\nlines.obj', toObj(grid(4, 4)));
    write('src/.hidden/a.obj', 'nothing');
    write('src/a*.txt', 'nothing');
    const dry = limber('batch', 'src/two*.obj', 'out', '--dry-run').stdout;
    expect(dry.split('\n')[0]).toBe('src/two lines.obj (new) -> out/two lines.glb');
    const all = limber('batch', 'src/**/*.obj', 'out', '--quiet');
    expect([all.code, all.stderr]).toEqual([0, '']);
    expect(totals().assets).toBe(5);
    expect(existsSync(path('out/Ünï cødé 🦊/it’s; $(touch x) & "q".glb'))).toBe(true);
    expect(existsSync(path('x'))).toBe(false);
    expect(limber('batch', 'src/*.obj', 'src/sheets/sheet.obj', 'flat', '--quiet').code).toBe(0);
    expect(readdirSync(path('flat')).sort()).toEqual([
      ...[
        '-rf.glb',
        '.limber-batch',
        'ring.glb',
        'sheet.glb',
        'summary.csv',
        'summary.html',
        'summary.json',
        'two\nlines.glb',
      ],
    ]);
    expect(limber('batch', 'src/ring.obj', 'src/sheets/../ring.obj', 'out2', '--quiet').code).toBe(0);
    expect(readdirSync(path('out2'))).toContain('ring.glb');
    mkdirSync(path('others'));
    copyFileSync(path('src/ring.obj'), path('others/ring.obj'));
    expect(limber('batch', 'src', 'others', 'out3').stderr).toMatch(/are both ring\.obj below SRC/);
    expect(limber('batch', 'nothing', 'out4').stderr).toMatch(/nothing does not exist/);
  });

  it('translates a word of version 0.1 with one note for all assets', () => {
    const lines = batch('--fit', 'on').stderr.split('\n');
    expect(lines[0]).toBe('limber: --fit on of earlier versions is now modal (default: surface).');
    expect(lines.filter((line) => line.includes('earlier versions'))).toHaveLength(1);
  });

  it('matches a pattern without folders in its own folder alone', () => {
    write('top.obj', toObj(grid(4, 4)));
    for (const pattern of ['*.obj', './*.obj', './/*.obj']) {
      const { stdout } = limber('batch', pattern, 'out', '--dry-run');
      expect(stdout).toMatch(/^top\.obj \(new\) -> out\/top\.glb\nwould optimize 1 asset; /);
    }
    expect(limber('batch', './**/*.obj', 'out', '--dry-run').stdout).toContain('would optimize 3 assets; ');
  });

  it('recognises its own summary after its record has been removed', () => {
    batch();
    rmSync(path('out/.limber-batch'), { recursive: true });
    expect([batch().code, totals().done]).toEqual([0, 2]);
    rmSync(path('out/.limber-batch'), { recursive: true });
    writeFileSync(path('out/summary.json'), '{}');
    expect(batch().stderr).toContain('summary.json exists and was not written by limber');
  });

  it('repeats everything if its record is damaged', () => {
    batch();
    const before = bytes('out/ring.glb');
    writeFileSync(path('out/.limber-batch/manifest.json'), '{"schema":"limber-batchmanifest/1","assets":[');
    const { code, stderr } = batch();
    expect([code, totals().unchanged]).toEqual([0, 0]);
    expect(stderr).toContain(
      'manifest.json is damaged or of another version: all assets are processed again',
    );
    expect(bytes('out/ring.glb').equals(before)).toBe(true);
    expect([batch().code, totals().unchanged]).toEqual([0, 2]);
  });

  it.runIf(process.platform === 'linux')('fails only the asset that takes more memory than a job may', () => {
    const { code, stderr } = batch('--memory', '64', '--quiet');
    expect(code).toBe(1);
    expect(stderr).toContain('limber: ring.obj: needs more than the 64 MB of a job: raise --memory');
  });

  it('lets one batch at a time work on a folder, and takes over what a killed one left', async () => {
    for (const name of ['a', 'b', 'c', 'd']) write(`src/${name}.obj`, toObj(torus()));
    const first = spawn(process.execPath, [program, 'batch', 'src', 'out', '--quiet'], { cwd: folder });
    while (!existsSync(path('out/.limber-batch/lock.json'))) await new Promise((done) => setTimeout(done, 5));
    const second = batch();
    expect(second).toMatchObject({
      code: 1,
      stderr: expect.stringContaining('Another batch is at work on out'),
    });
    first.kill('SIGKILL');
    await new Promise((done) => first.on('exit', done));
    expect(batch().code).toBe(0);
    expect(existsSync(path('out/.limber-batch/lock.json'))).toBe(false);
  });

  it('leaves nothing unfinished behind where it is stopped, and says how to go on', async () => {
    for (const name of ['a', 'b', 'c', 'd']) write(`src/${name}.obj`, toObj(torus(64, 32)));
    const run = spawn(process.execPath, [program, 'batch', 'src', 'out', '--quiet'], { cwd: folder });
    const said: Buffer[] = [];
    run.stderr.on('data', (words: Buffer) => said.push(words));
    while (!existsSync(path('out/.limber-batch/work'))) await new Promise((done) => setTimeout(done, 5));
    run.kill('SIGINT');
    expect(await new Promise((done) => run.on('close', done))).toBe(130);
    expect(Buffer.concat(said).toString()).toBe('limber: stopped; run the same command again to continue.\n');
    expect(existsSync(path('out/.limber-batch/work'))).toBe(false);
    expect(existsSync(path('out/.limber-batch/lock.json'))).toBe(false);
  });

  it('has the results of an undisturbed run after kills at random moments', () => {
    const { status, stdout } = spawnSync(
      process.execPath,
      [kills, '--kills', '6', '--seed', '11', '--assets', '6', '--faces', '200'],
      { encoding: 'utf8' },
    );
    expect([status, stdout]).toEqual([0, expect.stringContaining('6 of 6 equal')]);
  });
});

describe('--from', () => {
  it('says what stdin is', () => {
    const points = toObj(grid(4, 4));
    const run = (...words: string[]) =>
      spawnSync(process.execPath, [program, 'optimize', '-', '-', ...words], {
        cwd: folder,
        input: `# no clue\n${points}`,
      });
    expect(run('--from', 'obj').stdout.subarray(0, 4).toString()).toBe('glTF');
    expect(run('--from', 'ply')).toMatchObject({ status: 1 });
    const headless = '4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n';
    const off = spawnSync(process.execPath, [program, 'inspect', '-', '--from', 'off'], { input: headless });
    expect(off.stdout.toString()).toMatch(/^stdin.off: OFF, 1 body\n/);
    expect(run('--from', 'fbx').stderr.toString()).toMatch(/--from is fbx: give one of glb, gltf/);
    expect(limber('inspect', 'src/ring.obj', '--from', 'obj').stderr).toMatch(
      /--from applies to a model read from stdin/,
    );
  });
});
