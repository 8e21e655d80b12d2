import { NodeIO } from '@gltf-transform/core';
import type { Document, Mesh } from '@gltf-transform/core';
import { ALL_EXTENSIONS, KHRMaterialsVolume } from '@gltf-transform/extensions';
import type { Volume } from '@gltf-transform/extensions';
import { strFromU8, unzipSync, zipSync } from 'fflate';
import { MeshoptDecoder } from 'meshoptimizer/decoder';
import { MeshoptEncoder } from 'meshoptimizer/encoder';
import { describe, expect, it, vi } from 'vitest';
import type { Compression, LevelStyle } from '../../web/engine/core/output_choices';
import { openModel } from '../../web/engine/document/open';
import type { OpenModel, SourceFile } from '../../web/engine/document/open';
import { glbParts, withJson } from '../../web/engine/document/glb';
import { validateFiles } from '../../web/engine/document/validate';
import { exportFiles } from '../../web/engine/document/write/export_files';
import { formOfName, levelNames, outputForm } from '../../web/engine/document/write/output_form';
import { isOwnContent } from '../../web/cli/output_files/own_files';
import { failureOf, textFile } from './support/files';
import { addMesh, addRichMesh, floats, glbFile, moveNode, primitiveOf, startDocument } from './support/gltf';
import { asResult } from './support/results';
import { torus } from './support/shapes';

interface Wanted {
  compression?: Compression;
  style?: LevelStyle;
  levels?: number;
  keepsOrder?: boolean;
}

function write(
  model: OpenModel,
  name: string,
  { compression = 'like-input', style = 'files', levels = 0, keepsOrder = false }: Wanted = {},
) {
  const form = formOfName(name, model.format)!;
  const bodies = model.bodies.map((body) => ({
    first: asResult(body),
    further: Array.from({ length: levels }, (_, i) => ({ exported: asResult(body), deviation: i + 1 })),
  }));
  return exportFiles(model, bodies, {
    name,
    form,
    manner: { compression, style, keepsOrder },
    fields: false,
  });
}

async function richModel(): Promise<OpenModel> {
  const document = startDocument();
  addRichMesh(document, 'rich', torus());
  return openModel([await glbFile(document)]);
}

/** Per triangle the sorted texts of its corners: what two meshes have in common whatever the numbers of their vertices. */
function trianglesOf({ bodies }: OpenModel, digits: number, scale = 1): string[] {
  return bodies
    .flatMap(({ positions, indices }) =>
      Array.from({ length: indices.length / 3 }, (_, t) =>
        [0, 1, 2]
          .map((c) =>
            [...positions.slice(3 * indices[3 * t + c], 3 * indices[3 * t + c] + 3)]
              .map((value) =>
                (Math.round(Math.fround(scale * value) * 10 ** digits) / 10 ** digits + 0).toFixed(digits),
              )
              .join(' '),
          )
          .sort()
          .join(' | '),
      ),
    )
    .sort();
}

const jsonOf = (glb: Uint8Array) =>
  JSON.parse(new TextDecoder().decode(glbParts({ name: '', bytes: glb }).json)) as Record<string, never[]>;

