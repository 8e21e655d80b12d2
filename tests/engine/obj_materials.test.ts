/** Material libraries of OBJ files (MTL): what they say becomes materials of glTF, and what they ask for stays in the folder. */

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Material } from '@gltf-transform/core';
import type { Transform } from '@gltf-transform/extensions';
import { contentsOf } from '../../web/engine/document/facts/contents';
import { exportGlb } from '../../web/engine/document/export';
import { exportFiles } from '../../web/engine/document/write/export_files';
import { lostIn } from '../../web/engine/document/write/lost';
import { formOfName } from '../../web/engine/document/write/output_form';
import { openModel } from '../../web/engine/document/open';
import type { OpenModel, SourceFile } from '../../web/engine/document/open';
import { validateGlb } from '../../web/engine/document/validate';
import { failureOf, SQUARE_OBJ, textFile } from './support/files';
import { pngOf } from './support/pictures';
import { processorTime } from './support/processor_time';

const VERTICES = SQUARE_OBJ.replace(/f.*\n/g, '');
const CORNERS = 'vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n';
const FACE = 'f 1/1 2/2 3/3 4/4\n';

/** A square with UVs, in a material. */
const square = (material = 'm', libraries = 'mtllib a.mtl\n', name = 'a.obj'): SourceFile =>
  textFile(name, `${libraries}${VERTICES}${CORNERS}usemtl ${material}\n${FACE}`);

const RED = pngOf([[[255, 0, 0]]]);
const CLEAR = pngOf([[[255, 0, 0, 128]]]);
const picture = (name: string, bytes = RED): SourceFile => ({ name, bytes });

const materialsOf = ({ document }: OpenModel): Material[] => document.getRoot().listMaterials();

/** The square with a library of these lines for its material, and further files. */
const opened = (lines: string, ...files: SourceFile[]): Promise<OpenModel> =>
  openModel([square(), textFile('a.mtl', `newmtl m\n${lines}\n`), ...files]);

const dressed = async (lines: string, ...files: SourceFile[]): Promise<Material> =>
  materialsOf(await opened(lines, ...files))[0];

const rounded = (values: readonly number[]): number[] => values.map((value) => Math.round(1e6 * value) / 1e6);

/** Normal maps without tangents are a warning of the validator's. */
async function glbOf(model: OpenModel): Promise<Uint8Array> {
  const bytes = await exportGlb(model, [null], { fields: false });
  expect(await validateGlb(bytes)).toMatchObject({ errors: 0 });
  return bytes;
}

const write = (model: OpenModel, name: string): Promise<SourceFile[]> =>
  exportFiles(model, [null], {
    name,
    form: formOfName(name, model.format)!,
    manner: { compression: 'like-input', style: 'files', keepsOrder: true },
    fields: false,
  });

