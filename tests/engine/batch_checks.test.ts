/** What limber batch refuses or warns of before any work, also with --dry-run. */

import { spawnSync } from 'node:child_process';
import { chmodSync, existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeEach, describe, expect, it } from 'vitest';
import { SQUARE_OBJ } from './support/files';

const program = new URL('../../dist/cli/limber.mjs', import.meta.url).pathname;
const top = mkdtempSync(join(tmpdir(), 'limber-checks-'));
chmodSync(top, 0o755);
let folder: string;
let runs = 0;
const path = (name: string) => join(folder, name);

/** `user`: who runs it; permissions do not bind root. */
function batch(words: string[], user?: number) {
  const { status, stdout, stderr } = spawnSync(process.execPath, [program, 'batch', ...words], {
    cwd: folder,
    encoding: 'utf8',
    ...(user === undefined ? {} : { uid: user, gid: user }),
  });
  return { code: status, stdout, stderr };
}

/** Another user than root, where root runs the tests. */
const nobody = process.getuid?.() === 0 ? 65534 : undefined;
/** Whether that user can run the program, which may lie in a folder of root's alone. */
const isReachable =
  spawnSync(process.execPath, [program, '--version'], nobody === undefined ? {} : { uid: nobody }).status ===
  0;

const configure = (value: object) =>
  writeFileSync(path('b.json'), JSON.stringify({ schema: 'limber-batch/1', ...value }));

beforeEach(() => {
  folder = join(top, String(++runs));
  mkdirSync(path('src'), { recursive: true });
  writeFileSync(path('src/a.obj'), SQUARE_OBJ);
  writeFileSync(path('src/b.obj'), SQUARE_OBJ);
});
afterAll(() => rmSync(top, { recursive: true, force: true }));

describe('before any work limber batch', () => {
  /** Both ways end alike, and nothing is made. */
  function refuses(words: string[], sentence: string, user?: number) {
    for (const all of [words, [...words, '--dry-run']])
      expect(batch(all, user)).toEqual({ code: 1, stdout: '', stderr: `limber: ${sentence}\n` });
    expect(existsSync(path('out'))).toBe(false);
  }

  it.skipIf(!isReachable)('refuses a folder that the system does not let it write into', () => {
    mkdirSync(path('closed/.limber-batch'), { recursive: true });
    chmodSync(path('closed/.limber-batch'), 0o555);
    const closed = 'closed cannot be written: the folder is write-protected, so choose another one.';
    if (nobody === undefined) refuses(['src', 'closed'], closed);
    chmodSync(path('closed'), 0o555);
    refuses(['src', 'closed'], closed, nobody);
    refuses(
      ['src', 'closed/x/y'],
      `closed/x/y cannot be written: ${path('closed')} is write-protected, so choose another one.`,
      nobody,
    );
    for (const name of ['closed', 'closed/.limber-batch']) chmodSync(path(name), 0o755);
  });

  it('refuses options that the format of the results cannot have', () => {
    const compressed = 'OBJ cannot be compressed by draco: write .glb or .gltf, or leave it out.';
    const levels = 'OBJ has no levels of detail inside: write .glb or .gltf, or one file for each level.';
    refuses(['src', 'out', '--format', 'obj', '--compress', 'draco'], compressed);
    refuses(['src', 'out', '--format', 'obj.zip', '--lods', '0.2', '--lod-style', 'msft'], levels);
    configure({ options: { format: 'obj', compress: 'draco' } });
    refuses(['src', 'out', '--config', 'b.json'], compressed);
    configure({ options: { compress: 'draco' }, overrides: [{ files: 'b.*', options: { format: 'obj' } }] });
    refuses(['src', 'out', '--config', 'b.json'], `b.obj: ${compressed}`);
  });

  it('drops the compression of a preset if the format has none, with one note', () => {
    const words = ['src', 'out', '--preset', 'mobile', '--format', 'obj', '--dry-run'];
    const note = 'limber: OBJ cannot be compressed: quantized of --preset mobile is left out.\n';
    expect(batch(words)).toMatchObject({ code: 0, stderr: note });
    configure({ overrides: [{ files: 'b.obj', options: { compress: 'quantized' } }] });
    refuses(
      [...words.slice(0, -1), '--config', 'b.json'],
      'b.obj: OBJ cannot be compressed by quantized: write .glb or .gltf, or leave it out.',
    );
  });

  it('refuses settings files where no asset has a solver', () => {
    const sentence = expect.stringMatching(
      /^limber: --settings-files needs a solver: --solver shell\|/,
    ) as string;
    expect(batch(['src', 'out', '--settings-files'])).toMatchObject({ code: 1, stderr: sentence });
    configure({
      options: { settingsFiles: true },
      overrides: [{ files: 'a.obj', options: { solver: 'shell', settingsFiles: false } }],
    });
    expect(batch(['src', 'out', '--config', 'b.json'])).toMatchObject({ code: 1, stderr: sentence });
    configure({
      options: { settingsFiles: true },
      overrides: [{ files: 'a.obj', options: { solver: 'shell' } }],
    });
    expect(batch(['src', 'out', '--config', 'b.json', '--dry-run'])).toMatchObject({ code: 0, stderr: '' });
  });

  it('takes a report into the folder that it makes, and not over what it writes there itself', () => {
    for (const name of ['out/a.glb', 'out/a_lod1.glb', './out/summary.html'])
      refuses(
        ['src', 'out', '--lods', '0.2', '--report', name],
        `${name}, the file of --report, is also written by the batch itself: choose another name.`,
      );
    refuses(['src', 'out', '--report', 'out/x/r.json'], 'The folder out/x does not exist: create it first.');
    expect(batch(['src', 'out/deep', '--report', 'out/r.json', '--method', 'qem'])).toMatchObject({
      code: 0,
    });
    expect(existsSync(path('out/r.json'))).toBe(true);
  });

  it('names each pattern of an override that matches no asset, once', () => {
    configure({
      overrides: [
        { files: ['a.*', 'hreo/**'], options: { ratio: 0.9 } },
        { files: 'nope/**', options: { ratio: 0.9 } },
      ],
    });
    const told = (i: number, pattern: string) =>
      `limber: b.json: overrides[${i}].files has "${pattern}", which matches no asset: check its spelling.\n`;
    const words = ['src', 'out', '--config', 'b.json'];
    const both = told(0, 'hreo/**') + told(1, 'nope/**');
    expect(batch([...words, '--dry-run'])).toMatchObject({ code: 0, stderr: both });
    expect(batch([...words, '--dry-run', '--quiet']).stderr).toBe('');
    expect(batch([...words, '--method', 'qem']).stderr.startsWith(both)).toBe(true);
  });
});