describe('a written file', () => {
  it.each(['a.glb', 'a.gltf', 'a.obj', 'a.ply', 'a.zip', 'a.gltf.zip', 'a.obj.zip', 'a.ply.zip'])(
    '%s has the triangles of the model when it is read again',
    async (name) => {
      const model = await richModel();
      const files = await write(model, name);
      const again = await openModel(files.filter((file) => !/\.(mtl)$/.test(file.name)));
      // The morph target has the positions again, half of which the default weight adds.
      expect(trianglesOf(again, 6)).toEqual(trianglesOf(model, 6, /obj|ply/.test(name) ? 1.5 : 1));
      expect((await validateFiles(files))?.errors ?? 0).toBe(0);
      expect(name === 'a.glb' || isOwnContent(files[0].bytes)).toBe(true);
      expect(await write(model, name)).toEqual(files);
    },
  );

  it('of every compression keeps skin, morph target and animation, and the validator finds no error', async () => {
    const model = await richModel();
    for (const compression of ['quantized', 'meshopt', 'draco'] as const) {
      const files = await write(model, 'a.glb', { compression });
      const again = await openModel(files);
      expect(again.stored?.kind).toBe(compression);
      const root = again.document.getRoot();
      expect([root.listSkins().length, root.listAnimations().length]).toEqual([1, 1]);
      expect(root.listMeshes()[0].listPrimitives()[0].listTargets()).toHaveLength(1);
      expect((await validateFiles(files))!.errors).toBe(0);
      expect(again.bodies[0].indices).toHaveLength(model.bodies[0].indices.length);
    }
  });

  it('declares integers also if positions stay floats, as in a skin without inverse bind matrices', async () => {
    const document = startDocument();
    addRichMesh(document, 'rich', torus());
    for (const skin of document.getRoot().listSkins()) skin.setInverseBindMatrices(null);
    const model = await openModel([await glbFile(document)]);
    for (const compression of ['quantized', 'meshopt'] as const) {
      const files = await write(model, 'a.glb', { compression });
      expect(jsonOf(files[0].bytes).extensionsRequired).toContain('KHR_mesh_quantization');
      expect((await validateFiles(files))!.errors).toBe(0);
    }
  });

  it.each(['quantized', 'meshopt'] as const)(
    'in %s keeps a primitive without positions where it is',
    async (compression) => {
      const document = startDocument();
      addRichMesh(document, 'rich', torus());
      const [mesh] = document.getRoot().listMeshes();
      const [first] = mesh.listPrimitives();
      const bare = document.createPrimitive().setName('bare').setMode(0);
      mesh.removePrimitive(first).addPrimitive(bare).addPrimitive(first);
      const model = await openModel([await glbFile(document)]);
      const [file] = await write(model, 'a.glb', { compression });
      const [written] = (await openModel([file])).document.getRoot().listMeshes();
      const hasPositions = written.listPrimitives().map((one) => one.getAttribute('POSITION') !== null);
      expect(hasPositions).toEqual([false, true]);
    },
  );

  it.each(['quantized', 'meshopt', 'draco'] as const)(
    'in %s keeps vertices, triangles and their corners in order where another file counts them',
    async (compression) => {
      const indicesOf = async (model: OpenModel, wanted: Wanted) =>
        Array.from((await openModel(await write(model, 'a.glb', wanted))).bodies[0].indices);
      const model = await richModel();
      const plain = await indicesOf(model, { compression: 'none' });
      expect(await indicesOf(model, { compression, keepsOrder: true })).toEqual(plain);
      const packed = await openModel(await write(model, 'a.glb', { compression }));
      const unpacked = await indicesOf(packed, { compression: 'none' });
      expect(await indicesOf(packed, { keepsOrder: true })).toEqual(unpacked);
    },
  );

  it('in draco has joint weights that add up to 1 within the rounding of 16 bits', async () => {
    const document = startDocument();
    const mesh = addRichMesh(document, 'rich', torus());
    const [primitive] = mesh.listPrimitives();
    const shares = Array.from({ length: primitive.getAttribute('POSITION')!.getCount() }, (_, v) => {
      const [a, b] = [(v % 97) / 200, (v % 89) / 300];
      return [a, b, 0.1, 0.9 - a - b];
    });
    primitive.setAttribute('WEIGHTS_0', floats(document, 'VEC4', shares.flat()));
    const model = await openModel([await glbFile(document)]);
    const again = await openModel(await write(model, 'a.glb', { compression: 'draco' }));
    const weights = again.document.getRoot().listMeshes()[0].listPrimitives()[0].getAttribute('WEIGHTS_0')!;
    const sums = Array.from({ length: weights.getCount() }, (_, v) =>
      weights.getElement(v, []).reduce((sum, weight) => sum + weight, 0),
    );
    const worst = Math.max(...sums.map((sum) => Math.abs(sum - 1)));
    expect(worst).toBeLessThan(3e-5);
    expect(worst).toBeGreaterThan(1e-7);
  });

  it('is stored like its input, on the quantization grid of its input', async () => {
    for (const compression of ['quantized', 'meshopt', 'draco'] as const) {
      const input = await write(await richModel(), 'a.glb', { compression });
      const model = await openModel(input);
      const output = await write(model, 'b.glb');
      const again = await openModel(output);
      expect(again.stored).toEqual(model.stored);
      expect(trianglesOf(again, 3)).toEqual(trianglesOf(model, 3));
      expect(output[0].bytes.length).toBeLessThan(1.1 * input[0].bytes.length);
      const plain = await write(await richModel(), 'b.glb');
      expect(output[0].bytes.length).toBeLessThan(0.8 * plain[0].bytes.length);
    }
  });

  it('keeps the numbers of custom attributes, however small they are', async () => {
    const document = startDocument();
    const masses = torus()
      .positions.filter((_, i) => i % 3 === 0)
      .map((x) => 1e-6 * (2 + x));
    const primitive = primitiveOf(document, torus());
    addMesh(document, 'ring', [primitive.setAttribute('_MASS', floats(document, 'SCALAR', masses))]);
    const model = await openModel([await glbFile(document)]);
    for (const compression of ['quantized', 'meshopt'] as const) {
      const again = await openModel(await write(model, 'a.glb', { compression }));
      const [written] = again.document.getRoot().listMeshes()[0].listPrimitives();
      const values = written.getAttribute('_MASS')!.getArray()!;
      expect(Array.from(values).sort()).toEqual(Array.from(masses).sort());
    }
  });

  it.each(['quantized', 'meshopt'] as const)(
    'in %s keeps differences of morph targets, which have signs and reach beyond 1',
    async (compression) => {
      const document = startDocument();
      const { positions } = torus();
      const count = positions.length / 3;
      const vectors = (length: number, size: 3 | 4) =>
        floats(
          document,
          size === 3 ? 'VEC3' : 'VEC4',
          Array.from({ length: size * count }, (_, i) => length * Math.sin(i)),
        );
      const primitive = primitiveOf(document, torus())
        .setAttribute(
          'NORMAL',
          floats(
            document,
            'VEC3',
            positions.map((_, i) => Number(i % 3 === 2)),
          ),
        )
        .setAttribute('COLOR_0', floats(document, 'VEC4', new Float32Array(4 * count).fill(0.5)));
      const targets = [
        { NORMAL: vectors(1.9, 3).setSparse(true) },
        { NORMAL: vectors(0.9, 3), COLOR_0: vectors(0.5, 4), POSITION: floats(document, 'VEC3', positions) },
      ];
      for (const attributes of targets) {
        const target = document.createPrimitiveTarget();
        for (const [semantic, values] of Object.entries(attributes)) target.setAttribute(semantic, values);
        primitive.addTarget(target);
      }
      addMesh(document, 'ring', [primitive]).setWeights([0, 0]);
      const model = await openModel([await glbFile(document)]);
      const [plain] = await write(model, 'a.glb', { compression: 'none', keepsOrder: true });
      const [file] = await write(model, 'a.glb', { compression, keepsOrder: true });
      expect((await validateFiles([file]))!.errors).toBe(0);
      const read = async (one: SourceFile) => {
        const [mesh] = (await openModel([one])).document.getRoot().listMeshes();
        return mesh.listPrimitives()[0].listTargets();
      };
      const [wanted, found] = [await read(plain), await read(file)];
      for (const [i, semantic] of [
        [0, 'NORMAL'],
        [1, 'NORMAL'],
        [1, 'COLOR_0'],
      ] as const) {
        const [a, b] = [wanted, found].map((all) => all[i].getAttribute(semantic)!);
        const off = Array.from({ length: a.getCount() }, (_, v) => {
          const [x, y] = [a.getElement(v, []), b.getElement(v, [])];
          return Math.max(...x.map((value, c) => Math.abs(value - y[c])));
        });
        expect(Math.max(...off)).toBeLessThan(0.002);
      }
      expect(found[1].getAttribute('NORMAL')!.getArray()).toBeInstanceOf(Int16Array);
    },
  );

  it('has a material with a thickness once, in the quantized scale, and an unused one', async () => {
    const document = startDocument();
    const volume = document.createExtension(KHRMaterialsVolume).createVolume().setThicknessFactor(0.5);
    const glass = document.createMaterial('glass').setExtension('KHR_materials_volume', volume);
    document.createMaterial('spare');
    addMesh(document, 'ring', [primitiveOf(document, torus()).setMaterial(glass)]);
    const [file] = await write(await openModel([await glbFile(document)]), 'a.glb', {
      compression: 'quantized',
    });
    const root = (await openModel([file])).document.getRoot();
    const materials = root.listMaterials();
    expect(materials.map((material) => material.getName()).sort()).toEqual(['glass', 'spare']);
    const [scale] = root
      .listNodes()
      .find((node) => node.getMesh())!
      .getScale();
    const written = materials.find((material) => material.getName() === 'glass')!;
    const own = written.getExtension<Volume>('KHR_materials_volume')!;
    expect(own.getThicknessFactor() * scale).toBeCloseTo(0.5, 5);
  });

  it('keeps the weights of a node with morph targets that has children or is animated', async () => {
    const document = startDocument();
    const target = document
      .createPrimitiveTarget('up')
      .setAttribute('POSITION', floats(document, 'VEC3', torus().positions));
    const mesh = addMesh(document, 'a', [primitiveOf(document, torus()).addTarget(target)]).setWeights([0]);
    const [parent] = document.getRoot().listNodes();
    const moving = document.createNode('moving').setMesh(mesh).setWeights([0.5]);
    document.getRoot().getDefaultScene()!.addChild(moving);
    parent.setWeights([1]).addChild(document.createNode('child'));
    moveNode(document, moving);
    const files = await write(await openModel([await glbFile(document)]), 'a.glb', {
      compression: 'quantized',
    });
    expect((await validateFiles(files))!.messages).toEqual([]);
    const nodes = (await openModel(files)).document.getRoot().listNodes();
    const shown = nodes.filter((node) => node.getMesh());
    expect(shown.map((node) => node.getWeights()[0])).toEqual([1, 0.5]);
  });

  it('prints nothing to the console if an attribute cannot be quantized', async () => {
    const model = await openModel([textFile('a.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nvt -3 5\nf 1/1 2/1 3/1\n')]);
    const words = (['log', 'info', 'warn', 'error', 'debug'] as const).map((name) =>
      vi.spyOn(console, name).mockImplementation(() => {}),
    );
    await write(model, 'a.glb', { compression: 'quantized' });
    for (const word of words) {
      expect(word).not.toHaveBeenCalled();
      word.mockRestore();
    }
  });

  it('under the ratified name of meshopt is read and written under it', async () => {
    const [{ bytes }] = await write(await richModel(), 'a.glb', { compression: 'meshopt' });
    const text = JSON.stringify(jsonOf(bytes)).replaceAll('EXT_meshopt', 'KHR_meshopt');
    const model = await openModel([{ name: 'k.glb', bytes: withJson(bytes, JSON.parse(text) as object) }]);
    expect(model.stored).toEqual({ kind: 'meshopt', isRatified: true });
    const [again] = await write(model, 'b.glb');
    expect(jsonOf(again.bytes).extensionsRequired).toContain('KHR_meshopt_compression');
    expect(JSON.stringify(jsonOf(again.bytes))).not.toContain('EXT_meshopt');
    expect(trianglesOf(await openModel([again]), 5)).toEqual(trianglesOf(model, 5));
  });

  it('of meshopt is read by glTF-Transform itself', async () => {
    const [{ bytes }] = await write(await richModel(), 'a.glb', { compression: 'meshopt' });
    await Promise.all([MeshoptDecoder.ready, MeshoptEncoder.ready]);
    const io = new NodeIO()
      .registerExtensions(ALL_EXTENSIONS)
      .registerDependencies({ 'meshopt.decoder': MeshoptDecoder });
    const [mesh] = (await io.readBinary(bytes)).getRoot().listMeshes();
    expect(mesh.listPrimitives()[0].getIndices()!.getCount()).toBe(torus().triangles.length);
  });

  it('has equal images once', async () => {
    const document = startDocument();
    const meshes = [addRichMesh(document, 'a', torus()), addRichMesh(document, 'b', torus())];
    const [one, two] = meshes.map((mesh) => mesh.listPrimitives()[0].getMaterial()!.getBaseColorTexture()!);
    expect(one.getImage()).toEqual(two.getImage());
    const model = await openModel([await glbFile(document)]);
    const images = jsonOf((await write(model, 'a.glb'))[0].bytes).images as { bufferView: number }[];
    expect(images).toHaveLength(2);
    expect(images[0].bufferView).toBe(images[1].bufferView);
    const files = await write(model, 'a.gltf');
    expect(files.map(({ name }) => name).sort()).toEqual(['a.bin', 'a.gltf', 'a_picture.png']);
  });
});