describe('a library as programs write it', () => {
  it('of Blender: unchanged colour, roughness from the exponent, no metal', async () => {
    const material = await dressed(
      'Ns 250.000000\nKa 1.0 1.0 1.0\nKd 0.8 0.1 0.2\nKs 0.5 0.5 0.5\nKe 0 0 0\nNi 1.45\nd 1.0\nillum 2',
    );
    expect(material.getBaseColorFactor()).toEqual([0.8, 0.1, 0.2, 1]);
    expect(material.getRoughnessFactor()).toBe(0.5);
    expect(material.getMetallicFactor()).toBe(0);
    expect(material.getAlphaMode()).toBe('OPAQUE');
    expect(material.getEmissiveFactor()).toEqual([0, 0, 0]);
  });

  it('of Blender with PBR: roughness, metalness and a normal map declared as a bump map', async () => {
    const material = await dressed(
      'Pr 0.3\nPm 0.9\nPs 0\nNs 1000\nKd 0.8 0.8 0.8\nmap_Kd skin.png\nmap_Bump -bm 0.500000 skin_normal.png',
      ...['skin.png', 'skin_normal.png'].map((name) => picture(name)),
    );
    expect([material.getRoughnessFactor(), material.getMetallicFactor()]).toEqual([0.3, 0.9]);
    expect(material.getBaseColorTexture()!.getURI()).toBe('skin.png');
    expect(material.getNormalTexture()!.getURI()).toBe('skin_normal.png');
    expect(material.getNormalScale()).toBe(0.5);
  });

  it('of 3ds Max: absolute paths, a grey colour beside the map, and both d and Tr', async () => {
    const model = await opened(
      '\tNs 10.0\r\n\tNi 1.5\r\n\td 1.0\r\n\tTr 0.0\r\n\tTf 1 1 1\r\n\tillum 2\r\n\tKd 0.5882 0.5882 0.5882\r\n\tmap_Ka C:\\maps\\Old Wood.png\r\n\tmap_Kd C:\\maps\\Old Wood.png',
      picture('Old Wood.png'),
    );
    const [material] = materialsOf(model);
    expect(model.notes).toEqual([]);
    expect(material.getBaseColorTexture()!.getName()).toBe('Old Wood');
    expect(material.getBaseColorFactor()).toEqual([1, 1, 1, 1]);
    expect(material.getAlphaMode()).toBe('OPAQUE');
  });

  it('of Metashape: a transparency of 1 that means opaque, and no highlights', async () => {
    const material = await dressed(
      'Ka 1 1 1\nKd 1 1 1\nKs 0 0 0\nTr 1\nillum 1\nNs 900\nmap_Kd model.jpg',
      picture('model.jpg', Uint8Array.from([0xff, 0xd8, 0xff, 0xe0])),
    );
    expect(material.getBaseColorFactor()).toEqual([1, 1, 1, 1]);
    expect(material.getRoughnessFactor()).toBe(1);
    expect(material.getBaseColorTexture()!.getMimeType()).toBe('image/jpeg');
  });

  it('with a black Kd beside its map is not black, and a coloured one tints the map', async () => {
    const lines = (colour: string) => `Kd ${colour}\nmap_Kd skin.png`;
    expect((await dressed(lines('0 0 0'), picture('skin.png'))).getBaseColorFactor()).toEqual([1, 1, 1, 1]);
    expect((await dressed(lines('1 .5 0'), picture('skin.png'))).getBaseColorFactor()).toEqual([
      1, 0.5, 0, 1,
    ]);
  });
});

