/** Which files on the disk are read with an OBJ, belong to it, and are written with one. The files are real. */

import { spawnSync } from 'node:child_process';
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { keyOf } from '../../web/cli/batch/key';
import { pathsNamedBy, readModelFiles } from '../../web/cli/files';
import { openModel } from '../../web/engine/document/open';
import { SQUARE_OBJ } from './support/files';
import { pngOf } from './support/pictures';

let top: string;
let folder: string;
const at = (...names: string[]) => join(folder, ...names);
const RED = pngOf([[[255, 0, 0]]]);

function write(name: string, content: string | Uint8Array): void {
  mkdirSync(dirname(at(name)), { recursive: true });
  writeFileSync(at(name), content);
}

const OBJ = `vt 0 0\nvt 1 0\nvt 1 1\n${SQUARE_OBJ}usemtl m\nf 1/1 2/2 3/3\nusemtl my paint\nf 1/1 3/3 4/1\n`;

beforeEach(() => {
  top = mkdtempSync(join(tmpdir(), 'limber-obj-'));
  folder = join(top, 'set');
  write('a.obj', `mtllib mats/my set.mtl\n${OBJ}`);
  write(
    'mats/my set.mtl',
    'newmtl m\nmap_Kd -s 2 2 2 my skin.png\nmap_Ks shine.png\nnewmtl my paint\nKe 1 1 1\nmap_Ke C:\\glow.PNG\nnewmtl other\nmap_Kd other.png\n',
  );
  for (const name of ['mats/my skin.png', 'mats/shine.png', 'mats/other.png', 'glow.png']) write(name, RED);
});
afterEach(() => rmSync(top, { recursive: true, force: true }));

const namesRead = async (name = 'a.obj') => (await readModelFiles(at(name))).files.map((file) => file.name);
const pathsOf = async (name = 'a.obj') =>
  (await readModelFiles(at(name))).paths.map((path) => path.replace(`${folder}/`, ''));

describe('with an OBJ', () => {
  it('its libraries are read, and the pictures of the materials that it uses', async () => {
    expect(await namesRead()).toEqual(['a.obj', 'mats/my set.mtl', 'mats/my skin.png', 'glow.png']);
    const model = await openModel((await readModelFiles(at('a.obj'))).files);
    expect([model.notes, model.unread]).toEqual([[], []]);
    expect(model.document.getRoot().listTextures()).toHaveLength(2);
  });

  it('all pictures that its libraries name are protected from being overwritten', async () => {
    const paths = await pathsOf();
    for (const name of [
      'mats/my set.mtl',
      'mats/my skin.png',
      'mats/shine.png',
      'mats/other.png',
      'glow.png',
    ])
      expect(paths).toContain(name);
    expect(pathsNamedBy(at('a.obj'))).toContain(at('mats/other.png'));
  });

  it('the library of its own name is read if it names none, which no note claims', async () => {
    write('b.obj', OBJ);
    write('b.mtl', 'newmtl m\nmap_Kd glow.png\n');
    expect(await namesRead('b.obj')).toEqual(['b.obj', 'b.mtl', 'glow.png']);
    expect(await pathsOf('b.obj')).toContain('b.mtl');
    expect(pathsNamedBy(at('b.obj'))).toEqual([]);
  });

  it('nothing is read from outside of its folder, by any path', async () => {
    writeFileSync(join(top, 'secret.png'), RED);
    writeFileSync(join(top, 'secret.mtl'), 'newmtl m\nmap_Kd glow.png\n');
    symlinkSync(join(top, 'secret.png'), at('link.png'));
    write('c.obj', `mtllib ../secret.mtl c2.mtl\n${OBJ}`);
    const names = [
      '../secret.png',
      '..\\secret.png',
      join(top, 'secret.png'),
      'link.png',
      'mats/../../secret.png',
      'x/../../secret.png',
    ];
    for (const name of names) {
      write('c2.mtl', `newmtl m\nmap_Kd ${name}\n`);
      expect(await namesRead('c.obj'), name).toEqual(['c.obj', 'c2.mtl']);
    }
    expect((await readModelFiles(at('c.obj'))).paths).toContain(join(top, 'secret.mtl'));
  });

  it('no folders, pipes or missing files are read', async () => {
    write('d.obj', `mtllib mats\nmtllib ./\nmtllib none.mtl\n${OBJ}`);
    expect(await namesRead('d.obj')).toEqual(['d.obj']);
  });

  it('the same model opens as in the page, which has all files of the folder', async () => {
    const read = (await readModelFiles(at('a.obj'))).files;
    const dropped = [...read, { name: 'mats/other.png', bytes: RED }, { name: 'mats/shine.png', bytes: RED }];
    const [one, other] = [await openModel(read), await openModel(dropped)];
    const images = ({ document }: typeof one) =>
      document
        .getRoot()
        .listTextures()
        .map((texture) => texture.getURI());
    expect(images(other)).toEqual(images(one));
  });
});