describe('levels in one file', () => {
  const nodesOf = (document: Document) => document.getRoot().listNodes();

  it('are nodes by name below the node, all with the skin', async () => {
    const files = await write(await richModel(), 'a.glb', { style: 'nodes', levels: 2 });
    const { document } = await openModel(files);
    const names = nodesOf(document).map((node) => node.getName());
    const parent = nodesOf(document).find((node) => node.getName() === 'rich node')!;
    expect(names).toEqual(expect.arrayContaining(['rich node_LOD0', 'rich node_LOD1', 'rich node_LOD2']));
    const levels = parent.listChildren().filter((node) => node.getMesh());
    expect(levels).toHaveLength(3);
    expect(new Set(levels.map((node) => node.getSkin())).size).toBe(1);
    expect(parent.getMesh()).toBeNull();
    expect((await validateFiles(files))!.errors).toBe(0);
  });

  it('are named by MSFT_lod, coarser ones later, with falling coverage', async () => {
    const files = await write(await richModel(), 'a.glb', { style: 'msft', levels: 2 });
    const json = jsonOf(files[0].bytes) as unknown as {
      nodes: {
        mesh?: number;
        extensions?: { MSFT_lod?: { ids: number[] } };
        extras?: { MSFT_screencoverage: number[] };
      }[];
      extensionsUsed: string[];
    };
    const first = json.nodes.find((node) => node.extensions?.MSFT_lod)!;
    const meshes = first.extensions!.MSFT_lod!.ids.map((id) => json.nodes[id].mesh);
    expect(new Set([first.mesh, ...meshes]).size).toBe(3);
    expect(json.extensionsUsed).toContain('MSFT_lod');
    // 1 % and 2 % of the height are one line of 1080 at 100 / 1080 and half of it.
    const [a, b, c] = first.extras!.MSFT_screencoverage;
    expect(a).toBeCloseTo(100 / 1080, 9);
    expect([b, c]).toEqual([a / 2, 0]);
    expect((await validateFiles(files))!.errors).toBe(0);
  });

  it('keep a node of which only weights are animated, and give the mesh of a moving one a child node', async () => {
    const nodesOf = async (path: 'weights' | 'translation') => {
      const document = startDocument();
      const target = document
        .createPrimitiveTarget('up')
        .setAttribute('POSITION', floats(document, 'VEC3', torus().positions));
      addMesh(document, 'a', [primitiveOf(document, torus()).addTarget(target)]).setWeights([0]);
      moveNode(document, document.getRoot().listNodes()[0]);
      const [channel] = document.getRoot().listAnimations()[0].listChannels();
      if (path === 'weights') {
        channel.setTargetPath(path);
        channel.getSampler()!.setOutput(floats(document, 'SCALAR', [0, 1]));
      }
      const model = await openModel([await glbFile(document)]);
      const files = await write(model, 'a.glb', { style: 'msft', levels: 1 });
      expect((await validateFiles(files))!.errors).toBe(0);
      return (await openModel(files)).document.getRoot().listNodes().length;
    };
    expect([await nodesOf('weights'), await nodesOf('translation')]).toEqual([2, 3]);
  });
});