describe('a line of a library', () => {
  it.each([
    ['d 0.5', 0.5],
    ['Tr 0.25', 0.75],
    ['d 0.4\nTr 0.1', 0.4],
    ['d -halo 0.5', 0.5],
    ['d 0', 1],
    ['d 2', 1],
    ['d nan', 1],
  ])('%j is an alpha of %f, blended below 1', async (lines, alpha) => {
    const material = await dressed(lines);
    expect(material.getAlpha()).toBe(alpha);
    expect(material.getAlphaMode()).toBe(alpha < 1 ? 'BLEND' : 'OPAQUE');
  });

  it.each([
    ['Ns 0', 1],
    ['Ns 1000', 0],
    ['Ns 4000', 0],
    ['Ns -5', 1],
    ['Ns 90', 0.7],
    ['Ns 1000\nillum 1', 1],
    ['Ns 1000\nKs 0 0 0', 1],
    ['Ns 1000\nPr 0.4', 0.4],
    ['Pr 7', 1],
    ['', 1],
  ])('%j is a roughness of %f', async (lines, roughness) => {
    expect(rounded([(await dressed(lines)).getRoughnessFactor()])).toEqual([roughness]);
  });

  it.each([
    ['Kd 0.5', [0.5, 0.5, 0.5]],
    ['Kd 3 -1 0.25', [1, 0, 0.25]],
    ['Kd spectral a.rfl', [1, 1, 1]],
    ['Kd 0,5 0,5 0,5', [1, 1, 1]],
    ['kd 0 0 1', [0, 0, 1]],
    ['Kd 1 0 0\nKd 0 1 0', [0, 1, 0]],
  ])('%j is the colour %j', async (lines, colour) => {
    expect((await dressed(lines)).getBaseColorFactor().slice(0, 3)).toEqual(colour);
  });

  it('with emission above 1 keeps its hue', async () => {
    expect((await dressed('Ke 4 2 0')).getEmissiveFactor()).toEqual([1, 0.5, 0]);
    const lit = await dressed('Ke 0 0 0\nmap_Ke glow.png', picture('glow.png'));
    expect(lit.getEmissiveFactor()).toEqual([1, 1, 1]);
    expect(lit.getEmissiveTexture()!.getName()).toBe('glow');
  });

  it('of roughness alone becomes a texture; with metalness only if both are one picture', async () => {
    const files = [picture('r.png'), picture('m.png', CLEAR)];
    const rough = await dressed('Pr 0.2\nmap_Pr r.png', ...files);
    expect(rough.getMetallicRoughnessTexture()!.getName()).toBe('r');
    expect([rough.getRoughnessFactor(), rough.getMetallicFactor()]).toEqual([1, 0]);
    const packed = await dressed('map_Pr r.png\nmap_Pm r.png', ...files);
    expect(packed.getMetallicRoughnessTexture()!.getName()).toBe('r');
    expect([packed.getRoughnessFactor(), packed.getMetallicFactor()]).toEqual([1, 1]);
    for (const lines of ['map_Pr r.png\nmap_Pm m.png', 'Pm 1\nmap_Pr r.png', 'map_Pm m.png']) {
      const model = await opened(lines, ...files);
      expect(materialsOf(model)[0].getMetallicRoughnessTexture()).toBeNull();
      expect(model.notes.join()).toMatch(
        /roughness or metalness \(.*\) left out, because glTF stores both in one/,
      );
    }
  });

  it('of opacity is used if it is the alpha channel of the colour map', async () => {
    const lines = 'map_Kd leaf.png\nmap_d leaf.png';
    expect((await dressed(lines, picture('leaf.png', CLEAR))).getAlphaMode()).toBe('BLEND');
    const opaque = await opened(lines, picture('leaf.png'));
    expect(materialsOf(opaque)[0].getAlphaMode()).toBe('OPAQUE');
    expect(opaque.notes).toEqual([expect.stringMatching(/^1 map of opacity \(leaf\.png\) left out, /)]);
  });

  it('of a height map is left out, and that of norm is a normal map', async () => {
    const heights = await opened('bump -bm 0.2 bricks_height.png', picture('bricks_height.png'));
    expect(materialsOf(heights)[0].getNormalTexture()).toBeNull();
    expect(heights.notes).toEqual([
      expect.stringMatching(/^1 bump map \(bricks_height\.png\) left out, because glTF/),
    ]);
    const normals = await dressed('norm bricks.png\nbump b.png', picture('bricks.png'), picture('b.png'));
    expect(normals.getNormalTexture()!.getName()).toBe('bricks');
  });
});

describe('the name of a picture', () => {
  it.each([
    ['skin.png', 'skin.png'],
    ['my skin (1).png', 'my skin (1).png'],
    ['"my skin.png"', 'my skin.png'],
    ['-s 2 2 2 -o 0.5 0 0 my skin.png', 'my skin.png'],
    ['-blendu on -bm 1 -clamp on -imfchan l -mm 0 1 -texres 512 -t 0 0 skin.png', 'skin.png'],
    ['skin.png -s 2 2', 'skin.png'],
    ['-s 2 skin.png', 'skin.png'],
    ['-bm skin.png', 'skin.png'],
    ['maps\\skin.png', 'maps/skin.png'],
    ['.\\maps\\\\skin.png', 'maps/skin.png'],
    ['maps/skin.png', 'maps/skin.png'],
    ['/home/me/skin.png', 'skin.png'],
    ['../../skin.png', 'skin.png'],
    ['https://example.org/skin.png', 'skin.png'],
    ['Skin.PNG', 'skin.png'],
    ['50%20off.png', '50%20off.png'],
    ['größe.png', 'größe.png'],
    ['1.png', '1.png'],
  ])('%j is that of %j', async (line, name) => {
    const model = await opened(`map_Kd ${line}`, picture(name));
    expect(model.notes).toEqual([]);
    expect(decodeURIComponent(materialsOf(model)[0].getBaseColorTexture()!.getURI())).toBe(name);
    await glbOf(model);
  });

  it.each(['../secret.png', '..\\secret.png', '/etc/secret.png', 'C:\\secret.png', '', '.', '..', 'a\0b'])(
    '%j leads to no file outside of the folder',
    async (line) => {
      const outside = picture('../secret.png');
      const model = await opened(`map_Kd ${line}`, outside, picture('/etc/secret.png'));
      expect(materialsOf(model)[0].getBaseColorTexture()).toBeNull();
    },
  );

  it('is resolved beside the library first, then beside the model', async () => {
    const [inner, outer] = [pngOf([[[1, 1, 1]]]), pngOf([[[2, 2, 2]]])];
    const files = [
      square('m', 'mtllib mats/a.mtl\n', 'set/a.obj'),
      textFile('set/mats/a.mtl', 'newmtl m\nmap_Kd skin.png\n'),
    ];
    const imageOf = async (...pictures: SourceFile[]) =>
      materialsOf(await openModel([...files, ...pictures]))[0]
        .getBaseColorTexture()!
        .getImage();
    const [near, far] = [picture('set/mats/skin.png', inner), picture('set/skin.png', outer)];
    expect(await imageOf(far, near)).toEqual(inner);
    expect(await imageOf(far)).toEqual(outer);
    expect(await imageOf(picture('skin.png', outer))).toEqual(outer);
  });

  it('is reported if the picture is missing or of a format that glTF does not support', async () => {
    const model = await opened(
      'map_Kd none.png\nmap_Ke glow.tga\nnorm n.dds',
      picture('glow.tga', new Uint8Array(64)),
      picture('n.dds', new TextEncoder().encode('DDS ')),
    );
    expect(model.notes).toEqual([
      '1 texture (none.png) left out, missing or outside the folder: put the pictures beside the model',
      '2 textures (glow.tga, n.dds) left out, because glTF takes only PNG and JPEG: convert the pictures, and refer to the new ones in the material library',
    ]);
    expect(contentsOf(model)).toMatchObject({ materials: 1, textures: 0 });
    await glbOf(model);
  });
});

