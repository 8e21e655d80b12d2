/** What limber batch may replace in OUT: files beside results, as buffers and pictures that several assets share. */

import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { Document, Format, WebIO } from '@gltf-transform/core';
import { afterAll, beforeEach, describe, expect, it } from 'vitest';
import { encodePng } from '../../web/cli/batch/picture/png';
import type { Summary } from '../../web/cli/batch/summary';
import { addMesh, primitiveOf, startDocument } from './support/gltf';
import { grid } from './support/shapes';

const program = new URL('../../dist/cli/limber.mjs', import.meta.url).pathname;
const top = mkdtempSync(join(tmpdir(), 'limber-results-'));
let folder: string;
let runs = 0;
const path = (name: string) => join(folder, name);
const bytes = (name: string) => readFileSync(path(name));
const remove = (...names: string[]) => names.forEach((name) => rmSync(path(name), { recursive: true }));

function write(name: string, content: string | Uint8Array): void {
  mkdirSync(dirname(path(name)), { recursive: true });
  writeFileSync(path(name), content);
}

const picture = (grey: number): Uint8Array =>
  encodePng({ width: 1, height: 1, pixels: new Uint8Array([grey]) });

/** A sheet whose buffer is `NAME.bin` and whose picture is wood.png. */
async function writeSheet(name: string, cells: number, grey: number): Promise<void> {
  const document: Document = startDocument();
  const wood = document.createTexture('wood').setURI('wood.png').setImage(picture(grey).slice());
  const material = document.createMaterial('wood').setBaseColorTexture(wood.setMimeType('image/png'));
  addMesh(document, 'sheet', [primitiveOf(document, grid(cells, cells)).setMaterial(material)]);
  const basename = name.split('/').pop()!;
  const { json, resources } = await new WebIO().writeJSON(document, { format: Format.GLTF, basename });
  write(`${name}.gltf`, JSON.stringify(json));
  for (const [other, content] of Object.entries(resources)) write(join(dirname(name), other), content);
}

/** Writes glTF with one job, so that of two assets the one with the larger file is done first. */
function batch(...words: string[]) {
  const all = ['batch', ...words, 'out', '--format', 'gltf', '--jobs', '1', '--quiet'];
  const { status, stderr } = spawnSync(process.execPath, [program, ...all], {
    cwd: folder,
    encoding: 'utf8',
  });
  const { totals } = JSON.parse(bytes('out/summary.json').toString()) as Summary;
  return { code: status, stderr, done: totals.done - totals.unchanged };
}

beforeEach(async () => {
  folder = join(top, String(++runs));
  await writeSheet('src/a', 4, 100);
});
afterAll(() => rmSync(top, { recursive: true, force: true }));

describe('files beside results', () => {
  it('are written again if they are missing, also after they have been written with the same bytes', () => {
    batch('src');
    expect(batch('src', '--again')).toMatchObject({ code: 0, done: 1 });
    for (const name of ['out/a.bin', 'out/wood.png']) {
      const before = bytes(name);
      remove(name);
      expect(batch('src')).toMatchObject({ code: 0, done: 1 });
      expect(bytes(name).equals(before)).toBe(true);
    }
    expect(batch('src').done).toBe(0);
  });

  it('count towards the size of the result, unlike levels and reports', () => {
    batch('src', '--lods', '0.5', '--reports');
    const { assets } = JSON.parse(bytes('out/summary.json').toString()) as Summary;
    const sizes = ['a.gltf', 'a.bin', 'wood.png'].map((name) => bytes(`out/${name}`).length);
    expect(assets[0].bytesAfter).toBe(sizes.reduce((all, size) => all + size));
    const before = ['a.gltf', 'a.bin', 'wood.png'].map((name) => bytes(`src/${name}`).length);
    expect(assets[0].bytesBefore).toBe(before.reduce((all, size) => all + size));
  });

  it('do not block a run if the model or the record is missing, as after a kill', () => {
    batch('src');
    remove('out/a.gltf');
    write('src/wood.png', picture(50));
    expect(batch('src', '--ratio', '0.3', '--soft')).toMatchObject({ code: 0, stderr: '', done: 1 });
    remove('out/a.gltf', 'out/.limber-batch');
    expect(batch('src', '--ratio', '0.3', '--soft')).toMatchObject({ code: 0, stderr: '', done: 1 });
    remove('out/.limber-batch');
    expect(batch('src', '--ratio', '0.6')).toMatchObject({ code: 0, stderr: '', done: 1 });
  });

  it('are still recognised after their asset has failed', () => {
    batch('src');
    const whole = bytes('src/a.gltf');
    write('src/a.gltf', '{');
    expect(batch('src').code).toBe(1);
    write('src/a.gltf', whole);
    remove('out/a.gltf');
    expect(batch('src', '--ratio', '0.3', '--soft')).toMatchObject({ code: 0, stderr: '', done: 1 });
  });

  it('never overwrite files of the user; the asset fails instead', () => {
    write('out/a.bin', 'mine');
    expect(batch('src')).toMatchObject({
      code: 1,
      stderr:
        'limber: a.gltf: out/a.bin exists and was not written by a batch: choose another folder for the results, or replace it with --force.\n',
    });
    expect([bytes('out/a.bin').toString(), existsSync(path('out/a.gltf'))]).toEqual(['mine', false]);
    expect(existsSync(path('out/wood.png'))).toBe(false);
    expect(batch('src', '--force')).toMatchObject({ code: 0, done: 1 });
  });
});

describe('a picture of several assets', () => {
  it('is replaced where it has changed for all of them', async () => {
    for (const [i, name] of ['b', 'c'].entries()) await writeSheet(`src/${name}`, 5 + i, 100);
    expect(batch('src')).toMatchObject({ code: 0, done: 3 });
    write('src/wood.png', picture(200));
    expect(batch('src')).toMatchObject({ code: 0, stderr: '', done: 3 });
    expect(bytes('out/wood.png').equals(picture(200))).toBe(true);
    expect(batch('src').done).toBe(0);
  });

  it('is not replaced by another of its name while an asset with the old one is up to date', async () => {
    batch('src');
    await writeSheet('other/larger', 20, 200);
    const failed = {
      code: 1,
      stderr: 'limber: larger.gltf: wood.png is also a result of a.gltf: rename one of them.\n',
    };
    expect(batch('src', 'other')).toMatchObject(failed);
    expect(bytes('out/wood.png').equals(picture(100))).toBe(true);
    expect(existsSync(path('out/larger.gltf'))).toBe(false);
    expect(batch('src').done).toBe(0);
  });
});