describe('the name of a file', () => {
  it('says the format', () => {
    expect(formOfName('a.obj.zip', 'glb')).toEqual({ format: 'obj', isZipped: true });
    expect(formOfName('a.zip', 'ply')).toEqual({ format: 'ply', isZipped: true });
    expect(formOfName('a.zip', 'stl')).toEqual({ format: 'glb', isZipped: true });
    expect(formOfName('a.txt', 'glb')).toBeNull();
    expect(outputForm('a.zip', 'obj.zip', 'glb')).toEqual({ format: 'obj', isZipped: true });
    expect(() => outputForm('a.glb', 'obj', 'glb')).toThrow(
      'a.glb does not end in .obj, the format that is asked for: change the name or the format.',
    );
    expect(levelNames('a.b.gltf.zip', { lods: [0.5], lodStyle: 'files' })).toEqual(['a.b_lod1.gltf.zip']);
  });
});

describe('a ZIP', () => {
  const text = (words: string) => new TextEncoder().encode(words);
  const SQUARE = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n';

  it('is opened with its contents, whatever operating systems add to it', async () => {
    const bytes = zipSync({
      'a/square.obj': text(SQUARE),
      '__MACOSX/a/._square.obj': text('x'),
      'a/.DS_Store': text('x'),
    });
    expect((await openModel([{ name: 'a.zip', bytes }])).bodies[0].indices).toHaveLength(6);
  });

  it('is refused if a path leads out of it or it declares more data than it can contain', async () => {
    const open = (name: string, bytes: Uint8Array): Promise<string> =>
      failureOf(() => openModel([{ name, bytes }]));
    for (const name of ['../x.obj', 'a/../../x.obj', '/etc/x.obj', 'C:x.obj', 'a\\..\\x.obj'])
      expect(await open('slip.zip', zipSync({ [name]: text(SQUARE) }))).toMatch(
        /^slip\.zip has a file that leads out/,
      );
    const bomb = zipSync({ 'x.obj': text(SQUARE) });
    const view = new DataView(bomb.buffer);
    for (let at = 0; at < bomb.length - 4; ++at)
      if (view.getUint32(at, true) === 0x02014b50) view.setUint32(at + 24, 0x7fffffff, true);
    expect(await open('bomb.zip', bomb)).toMatch(/^bomb\.zip declares more data than it can contain/);
    expect(await open('cut.zip', bomb.slice(0, 40))).toMatch(/^cut\.zip is damaged/);
    expect(await open('empty.zip', zipSync({ 'a/': text('') }))).toMatch(/no file in it|damaged/);
  });

  it('holds the files that are written without it', async () => {
    const model = await richModel();
    const plain = await write(model, 'a.obj');
    const held = unzipSync((await write(model, 'a.obj.zip'))[0].bytes);
    expect(Object.keys(held)).toEqual(plain.map(({ name }) => name));
    expect(strFromU8(held['a.obj'])).toBe(strFromU8(plain[0].bytes));
  });
});