describe('textures', () => {
  it('are mapped as in OBJ: v counts from the lower edge of the picture', async () => {
    const { document } = await opened('map_Kd skin.png', picture('skin.png'));
    const uvs = document.getRoot().listMeshes()[0].listPrimitives()[0].getAttribute('TEXCOORD_0')!;
    // vt 0 0 is the lower left corner, which glTF counts as (0, 1).
    expect([0, 1, 2, 3].map((v) => uvs.getElement(v, []))).toEqual([
      [0, 1],
      [1, 1],
      [1, 0],
      [0, 0],
    ]);
  });

  it('are offset and scaled by -o and -s, also from the lower edge', async () => {
    const { document } = await opened('map_Kd -s 2 3 1 -o 0.25 0.125 0 skin.png', picture('skin.png'));
    const info = document.getRoot().listMaterials()[0].getBaseColorTextureInfo()!;
    const transform = info.getExtension<Transform>('KHR_texture_transform')!;
    const [offset, scale] = [transform.getOffset(), transform.getScale()];
    for (const [u, v] of [
      [0, 0],
      [0.3, 0.8],
    ]) {
      const [x, y] = [scale[0] * u + offset[0], scale[1] * (1 - v) + offset[1]];
      expect(rounded([x, 1 - y])).toEqual(rounded([2 * u + 0.25, 3 * v + 0.125]));
    }
    const clamped = await dressed('map_Kd -clamp on skin.png', picture('skin.png'));
    expect(clamped.getBaseColorTextureInfo()!.getWrapS()).toBe(33071);
    expect(clamped.getBaseColorTextureInfo()!.listExtensions()).toEqual([]);
  });

  it('of one picture are one texture, and an unused material has none', async () => {
    const library =
      'newmtl m\nmap_Kd a.png\nmap_Ke ./a.png\nnewmtl n\nmap_Kd A.png\nnewmtl unused\nmap_Kd b.png\n';
    const main = textFile('a.obj', `mtllib a.mtl\n${VERTICES}${CORNERS}usemtl m\n${FACE}usemtl n\n${FACE}`);
    const model = await openModel([main, textFile('a.mtl', library), picture('a.png'), picture('b.png')]);
    expect(contentsOf(model)).toMatchObject({ materials: 2, textures: 1 });
    await glbOf(model);
  });

  it('need UVs: an object without them gets only the colours', async () => {
    const text = `mtllib a.mtl\no one\n${VERTICES}${CORNERS}usemtl m\n${FACE}o two\nf 1 2 3\n`;
    const library = textFile('a.mtl', 'newmtl m\nKd 1 0 0\nmap_Kd a.png\n');
    const model = await openModel([textFile('a.obj', text), library, picture('a.png')]);
    const shown = model.document
      .getRoot()
      .listMeshes()
      .map((mesh) => mesh.listPrimitives()[0].getMaterial()!);
    expect(shown.map((material) => material.getBaseColorTexture() !== null)).toEqual([true, false]);
    expect(shown.map((material) => material.getBaseColorFactor())).toEqual([
      [1, 0, 0, 1],
      [1, 0, 0, 1],
    ]);
    const bytes = await exportGlb(model, [null, null], { fields: false });
    expect(await validateGlb(bytes)).toMatchObject({ errors: 0, warnings: 0 });
    const [main] = await exportFiles(model, [null, null], {
      name: 'b.obj',
      form: formOfName('b.obj', 'obj')!,
      manner: { compression: 'like-input', style: 'files', keepsOrder: true },
      fields: false,
    });
    expect(new TextDecoder().decode(main.bytes).match(/^usemtl .*$/gm)).toEqual(['usemtl m', 'usemtl m']);
  });
});

