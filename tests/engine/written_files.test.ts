/** What is written as OBJ and ZIP, what a file leaves out, and files of the user beside those of limber. */

import type { Document, Extension } from '@gltf-transform/core';
import { execFileSync, spawnSync } from 'node:child_process';
import {
  EXTMeshGPUInstancing,
  EXTMeshoptCompression,
  EXTTextureAVIF,
  EXTTextureWebP,
  KHRDracoMeshCompression,
  KHRLightsPunctual,
  KHRMeshQuantization,
  KHRTextureBasisu,
  KHRTextureTransform,
} from '@gltf-transform/extensions';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { isOwnContent } from '../../web/cli/output_files/own_files';
import { writeZip } from '../../web/engine/document/archive/write_zip';
import { openModel } from '../../web/engine/document/open';
import { listLost, lostIn } from '../../web/engine/document/write/lost';
import { writePly } from '../../web/engine/document/write/ply_file';
import { writeObj } from '../../web/engine/document/write/obj_files';
import { filesOf } from '../../web/library/models';
import { SQUARE_OBJ, textFile } from './support/files';
import { addMesh, floats, primitiveOf, startDocument } from './support/gltf';
import { grid, toObj, torus } from './support/shapes';

const program = new URL('../../dist/cli/limber.mjs', import.meta.url).pathname;
const folder = mkdtempSync(join(tmpdir(), 'limber-written-'));
const path = (name: string) => join(folder, name);

function limber(words: string) {
  const { status, stderr } = spawnSync(process.execPath, [program, ...words.split(' ')], {
    cwd: folder,
    encoding: 'utf8',
    timeout: 60_000,
  });
  return { code: status, stderr };
}

afterAll(() => rmSync(folder, { recursive: true, force: true }));

/** An attribute with the same numbers at each of four vertices. */
const atFourVertices = (document: Document, type: 'VEC3' | 'VEC4', values: number[]) =>
  floats(
    document,
    type,
    [0, 1, 2, 3].flatMap(() => values),
  );

