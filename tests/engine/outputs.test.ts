/** What may be written, and what stays as it is. The files are real; no work is done. */

import {
  chmodSync,
  existsSync,
  linkSync,
  lstatSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { spawnSync } from 'node:child_process';
import { hostname, tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { parseArguments } from '../../web/cli/arguments';
import type { Arguments } from '../../web/cli/arguments';
import { readModelFiles, writeWhole } from '../../web/cli/files';
import { identityOf, nameKey } from '../../web/cli/output_files/identity';
import { checkFiles } from '../../web/cli/inputs';
import { levelFiles, writeLevels } from '../../web/cli/levels';
import { checkRoom } from '../../web/cli/output_files/outputs';
import { isOwnContent } from '../../web/cli/output_files/own_files';
import { checkStandard, readStandard } from '../../web/cli/standard';
import { brokenLimits, faceTarget, LIMITS } from '../../web/engine/stages/missed_targets';
import { PRESET_NAMES, settingsOfPreset } from '../../web/engine/settings/presets';
import { defaultSettings } from '../../web/engine/settings/options';
import { exportGlb } from '../../web/engine/document/export';
import { openModel } from '../../web/engine/document/open';
import { failureOf, SQUARE_OBJ, textFile } from './support/files';

let folder: string;
const at = (...names: string[]) => join(folder, ...names);

beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'limber-outputs-'));
  writeFileSync(at('in.obj'), `mtllib in.mtl\n${SQUARE_OBJ}`);
  writeFileSync(at('in.mtl'), 'newmtl a\nmap_Kd -s 1 1 1 skin.png\n');
  writeFileSync(at('skin.png'), 'picture');
});

afterEach(() => rmSync(folder, { recursive: true, force: true }));

const argumentsOf = (...words: string[]): Arguments => {
  const parsed = parseArguments(words);
  if ('show' in parsed) throw new Error('help');
  return parsed;
};

/** The sentence with which limber optimize refuses its files, with names instead of paths; '' where it does not. */
const refusal = async (...words: string[]) =>
  (await failureOf(() => checkFiles(argumentsOf('optimize', ...words)))).replaceAll(`${folder}/`, '');

/** A glTF with its buffer beside it, and a picture that it names. */
function writeGltf(buffer = 'data.bin', picture = 'skin.png'): void {
  const json = {
    asset: { version: '2.0' },
    buffers: [{ uri: buffer, byteLength: 36 }],
    bufferViews: [{ buffer: 0, byteLength: 36 }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 0] },
    ],
    images: [{ uri: picture }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
  };
  writeFileSync(at('in.gltf'), JSON.stringify(json));
  writeFileSync(at('data.bin'), new Uint8Array(36));
}