describe('a library', () => {
  const colours = async (...files: SourceFile[]) =>
    materialsOf(await openModel(files)).map((material) => material.getBaseColorFactor().slice(0, 3));
  const library = (name: string, colour: string, material = 'm') =>
    textFile(name, `# Blender MTL File\n\nnewmtl ${material}\nKd ${colour}\n`);

  it.each([
    ['mtllib a.mtl', 'a.mtl'],
    ['mtllib ./a.mtl', 'a.mtl'],
    ['mtllib my materials.mtl', 'my materials.mtl'],
    ['mtllib "my materials.mtl"', 'my materials.mtl'],
    ['mtllib b.mtl my materials.mtl', 'my materials.mtl'],
    ['mtllib b.mtl\nmtllib c.mtl', 'c.mtl'],
    ['mtllib mats\\a.mtl', 'mats/a.mtl'],
    ['mtllib C:\\mats\\a.mtl', 'a.mtl'],
    ['mtllib A.MTL', 'a.mtl'],
    ['mtllib materials.txt', 'materials.txt'],
    ['', 'model.mtl'],
    ['mtllib former.mtl', 'model.mtl'],
  ])('of %j is %s', async (statements, name) => {
    const main = square('m', `${statements}\n`, 'model.obj');
    expect(await colours(main, library(name, '0 0 1'))).toEqual([[0, 0, 1]]);
  });

  it('that comes first defines a material, and in it the first of that name', async () => {
    const main = square('m', 'mtllib b.mtl a.mtl\n');
    const twice = textFile('b.mtl', 'newmtl m\nKd 1 0 0\nnewmtl m\nKd 0 1 0\n');
    expect(await colours(main, library('a.mtl', '0 0 1'), twice)).toEqual([[1, 0, 0]]);
    expect(await colours(main, library('a.mtl', '0 0 1'), library('b.mtl', '1 0 0', 'other'))).toEqual([
      [0, 0, 1],
    ]);
  });

  it('that is missing is reported with the cure and not as a loss of the output format, unless others define all materials', async () => {
    const alone = await openModel([square()]);
    const cure = 'beside the OBJ to get the colours and textures of its materials';
    expect([alone.unread, alone.notes]).toEqual([[], [`a.mtl is missing: put it ${cure}`]]);
    const two = await openModel([square('m', 'mtllib a.mtl mats/b.mtl\n')]);
    expect(two.notes).toEqual([`a.mtl, mats/b.mtl are missing: put them ${cure}`]);
    const far = await openModel([square('m', 'mtllib ../a.mtl\n')]);
    expect(far.notes).toEqual([`../a.mtl is missing or outside its folder: put it ${cure}`]);
    const other = await openModel([square('m', 'mtllib a.mtl b.mtl\n'), library('b.mtl', '1 0 0')]);
    expect([other.unread, other.notes]).toEqual([[], []]);
    const unknown = await openModel([square(), library('a.mtl', '1 0 0', 'other')]);
    expect([unknown.unread, unknown.notes]).toEqual([
      [],
      ['1 material (m) plain, because no material library defines it'],
    ]);
  });

  it('that is too large or not text is reported, and the model opens', async () => {
    const wide = { name: 'a.mtl', bytes: Uint8Array.from([0xff, 0xfe, 0x6e, 0, 0x65, 0]) };
    const large = { name: 'a.mtl', bytes: new Uint8Array(2 ** 23 + 1).fill(0x20) };
    for (const file of [wide, large]) {
      const { notes, bodies } = await openModel([square(), file]);
      expect(bodies).toHaveLength(1);
      expect(notes[0]).toMatch(
        /^1 material library \(a\.mtl\) left out, not text in UTF-8, or more than 8 MB/,
      );
    }
  });

  it('can give a material the name of a JavaScript built-in', async () => {
    const main = square('__proto__');
    expect(await colours(main, library('a.mtl', '0 1 0', '__proto__'))).toEqual([[0, 1, 0]]);
    expect(await failureOf(() => openModel([square('constructor'), library('a.mtl', '1 0 0')]))).toBe('');
  });

  it('can come in a ZIP', async () => {
    const { writeZip } = await import('../../web/engine/document/archive/write_zip');
    const files = [
      square('m', 'mtllib a.mtl\n', 'set/a.obj'),
      textFile('set/a.mtl', 'newmtl m\nmap_Kd tex/skin.png\n'),
      picture('set/tex/skin.png'),
    ];
    const model = await openModel([{ name: 'set.zip', bytes: writeZip(files, 'test') }]);
    expect(materialsOf(model)[0].getBaseColorTexture()!.getImage()).toEqual(RED);
  });
});