describe('a written OBJ', () => {
  const written = (document: ReturnType<typeof startDocument>) =>
    new TextDecoder().decode(writeObj(document, 'a.obj', { libraries: [], mark: 'Limber 1' })[0].bytes);

  it('can have more vertices than a function has arguments', () => {
    const document = startDocument();
    addMesh(document, 'sheet', [primitiveOf(document, grid(400, 400))]);
    const text = written(document);
    expect(text.match(/^v /gm)).toHaveLength(401 * 401);
    expect(text.match(/^f /gm)).toHaveLength(2 * 400 * 400);
  });

  it('has every instance of a node at its place, and a PLY all of them', () => {
    const document = startDocument();
    addMesh(document, 'sheet', [primitiveOf(document, grid(1, 1))]);
    const [node] = document.getRoot().listNodes();
    const instances = document
      .createExtension(EXTMeshGPUInstancing)
      .createInstancedMesh()
      .setAttribute('TRANSLATION', floats(document, 'VEC3', [10, 0, 0, 20, 0, 0]))
      .setAttribute('ROTATION', floats(document, 'VEC4', [0, 0, 0, 1, 0, 0, 2, 2]))
      .setAttribute('SCALE', floats(document, 'VEC3', [1, 1, 1, 2, 1, 1]));
    node.setTranslation([0, 0, 5]).setExtension('EXT_mesh_gpu_instancing', instances);
    expect(lostIn('obj', { document })).toEqual([]);
    const text = written(document);
    expect(text.match(/^o .*/gm)).toEqual(['o sheet', 'o sheet 2']);
    const points = [...text.matchAll(/^v (.*)$/gm)].map(([, line]) =>
      line.split(' ').map((word) => Math.round(100 * Number(word)) / 100),
    );
    const { positions } = grid(1, 1);
    const own = Array.from({ length: 4 }, (_, v) => [...positions.subarray(3 * v, 3 * v + 3)]);
    // The second is twice as wide, and turned by a right angle about z.
    expect(points).toEqual([
      ...own.map(([x, y, z]) => [x + 10, y, z + 5]),
      ...own.map(([x, y, z]) => [20 - y, 2 * x, z + 5]),
    ]);
    const ply = new TextDecoder('latin1').decode(writePly(document, 'a.ply', 'Limber 1').bytes);
    expect(ply).toMatch(/element vertex 8\nproperty/);
  });

  it('has a skin in its pose with all influences of its vertices', () => {
    const document = startDocument();
    const primitive = primitiveOf(document, grid(1, 1));
    const everywhere = (values: number[]) => atFourVertices(document, 'VEC4', values);
    primitive
      .setAttribute('JOINTS_0', everywhere([0, 1, 2, 3]))
      .setAttribute('JOINTS_1', everywhere([4, 0, 0, 0]))
      .setAttribute('WEIGHTS_0', everywhere([0.1, 0.1, 0.05, 0.05]))
      .setAttribute('WEIGHTS_1', everywhere([0.7, 0, 0, 0]));
    addMesh(document, 'A', [primitive]);
    const skin = document.createSkin();
    for (const x of [0, 0, 0, 0, 10]) skin.addJoint(document.createNode().setTranslation([x, 0, 0]));
    document.getRoot().listNodes()[0].setSkin(skin);
    expect(written(document)).toMatch(/^v 7 0 0$/m);
  });

  it('has morph targets at the default weights of the node, otherwise of the mesh, and so does a PLY', () => {
    const document = startDocument();
    const sheet = primitiveOf(document, grid(1, 1));
    const everywhere = (values: number[]) => atFourVertices(document, 'VEC3', values);
    const [right, up] = [5, 7].map((x) =>
      document.createPrimitiveTarget().setAttribute('POSITION', everywhere([x, 0, 0])),
    );
    up.setAttribute('NORMAL', everywhere([0, 3, -1]));
    sheet
      .setAttribute('NORMAL', everywhere([0, 0, 1]))
      .addTarget(right)
      .addTarget(up);
    const mesh = addMesh(document, 'sheet', [sheet]).setWeights([1, 0]);
    const [node] = document.getRoot().listNodes();
    node.setScale([2, 1, 1]);
    const { positions } = grid(1, 1);
    const x = Array.from({ length: 4 }, (_, v) => positions[3 * v]);
    const writtenX = () => [...written(document).matchAll(/^v (\S+)/gm)].map(([, word]) => Number(word));
    expect(writtenX()).toEqual(x.map((own) => 2 * (own + 5)));
    expect(written(document)).toMatch(/^vn 0 0 1$/m);
    const ply = new DataView(writePly(document, 'a.ply', 'Limber 1').bytes.buffer);
    const start = ply.byteLength - 2 * 13 - 4 * 24;
    expect(x.map((_, v) => ply.getFloat32(start + 24 * v, true))).toEqual(writtenX());
    node.setWeights([0.5, 1]);
    expect(writtenX()).toEqual(x.map((own) => 2 * (own + 9.5)));
    expect(written(document)).toMatch(/^vn 0 1 0$/m);
    expect(mesh.getWeights()).toEqual([1, 0]);
  });

  it('has the UVs that the picture of the colour is on, and so does a PLY; the others are said to be lost', () => {
    const document = startDocument();
    const textured = document.createMaterial('painted').setBaseColorTexture(document.createTexture('paint'));
    textured.setNormalTexture(document.createTexture('bumps'));
    const sheet = primitiveOf(document, grid(1, 1)).setMaterial(textured);
    for (const set of [0, 1, 2])
      sheet.setAttribute(
        `TEXCOORD_${set}`,
        floats(
          document,
          'VEC2',
          [0, 0, 1, 0, 0, 1, 1, 1].map((value) => value / 2 ** set),
        ),
      );
    addMesh(document, 'sheet', [sheet]);
    const info = textured.getBaseColorTextureInfo()!.setTexCoord(1);
    const lost = (...names: number[]) =>
      `further sets of UVs (${names.map((name) => `TEXCOORD_${name}`).join(', ')})`;
    expect(written(document)).toContain('vt 0.5 0.5\n');
    expect(lostIn('obj', { document })).toContain(lost(0, 2));
    const ply = new DataView(writePly(document, 'a.ply', 'Limber 1').bytes.slice(-2 * 13 - 20).buffer);
    expect([ply.getFloat32(12, true), ply.getFloat32(16, true)]).toEqual([0.5, 0.5]);
    const transform = document.createExtension(KHRTextureTransform).createTransform();
    info.setExtension('KHR_texture_transform', transform.setTexCoord(2));
    expect(written(document)).toContain('vt 0.25 0.75\n');
    expect(lostIn('ply', { document })).toContain(lost(0, 1));
    textured.setBaseColorTexture(null).getNormalTextureInfo()!.setTexCoord(1);
    expect(written(document)).toContain('vt 0.5 0.5\n');
    textured.setEmissiveTexture(document.createTexture('glow')).getEmissiveTextureInfo()!.setTexCoord(7);
    expect(written(document)).toContain('vt 1 0\n');
  });

  it('gives a mesh without material none after one that has one', () => {
    const document = startDocument();
    const red = primitiveOf(document, grid(1, 1)).setMaterial(document.createMaterial('red'));
    addMesh(document, 'A', [red]);
    addMesh(document, 'B', [primitiveOf(document, grid(1, 1))]);
    const lines = written(document).split('\n');
    const named = lines.filter((line) => /^(o|usemtl) /.test(line));
    expect(named).toEqual(['o A', 'usemtl red', 'o B', 'usemtl none']);
  });
});