describe('an output is refused where it is', () => {
  it.each(['in.glb', './in.glb', 'sub/../in.glb'])('the input, as %s', async (name) => {
    mkdirSync(at('sub'));
    writeFileSync(at('in.glb'), SQUARE_OBJ);
    expect(await refusal(at('in.glb'), `${folder}/${name}`, '--force')).toMatch(
      /in\.glb.* the input: choose another/,
    );
  });

  it.each([
    ['a link', symlinkSync],
    ['a hard link', linkSync],
  ])('%s to the input', async (_, link) => {
    link(at('in.obj'), at('out.glb'));
    expect(await refusal(at('in.obj'), at('out.glb'), '--force')).toBe(
      'out.glb leads to in.obj, which belongs to the input: choose another name.',
    );
  });

  it('in the folder of the input by way of a link to it', async () => {
    symlinkSync(folder, at('here'));
    writeFileSync(at('in.glb'), SQUARE_OBJ);
    expect(await refusal(at('in.glb'), at('here/in.glb'), '--force')).toMatch(/leads to in\.glb/);
  });

  it.each(['in.mtl', 'skin.png', 'in.obj'])('%s, which belongs to an OBJ', async (name) => {
    expect(await refusal(at('in.obj'), at('out.glb'), '--report', at(name), '--force')).toMatch(
      /^\S+, the file of --report, .*(also the input|belongs to the input): choose another name\.$/,
    );
  });

  it.each(['data.bin', 'skin.png'])('%s, which belongs to a glTF', async (name) => {
    writeGltf();
    symlinkSync(at(name), at('out.glb'));
    expect(await refusal(at('in.gltf'), at('out.glb'), '--force')).toBe(
      `out.glb leads to ${name}, which belongs to the input: choose another name.`,
    );
  });

  it('another output, under the same name or through a link', async () => {
    expect(await refusal(at('in.obj'), at('out.glb'), '--bind', at('a.json'), '--report', at('a.json'))).toBe(
      'a.json (--bind) and a.json (--report) are the same file: choose another name for one of them.',
    );
    symlinkSync(at('out.glb'), at('link.json'));
    expect(await refusal(at('in.obj'), at('out.glb'), '--report', at('link.json'))).toMatch(
      /are the same file/,
    );
    symlinkSync(at('out.glb'), at('out_lod1.glb'));
    expect(await refusal(at('in.obj'), at('out.glb'), '--lods', '0.2')).toMatch(
      /a level of --lods\) are the same file/,
    );
  });

  it('a level over the input', async () => {
    writeFileSync(at('out_lod1.glb'), SQUARE_OBJ);
    expect(await refusal(at('out_lod1.glb'), at('out.glb'), '--lods', '0.2')).toBe(
      'out_lod1.glb, a level of --lods, is also the input: choose another name for OUT.',
    );
  });

  it('a file of --engine', async () => {
    writeFileSync(at('jolt.txt'), 'compliance=1e-4');
    const words = ['--solver', 'jolt', '--engine', at('jolt.txt'), '--report', at('jolt.txt'), '--force'];
    expect(await refusal(at('in.obj'), at('out.glb'), ...words)).toMatch(/jolt\.txt.*also the input/);
  });

  it('a folder, in no folder, or a link without end', async () => {
    mkdirSync(at('sub.glb'));
    expect(await refusal(at('in.obj'), at('sub.glb'))).toBe('sub.glb is a folder: name a file.');
    expect(await refusal(at('in.obj'), at('none/out.glb'))).toMatch(/^The folder none does not exist/);
    symlinkSync(at('none/out.glb'), at('dangling.glb'));
    expect(await refusal(at('in.obj'), at('dangling.glb'))).toMatch(/^The folder none does not exist/);
    symlinkSync(at('loop.glb'), at('loop.glb'));
    expect(await refusal(at('in.obj'), at('loop.glb'))).toMatch(
      /^loop\.glb is a link that leads back to itself/,
    );
  });

  it.skipIf(process.getuid?.() === 0)('in a folder or over a file that is write-protected', async () => {
    mkdirSync(at('closed'), { mode: 0o500 });
    expect(await refusal(at('in.obj'), at('closed/out.glb'))).toMatch(/its folder is write-protected/);
    writeFileSync(at('out.glb'), '');
    chmodSync(at('out.glb'), 0o400);
    expect(await refusal(at('in.obj'), at('out.glb'), '--force')).toMatch(/out\.glb is write-protected/);
  });
});