describe('the result of a model with a library', () => {
  const LINES = 'Kd 1 0 0\nd 0.5\nmap_Kd -s 2 2 my skin.png';

  it('is the same for the same files, in any order', async () => {
    const files = [square(), textFile('a.mtl', `newmtl m\n${LINES}\n`), picture('my skin.png')];
    const bytes = await glbOf(await openModel(files));
    expect(await glbOf(await openModel([files[2], files[1], files[0]]))).toEqual(bytes);
    const [material] = materialsOf(await openModel([{ name: 'a.glb', bytes }]));
    expect(material.getName()).toBe('m');
    expect(material.getAlphaMode()).toBe('BLEND');
    expect(material.getBaseColorTexture()!.getImage()).toEqual(RED);
  });

  it('refers to the same library as OBJ, and loses nothing of the materials', async () => {
    const model = await openModel([
      square('m', 'mtllib a.mtl b.mtl\nmtllib c d.mtl\n'),
      textFile('a.mtl', `newmtl m\n${LINES}\n`),
      picture('my skin.png'),
    ]);
    expect(lostIn('obj', model)).toEqual([]);
    expect(lostIn('ply', model)).toContain('1 material with 1 texture');
    const files = await write(model, 'b.obj');
    expect(files.map(({ name }) => name)).toEqual(['b.obj', 'a.mtl', 'my skin.png']);
    const text = new TextDecoder().decode(files[0].bytes);
    expect(text.match(/^(mtllib|usemtl) .*$/gm)).toEqual([
      'mtllib a.mtl b.mtl',
      'mtllib c d.mtl',
      'usemtl m',
    ]);
  });

  const RED_MTL = 'newmtl m\nKd 1 0 0\n';

  it('refers to the library of its own name as OBJ if the named ones are missing', async () => {
    const model = await openModel([square('m', 'mtllib former.mtl\n', 'a.obj'), textFile('a.mtl', RED_MTL)]);
    const files = await write(model, 'b.obj');
    expect(files.map(({ name }) => name)).toEqual(['b.obj', 'a.mtl']);
    expect(materialsOf(await openModel(files))[0].getBaseColorFactor()).toEqual([1, 0, 0, 1]);
  });

  it('drops a library from outside of its folder, with a note', async () => {
    const model = await openModel([
      square('m', 'mtllib ../b.mtl\n', 'set/a.obj'),
      textFile('b.mtl', RED_MTL),
    ]);
    expect(lostIn('obj', model)).toEqual(['b.mtl (not in the folder of the input)']);
    expect((await write(model, 'c.obj')).map(({ name }) => name)).toEqual(['c.obj']);
  });

  it('as glTF has the pictures beside it, under their names', async () => {
    const files = await write(await opened(LINES, picture('my skin.png')), 'b.gltf');
    expect(files.map(({ name }) => name).sort()).toEqual(['b.bin', 'b.gltf', 'my skin.png']);
    expect(
      materialsOf(await openModel(files))[0]
        .getBaseColorTexture()!
        .getImage(),
    ).toEqual(RED);
  });

  it('is read back from an OBJ that limber wrote', async () => {
    const lines = 'Kd 1 .5 0\nPr 0.3\nPm 0.7\nd 0.5\nKe 0 0 1\nmap_Kd skin.png\nnorm n.png';
    const model = await opened(lines, picture('skin.png'), picture('n.png', CLEAR));
    const glb = await openModel([{ name: 'a.glb', bytes: await glbOf(model) }]);
    const [again] = materialsOf(await openModel(await write(glb, 'b.obj')));
    const [first] = materialsOf(model);
    for (const key of ['BaseColorFactor', 'RoughnessFactor', 'MetallicFactor', 'EmissiveFactor'] as const)
      expect(again[`get${key}`](), key).toEqual(first[`get${key}`]());
    expect(again.getBaseColorTexture()!.getImage()).toEqual(RED);
    expect(again.getNormalTexture()!.getImage()).toEqual(CLEAR);
  });
});