describe('what a format leaves out', () => {
  it('names sets of UVs, attributes, and what not all meshes have', () => {
    const document = startDocument();
    const full = primitiveOf(document, grid(1, 1));
    for (const name of ['TEXCOORD_0', 'TEXCOORD_1', '_WEIGHT'])
      full.setAttribute(name, floats(document, 'VEC2', [0, 0, 1, 0, 0, 1, 1, 1]));
    addMesh(document, 'A', [full]);
    addMesh(document, 'B', [primitiveOf(document, grid(1, 1))]);
    expect(lostIn('obj', { document })).toEqual(['further sets of UVs (TEXCOORD_1)', 'attribute _WEIGHT']);
    expect(lostIn('ply', { document })).toEqual([
      'UVs, which not all of its meshes have',
      'further sets of UVs (TEXCOORD_1)',
      'attribute _WEIGHT',
    ]);
    expect(lostIn('glb', { document })).toEqual([]);
  });

  it('names opacity of vertex colours, tangents, colours of some parts, and primitives of points and lines', () => {
    const document = startDocument();
    const everywhere = (...values: number[]) =>
      floats(
        document,
        'VEC4',
        [0, 1, 2, 3].flatMap(() => values),
      );
    const sheet = () => primitiveOf(document, grid(1, 1));
    const full = sheet().setAttribute('TANGENT', everywhere(1, 0, 0, 1));
    addMesh(document, 'A', [full, sheet().setMode(1)]);
    expect(lostIn('ply', { document })).toEqual(['1 primitive of points or lines', 'tangents']);
    full.setAttribute('COLOR_0', everywhere(1, 1, 1, 1));
    expect(lostIn('obj', { document })).toEqual(['1 primitive of points or lines', 'tangents']);
    full.setAttribute('COLOR_0', everywhere(1, 1, 1, 0.5));
    addMesh(document, 'B', [sheet()]);
    const opacity = ['1 primitive of points or lines', 'opacity of vertex colours', 'tangents'];
    expect(lostIn('obj', { document })).toEqual(opacity);
    document.getRoot().listMeshes()[0].addPrimitive(sheet());
    expect(lostIn('obj', { document })).toContain('vertex colours, which not all parts of a mesh have');
    expect(lostIn('glb', { document })).toEqual([]);
  });

  it('is no extension of how numbers and pictures are stored', () => {
    const document = startDocument();
    const stored = [
      EXTMeshoptCompression,
      EXTTextureAVIF,
      EXTTextureWebP,
      KHRDracoMeshCompression,
      KHRMeshQuantization,
      KHRTextureBasisu,
    ];
    for (const extension of stored) document.createExtension<Extension>(extension);
    addMesh(document, 'A', [primitiveOf(document, grid(1, 1))]);
    expect(lostIn('obj', { document })).toEqual([]);
    expect(lostIn('ply', { document })).toEqual([]);
    document.createExtension(KHRLightsPunctual);
    expect(lostIn('obj', { document })).toEqual(['extension KHR_lights_punctual']);
  });

  it('says "extensions" and "attributes" once in a list for a sentence', () => {
    const lost = ['attribute _A', '1 skin', 'attribute _B', 'extension X'];
    expect(listLost(lost)).toBe('1 skin, attributes _A, _B, extension X');
    expect(listLost([])).toBe('');
  });

  it('names meshes of other scenes and of none', () => {
    const document = startDocument();
    for (const name of ['A', 'B', 'C']) addMesh(document, name, [primitiveOf(document, grid(1, 1))]);
    const [scene] = document.getRoot().listScenes();
    const [, second, third] = scene.listChildren();
    document.createScene('other').addChild(second);
    scene.removeChild(second).removeChild(third);
    expect(lostIn('obj', { document })).toEqual(['1 further scene', '2 meshes outside of the scene']);
    expect(lostIn('glb', { document })).toEqual([]);
  });

  it('names further scenes that show a mesh of the first at another place', () => {
    const document = startDocument();
    const mesh = addMesh(document, 'ball', [primitiveOf(document, grid(1, 1))]);
    const [scene] = document.getRoot().listScenes();
    const again = document.createScene('the same').addChild(scene.listChildren()[0]);
    expect(lostIn('ply', { document })).toEqual([]);
    again.addChild(document.createNode('more').setMesh(mesh));
    document.createScene('another').addChild(document.createNode('more').setMesh(mesh));
    expect(lostIn('ply', { document })).toEqual(['2 further scenes']);
    expect(lostIn('obj', { document })).toEqual(['2 further scenes']);
    expect(lostIn('glb', { document })).toEqual([]);
  });
});