describe('a file that is there already', () => {
  it('is overwritten if limber wrote it, and otherwise only with --force', async () => {
    writeFileSync(at('out.glb'), 'precious');
    expect(await refusal(at('in.obj'), at('out.glb'))).toBe(
      'out.glb exists and was not written by limber: name another file, or replace it with --force.',
    );
    expect(await refusal(at('in.obj'), at('out.glb'), '--force')).toBe('');
    const model = await openModel([textFile('in.obj', SQUARE_OBJ)]);
    writeFileSync(at('out.glb'), await exportGlb(model, [null], { fields: false }));
    expect(await refusal(at('in.obj'), at('out.glb'))).toBe('');
    writeFileSync(at('report.json'), '{"mine": 1}');
    expect(await refusal(at('in.obj'), at('out.glb'), '--report', at('report.json'))).toMatch(
      /^report\.json exists/,
    );
  });

  it.each([
    ['a report', '{\n  "schema": "limber-report/1",', true],
    ['a binding', '{"schema":"limber-binding/1"', true],
    ['a glTF', '{"asset":{"version":"2.0","generator":"Limber 0.1.0"}}', true],
    ['a glTF of another program', '{"asset":{"version":"2.0","generator":"Blender"}}', false],
    ['an OBJ', '# Limber 0.1.0\nv 0 0 0\n', true],
    ['an OBJ that speaks of limber', '# Limberger\nv 0 0 0\n', false],
    ['a PLY', 'ply\nformat ascii 1.0\ncomment Limber 0.1.0\n', true],
    ['another JSON', '{"note":"limber-report/1"}', false],
    ['broken JSON', '{', false],
    ['an empty file', '', true],
    ['a cut GLB', 'glTF', false],
  ])('%s carries its mark or not', (_, text, expected) => {
    expect(isOwnContent(new TextEncoder().encode(text))).toBe(expected);
  });
});

describe('writing', () => {
  it('follows a link, which stays, and keeps the permissions of the file', () => {
    mkdirSync(at('store'));
    writeFileSync(at('store/real.glb'), 'old');
    chmodSync(at('store/real.glb'), 0o640);
    symlinkSync('store/real.glb', at('middle.glb'));
    symlinkSync('middle.glb', at('out.glb'));
    writeWhole(at('out.glb'), 'new');
    expect(readFileSync(at('store/real.glb'), 'utf8')).toBe('new');
    expect(statSync(at('store/real.glb')).mode & 0o777).toBe(0o640);
    expect([at('out.glb'), at('middle.glb')].every((path) => lstatSync(path).isSymbolicLink())).toBe(true);
    expect(readdirSync(at('store'))).toEqual(['real.glb']);
  });

  it('creates the target of a link if it does not exist yet', () => {
    symlinkSync('real.glb', at('out.glb'));
    writeWhole(at('out.glb'), 'new');
    expect(readFileSync(at('real.glb'), 'utf8')).toBe('new');
    expect(lstatSync(at('out.glb')).isSymbolicLink()).toBe(true);
  });

  it('leaves the old file and nothing else if it fails', () => {
    writeFileSync(at('out.glb'), 'old');
    expect(() => writeWhole(at('out.glb'), null as unknown as string)).toThrow(/^\S+ cannot be written: /);
    expect(readFileSync(at('out.glb'), 'utf8')).toBe('old');
    expect(readdirSync(folder).filter((name) => name.endsWith('.part'))).toEqual([]);
  });

  it('removes what killed processes of this machine have left in the folder, and nothing of others', () => {
    const { pid } = spawnSync(process.execPath, ['--version']);
    const others = [
      `.a.glb.${process.ppid}@${hostname()}.part`,
      `.a.glb.${pid}@elsewhere.part`,
      '.mine.part',
    ];
    for (const name of [...others, `.a.glb.${pid}@${hostname()}.part`]) writeFileSync(at(name), 'half');
    writeWhole(at('out.glb'), 'new');
    expect(readdirSync(folder).filter((name) => name.endsWith('.part'))).toEqual(others.sort());
  });

  it('accepts every name that the system accepts', () => {
    for (const name of ['a'.repeat(255), 'ü'.repeat(127), '🦊'.repeat(63)]) {
      writeWhole(at(name), 'new');
      expect(readFileSync(at(name), 'utf8')).toBe('new');
    }
  });

  it('does not replace a device', () => {
    writeWhole('/dev/null', 'gone');
    expect(statSync('/dev/null').isCharacterDevice()).toBe(true);
  });
});