describe('any library', () => {
  const name = fc.constantFrom(
    'a.png',
    'b c.png',
    '../a.png',
    'C:\\a.png',
    '"',
    '-s',
    '%',
    '__proto__',
    'a.png -bm',
  );
  const value = fc.oneof(
    fc.double().map(String),
    fc.constantFrom('nan', '1e999', '-', '', '0x1', '1,5', '-halo 1', 'spectral', '\\'),
  );
  const keyword = fc.constantFrom(
    ...['newmtl', 'Kd', 'Ke', 'Ks', 'Ns', 'd', 'Tr', 'Pr', 'Pm', 'illum', '#', 'Ni', 'Tf'],
    ...['map_Kd', 'map_Ke', 'map_d', 'map_Pr', 'map_Pm', 'map_Bump', 'norm', 'bump', 'disp', 'refl', 'map_'],
  );
  const option = fc.constantFrom(
    '',
    '-s 1 2 3 ',
    '-o ',
    '-bm ',
    '-mm 1 2 ',
    '-clamp on ',
    '-t 1e99 1e99 1e99 ',
    '-s 1e39 1 ',
  );
  const line = fc
    .tuple(keyword, option, fc.oneof(name, value, fc.string({ unit: 'binary', maxLength: 12 })), value)
    .map(([word, ...rest]) => `${word} ${rest.join(' ')}`);
  const library = fc.array(line, { maxLength: 30 }).map((lines) => `newmtl m\n${lines.join('\n')}\n`);

  it('opens with its model, and results have no errors', async () => {
    await fc.assert(
      fc.asyncProperty(library, fc.boolean(), async (text, isPng) => {
        const bytes = isPng ? CLEAR : new Uint8Array(40);
        const files = [square(), textFile('a.mtl', text), picture('a.png', bytes), picture('b c.png')];
        await glbOf(await openModel(files));
      }),
      { numRuns: 300, seed: 7 },
    );
  });

  it('of random bytes opens with its model, too', async () => {
    await fc.assert(
      fc.asyncProperty(fc.uint8Array({ maxLength: 300 }), async (bytes) => {
        const head = new TextEncoder().encode('newmtl m\nmap_Kd ');
        const library = Uint8Array.from([...head, ...bytes]);
        const model = await openModel([square(), { name: 'a.mtl', bytes: library }, picture('a.png', bytes)]);
        expect(model.bodies).toHaveLength(1);
      }),
      { numRuns: 300, seed: 7 },
    );
  });

  it('of megabytes is read in little time', async () => {
    for (const line of ['newmtl m\n', 'map_Kd a\n', 'Kd 1 1 1\n', 'map_Kd \\', '-s ', '"', '\n']) {
      const bytes = new TextEncoder().encode(
        `newmtl m\nmap_Kd ${line.repeat(Math.floor(2 ** 21 / line.length))}`,
      );
      const seconds = processorTime();
      await openModel([square(), { name: 'a.mtl', bytes }]);
      expect(seconds(), line).toBeLessThan(5);
    }
  });
});