describe('OFF', () => {
  const open = (words: string): Promise<OpenModel> => openModel([textFile('a.off', words)]);

  it('is read past control characters in place of a word', async () => {
    for (const control of ['\u0000', '\u0001', '\u001f']) {
      const { bodies } = await open(`OFF\n3 1 0\n0 0 0 ${control}\n1 0 0\n0 1 0\n3 0 1 2\n`);
      expect(Array.from(bodies[0].positions)).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0]);
    }
  });

  it('is read with polygons, comments and colours', async () => {
    const model = await open(
      'COFF # a square\n# two lines\n4 1 0\n0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n\n1 1 0 0 255 0 255 # c\n0 1 0 0 0 255 255\n4 0 1 2 3\n',
    );
    expect([...model.bodies[0].indices]).toEqual([0, 1, 2, 0, 2, 3]);
    const [primitive] = (model.document.getRoot().listMeshes()[0] as Mesh).listPrimitives();
    expect(primitive.getAttribute('COLOR_0')!.getElement(0, [])).toEqual([1, 0, 0]);
    expect(model.bodies[0].notes[0]).toMatch(/^1 polygon/);
  });

  it('is read with normals and UVs, and without its keyword', async () => {
    const model = await open(
      'STNOFF\n3 1 3\n0 0 0 0 0 2 0 0\n1 0 0 0 0 2 1 0\n0 1 0 0 0 2 0 1\n3 0 1 2 1 0 0\n',
    );
    const [primitive] = model.document.getRoot().listMeshes()[0].listPrimitives();
    expect(primitive.getAttribute('NORMAL')!.getElement(1, [])).toEqual([0, 0, 1]);
    expect(primitive.getAttribute('TEXCOORD_0')!.getElement(2, [])).toEqual([0, 0]);
    expect(model.unread).toEqual(['colours of faces']);
    expect((await open('3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n')).bodies[0].indices).toHaveLength(3);
  });

  it.each([
    ['OFF\n4000000000 1 0\n0 0 0\n', /a\.off, line \d+: the file ends too early/],
    [
      'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n',
      /line 6: face 0 names vertex 3, but vertices go from 0 to 2/,
    ],
    ['OFF\n3 1 0\n0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n', /line 3: z is nan, not a finite number/],
    ['OFF BINARY\n', /is binary OFF/],
    ['4OFF\n3 1 0\n', /more than three dimensions/],
    ['OFF\n-3 1 0\n', /-3 is not a number of vertices/],
    ['OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n', /has no faces/],
  ])('%j is refused', async (words, sentence) => {
    expect(await failureOf(() => open(words))).toMatch(sentence);
  });
});

describe('an OBJ', () => {
  it('places instances and names materials and pictures', async () => {
    const files: SourceFile[] = await write(await richModel(), 'a.obj');
    expect(files.map(({ name }) => name)).toEqual(['a.obj', 'a.mtl', 'a_picture.png']);
    expect(strFromU8(files[1].bytes)).toMatch(/newmtl rich material\nKd 1 1 1\n.*map_Kd a_picture\.png/s);
    expect(strFromU8(files[0].bytes)).toMatch(/^# Limber .*\nmtllib a\.mtl\n/);
  });
});