describe('companions', () => {
  it('are not read through a link that leaves the folder', async () => {
    mkdirSync(at('inner'));
    writeGltf();
    writeFileSync(at('inner/in.gltf'), readFileSync(at('in.gltf')));
    symlinkSync(at('data.bin'), at('inner/data.bin'));
    expect((await readModelFiles(at('inner/in.gltf'))).files).toHaveLength(1);
  });

  it('are read through a link where the model is a link to the same folder', async () => {
    writeGltf();
    mkdirSync(at('farm'));
    for (const name of ['in.gltf', 'data.bin', 'skin.png']) symlinkSync(at(name), at('farm', name));
    expect((await readModelFiles(at('farm/in.gltf'))).files).toHaveLength(3);
  });

  it.each(['../data.bin', '%2e%2e/data.bin'])('are not read from above the folder: %s', async (uri) => {
    writeGltf(uri);
    mkdirSync(at('inner'));
    writeFileSync(at('inner/in.gltf'), readFileSync(at('in.gltf')));
    expect((await readModelFiles(at('inner/in.gltf'))).files.map(({ name }) => name)).toEqual(['in.gltf']);
  });
});

describe('names', () => {
  it('are one in either case on Windows and macOS, and in either form of Unicode', () => {
    expect(nameKey('Out.GLB', 'win32')).toBe(nameKey('out.glb', 'win32'));
    expect(nameKey('caf\u00e9.glb', 'darwin')).toBe(nameKey('cafe\u0301.glb', 'darwin'));
    expect(nameKey('Out.glb', 'linux')).not.toBe(nameKey('out.glb', 'linux'));
  });

  it('of files that are not there yet are told apart by folder and name', () => {
    mkdirSync(at('sub'));
    symlinkSync(at('sub'), at('link'));
    expect(identityOf(at('link/a'))).toBe(identityOf(at('sub/a')));
    expect(identityOf(at('sub/a'))).not.toBe(identityOf(at('sub/b')));
  });
});

describe('room on the disk', () => {
  const output = (path: string, model: number, positions = 0) => ({
    path: at(path),
    flag: 'OUT',
    isGlb: true,
    capacity: { model, positions },
  });
  const disk = (free: number) => () => ({ disk: 'a', free });
  const MB = 2 ** 20;
  const size = { model: 10 * MB, positions: MB };

  it('is needed for all outputs on it together', async () => {
    const outputs = [output('a.glb', 1), output('b.glb', 1)];
    expect(() => checkRoom(outputs, size, disk(20 * MB))).not.toThrow();
    expect(await failureOf(() => checkRoom(outputs, size, disk(19 * MB)))).toBe(
      `The disk of ${folder} has 19 MB left, but the result can need 20 MB: free some space, or choose another folder.`,
    );
  });

  it('is told in tenths where little is left', async () => {
    const little = { model: 1, positions: 1 };
    expect(await failureOf(() => checkRoom([output('a.glb', 1)], little, disk(0.29 * MB)))).toBe(
      `The disk of ${folder} has 0.2 MB left, but the result can need 1.0 MB: free some space, or choose another folder.`,
    );
  });

  it('is needed for every frame of a recording', () => {
    expect(() => checkRoom([output('a.glb', 0, 61)], size, disk(61 * MB))).not.toThrow();
    expect(() => checkRoom([output('a.glb', 0, 61)], size, disk(60 * MB))).toThrow(/61 MB/);
  });

  it('is not checked if the file system does not report it, nor for stdout and devices', () => {
    expect(() => checkRoom([output('a.glb', 1)], size, () => null)).not.toThrow();
    const others = ['-', '/dev/null'].map((path) => ({ ...output('a', 1), path }));
    expect(() => checkRoom(others, size, disk(0))).not.toThrow();
  });

  it('can be read for this disk', () => {
    expect(() => checkRoom([output('a.glb', 1)], { model: 2 ** 60, positions: 0 })).toThrow(
      /MB left, but the result can need/,
    );
  });
});