describe('the key of an asset of a batch', () => {
  const key = async () =>
    keyOf((await readModelFiles(at('a.obj'))).files, { options: {}, fromPreset: [] } as never, 'a.glb');

  it('changes with its library and with a picture that it uses, and with no other file', async () => {
    const first = await key();
    expect(await key()).toBe(first);
    write('mats/other.png', 'changed');
    write('mats/shine.png', 'changed');
    expect(await key()).toBe(first);
    write('mats/my skin.png', pngOf([[[0, 255, 0]]]));
    const second = await key();
    expect(second).not.toBe(first);
    write('mats/my set.mtl', 'newmtl m\nKd 1 0 0\n');
    expect([first, second]).not.toContain(await key());
  });
});

/** Runs the command line in the folder above that of the OBJ. */
function limber(...words: string[]) {
  const program = new URL('../../dist/cli/limber.mjs', import.meta.url).pathname;
  const { status, stdout, stderr } = spawnSync(process.execPath, [program, ...words], {
    cwd: top,
    encoding: 'utf8',
  });
  return { code: status, stdout, said: stderr };
}

describe('an OBJ written into another folder', () => {
  const COMPANIONS = ['mats/my set.mtl', 'mats/my skin.png', 'mats/shine.png', 'glow.png', 'mats/other.png'];
  const isSame = (name: string, folder = 'out') =>
    readFileSync(join(top, folder, name)).equals(readFileSync(at(name)));
  beforeEach(() => mkdirSync(join(top, 'out')));

  it('is written with the libraries of its input and their pictures, byte for byte', () => {
    expect(limber('optimize', 'set/a.obj', 'out/b.obj', '--soft', '--dry-run').stdout.split('\n')).toEqual([
      'a.obj: OBJ, 1 body, 4 faces',
      'would write out/b.obj',
      ...COMPANIONS.map((name) => `would write out/${name}, which belongs to OUT`),
      '',
    ]);
    const { code, said } = limber('optimize', 'set/a.obj', 'out/b.obj', '--soft');
    expect([code, said]).toEqual([0, expect.not.stringMatching(/leaves out/)]);
    expect(COMPANIONS.filter((name) => !isSame(name))).toEqual([]);
  });

  it('overwrites files of the user only with --force, and files that limber wrote always', () => {
    mkdirSync(join(top, 'out', 'mats'));
    writeFileSync(join(top, 'out', 'glow.png'), 'mine');
    const words = ['optimize', 'set/a.obj', 'out/a.obj', '--soft'];
    expect(limber(...words).said).toMatch(
      /out\/glow\.png, which belongs to out\/a\.obj, exists: choose another/,
    );
    expect(existsSync(join(top, 'out', 'a.obj'))).toBe(false);
    expect(limber(...words, '--force').code).toBe(0);
    expect(isSame('glow.png')).toBe(true);
    write('glow.png', pngOf([[[0, 255, 0]]]));
    expect(limber(...words).code).toBe(0);
    expect(isSame('glow.png')).toBe(true);
  });

  it('in the folder of the input is written alone', () => {
    const { stdout } = limber('optimize', 'set/a.obj', 'set/b.obj', '--dry-run');
    expect(stdout.split('\n').slice(1)).toEqual(['would write set/b.obj', '']);
  });

  it('is written to stdout alone, with a note', () => {
    const { code, stdout, said } = limber('optimize', 'set/a.obj', '-', '--format', 'obj', '--soft');
    expect([code, stdout.split('\n')[1]]).toEqual([0, 'mtllib mats/my set.mtl']);
    expect(said).toContain('stdout leaves out mats/my set.mtl and 4 files more, which it names.');
    expect(existsSync(join(top, 'mats'))).toBe(false);
  });

  it('of a batch is repeated if one of its files is missing or has changed', () => {
    const run = () =>
      /(\d) optimized/.exec(limber('batch', 'set', 'out', '--format', 'obj', '--soft').stdout)?.[1];
    expect([run(), run()]).toEqual(['1', '0']);
    rmSync(join(top, 'out', 'mats', 'other.png'));
    expect([run(), isSame('mats/other.png')]).toEqual(['1', true]);
    write('mats/shine.png', pngOf([[[0, 255, 0]]]));
    expect([run(), isSame('mats/shine.png'), run()]).toEqual(['1', true, '0']);
  });
});