describe('a document of a caller', () => {
  it('may have been read from a folder beside that of its file', async () => {
    const document = startDocument();
    addMesh(document, 'sheet', [primitiveOf(document, grid(2, 2))]);
    document.getRoot().listBuffers()[0].setURI('../parts/m.bin');
    const { bodies } = await openModel(await filesOf(document));
    expect(bodies[0].indices).toHaveLength(3 * 8);
  });
});

describe('the mark of a ZIP', () => {
  it('is a field of its first entry, not any text in it', () => {
    const stored = (name: string, text: string) => [textFile(name, text)];
    expect(isOwnContent(writeZip(stored('a.obj', SQUARE_OBJ), 'Limber 1.0'))).toBe(true);
    const foreign = writeZip(stored('Limber 2 notes.png', '# Limber 1.0'), 'another program');
    expect(isOwnContent(foreign)).toBe(false);
    expect(isOwnContent(foreign.subarray(0, 20))).toBe(false);
  });
});

describe('a file of the user', () => {
  beforeAll(() => writeFileSync(path('plain.obj'), toObj(torus())));

  it('beside a result of limber is not replaced by the companion of another', () => {
    expect(limber('optimize plain.obj chair.gltf').code).toBe(0);
    writeFileSync(path('chair.bin'), 'old');
    // The glTF that is there names the file, so that it is a part of what limber wrote.
    expect(limber('optimize plain.obj chair.gltf').code).toBe(0);
    writeFileSync(
      path('table.gltf'),
      JSON.stringify({ asset: { version: '2.0', generator: 'Limber 0.1.0' } }),
    );
    writeFileSync(path('table.bin'), 'mine');
    const { code, stderr } = limber('optimize plain.obj table.gltf');
    expect([code, stderr]).toEqual([
      1,
      expect.stringContaining('table.bin, which belongs to table.gltf, exists'),
    ]);
    expect(readFileSync(path('table.bin'), 'utf8')).toBe('mine');
  });

  it('beside an empty model is the user’s', () => {
    writeFileSync(path('empty.gltf'), '');
    writeFileSync(path('empty.bin'), 'mine');
    const { code, stderr } = limber('optimize plain.obj empty.gltf');
    expect([code, stderr]).toEqual([
      1,
      expect.stringContaining('empty.bin, which belongs to empty.gltf, exists'),
    ]);
  });

  it('that is no library of an OBJ, but a folder or a pipe, is not read as one', () => {
    execFileSync('mkfifo', [path('pipe.mtl')]);
    writeFileSync(path('odd.obj'), `mtllib ./\nmtllib pipe.mtl\n${toObj(torus())}`);
    expect(limber('optimize odd.obj odd.glb').code).toBe(0);
    expect(existsSync(path('odd.glb'))).toBe(true);
  });

  it('ends with the code of a broken pipe, without a word, where the reader of stdout has left', () => {
    const script = `(sleep 0.2; "${process.execPath}" "${program}" "$@"; echo $? > code) | true`;
    for (const words of ['optimize plain.obj - --quiet', 'inspect plain.obj --json', '--help', '--version']) {
      const { stderr } = spawnSync('bash', ['-c', `${script}; sleep 0.1`, 'bash', ...words.split(' ')], {
        cwd: folder,
        encoding: 'utf8',
      });
      expect([words, readFileSync(path('code'), 'utf8'), stderr]).toEqual([words, '141\n', '']);
    }
  });

  it('is not said to be written where stdout fails', () => {
    const run = (words: string) =>
      spawnSync('sh', ['-c', `"${process.execPath}" "${program}" ${words} > /dev/full`], {
        cwd: folder,
        encoding: 'utf8',
      });
    for (const words of ['optimize plain.obj -', 'inspect plain.obj --json']) {
      const { status, stderr } = run(words);
      expect([status, stderr]).toEqual([
        1,
        expect.stringContaining('stdout cannot be written: the disk is full.'),
      ]);
    }
  });
});