describe('stdin and stdout', () => {
  const uses = { inputs: ['in.obj'], models: ['out.glb'], reports: ['-'], others: [], levels: 1 };

  it('are refused for what they cannot do', async () => {
    const sentence = (changed: object, isTerminal = false) =>
      failureOf(() => checkStandard({ ...uses, ...changed }, isTerminal));
    expect(await sentence({}, true)).toBe('');
    expect(await sentence({ inputs: ['-'] })).toBe('');
    expect(await sentence({ inputs: ['-', '-'] })).toMatch(/^stdin can be read only once/);
    expect(await sentence({ others: ['-'] })).toMatch(/^stdout takes only models and reports/);
    expect(await sentence({ models: ['-'] })).toMatch(/^--lods names the levels after OUT/);
    expect(await sentence({ models: ['-'], levels: 0 })).toMatch(/^stdout takes the model or the report/);
    expect(await sentence({ models: ['-'], levels: 0, reports: [] }, true)).toMatch(/^stdout is a terminal/);
    expect(await sentence({ models: ['-'], levels: 0, reports: [] })).toBe('');
  });

  it('are read to the end', async () => {
    async function* chunks() {
      yield await Promise.resolve(new Uint8Array([1, 2]));
      yield new Uint8Array([3]);
    }
    expect(await readStandard(chunks())).toEqual(new Uint8Array([1, 2, 3]));
    await expect(readStandard(Object.assign(chunks(), { isTTY: true }))).rejects.toThrow(/is a terminal/);
  });
});

describe('a level that fails', () => {
  it('leaves those before it, and the sentence names them', async () => {
    const args = argumentsOf('optimize', at('in.obj'), at('out.glb'), '--lods', '0.5,0.2,0.1');
    const level = (i: number) =>
      i === 1
        ? Promise.reject(new Error('There is no room.'))
        : Promise.resolve({
            files: [{ name: 'a', bytes: new Uint8Array([i]) }],
            bodies: [],
            report: {},
            faces: 0,
          });
    const output = { level } as unknown as Parameters<typeof writeLevels>[1];
    const { written, failure } = await writeLevels(args, output, (path, [{ bytes }]) =>
      writeWhole(path, bytes),
    );
    const [first, second] = levelFiles(args);
    expect(written.map(({ report }) => report.file)).toEqual([first]);
    expect(failure).toEqual({
      code: 1,
      sentence: `${second} is not written: There is no room; ${at('out.glb')}, ${first} are`,
    });
    expect(levelFiles(args).map((path) => existsSync(path))).toEqual([true, false, false]);
  });
});

describe('a target', () => {
  it.each(PRESET_NAMES)('is half of the faces with the preset %s, whose limits are no targets', (name) => {
    const settings = { ...defaultSettings(), ...settingsOfPreset(name) };
    const asked = { faces: null, ratio: null, settings };
    expect(faceTarget({ ...asked, named: new Set() })).toEqual({ faces: null, ratio: 0.5 });
    for (const limit of LIMITS)
      expect(faceTarget({ ...asked, named: new Set([limit]) }).ratio).toBe(settings[limit] > 0 ? null : 0.5);
  });

  it('that is a limit is missed if the user gave it and the result violates it', () => {
    const limits = { maxDeviation: 1, maxFrequencyError: 5 };
    const found = { deviation: 1.2, frequencyError: 6 };
    expect(brokenLimits(limits, new Set(), found)).toEqual([]);
    expect(brokenLimits(limits, new Set(['maxDeviation', 'maxFrequencyError'] as const), found)).toEqual([
      'The surface deviates by 1.20 %, more than the limit of 1 %',
      'Frequencies are off by 6.00 %, more than the limit of 5 %',
    ]);
    const kept = { deviation: 1.00001, frequencyError: 5 };
    expect(brokenLimits(limits, new Set(['maxDeviation', 'maxFrequencyError'] as const), kept)).toEqual([]);
    expect(brokenLimits({ ...limits, maxDeviation: 0 }, new Set(['maxDeviation'] as const), found)).toEqual(
      [],
    );
  });
});
