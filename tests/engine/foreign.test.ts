import type { GLTF } from '@gltf-transform/core';
import { describe, expect, it } from 'vitest';
import { exportGlb } from '../../web/engine/document/export';
import { glbParts, withJson } from '../../web/engine/document/glb';
import { openModel } from '../../web/engine/document/open';
import type { OpenModel } from '../../web/engine/document/open';
import { addedErrors, validateGlb } from '../../web/engine/document/validate';
import { checkWritten } from '../../web/engine/stages/written_form';
import { defaultSettings } from '../../web/engine/settings/options';
import { failureOf } from './support/files';
import { addRichMesh, glbFile, startDocument } from './support/gltf';
import { cube } from './support/shapes';

type Json = GLTF.IGLTF & Record<string, unknown>;

const jsonOf = (bytes: Uint8Array): Json =>
  JSON.parse(new TextDecoder().decode(glbParts({ name: '', bytes }).json)) as Json;

/** A rich model whose JSON has been changed. */
async function modelWith(change: (json: Json) => void, names: string[]): Promise<OpenModel> {
  const document = startDocument();
  addRichMesh(document, 'rich', cube());
  const { bytes } = await glbFile(document);
  const json = jsonOf(bytes);
  change(json);
  json.extensionsUsed = [...(json.extensionsUsed ?? []), ...names];
  return openModel([{ name: 'test.glb', bytes: withJson(bytes, json) }]);
}

const write = async (model: OpenModel): Promise<Json> =>
  jsonOf(await exportGlb(model, [null], { fields: false }));
const check = (model: OpenModel, dropExtensions = '', name = 'out.glb') =>
  checkWritten(model, [0], { name, settings: { ...defaultSettings('limber'), dropExtensions } });

describe('an unknown extension', () => {
  it('is carried from the file, nodes, meshes, materials and infos on textures', async () => {
    const model = await modelWith(
      (json) => {
        const info = json.materials![0].pbrMetallicRoughness!.baseColorTexture!;
        for (const holder of [json, json.nodes![0], json.meshes![0], json.materials![0], info])
          holder.extensions = { ...holder.extensions, ACME_note: { text: 'kept', node: 0 } };
      },
      ['ACME_note'],
    );
    expect(check(model).lost).toEqual([]);
    const json = await write(model);
    const info = json.materials![0].pbrMetallicRoughness!.baseColorTexture!;
    for (const holder of [json, json.nodes![0], json.meshes![0], json.materials![0], info])
      expect(holder.extensions).toMatchObject({ ACME_note: { text: 'kept', node: 0 } });
    expect(info.extensions).toHaveProperty('KHR_texture_transform');
    expect(json.extensionsUsed).toContain('ACME_note');
  });

  it('keeps the textures that VRM refers to by index', async () => {
    const model = await modelWith(
      (json) => {
        json.samplers = [{ wrapS: 33071 }];
        json.textures!.push({ source: 0, sampler: 0 });
        const used = json.textures!.length - 1;
        json.extensions = {
          VRM: { meta: { texture: used }, materialProperties: [{ textureProperties: { _MainTex: used } }] },
        };
        json.materials![0].extensions = { VRMC_materials_mtoon: { shadeMultiplyTexture: { index: used } } };
      },
      ['VRM', 'VRMC_materials_mtoon'],
    );
    const json = await write(model);
    const { meta, materialProperties } = json.extensions!.VRM as {
      meta: { texture: number };
      materialProperties: { textureProperties: { _MainTex: number } }[];
    };
    const { shadeMultiplyTexture } = json.materials![0].extensions!.VRMC_materials_mtoon as {
      shadeMultiplyTexture: { index: number };
    };
    expect(materialProperties[0].textureProperties._MainTex).toBe(meta.texture);
    expect(shadeMultiplyTexture.index).toBe(meta.texture);
    const texture = json.textures![meta.texture];
    expect(json.samplers![texture.sampler!].wrapS).toBe(33071);
    expect(json.images![texture.source!].name).toBe('picture');
  });

  it('KHR_animation_pointer keeps its channels, and may be required', async () => {
    const model = await modelWith(
      (json) => {
        const [channel] = json.animations![0].channels;
        channel.target = {
          path: 'pointer',
          extensions: { KHR_animation_pointer: { pointer: '/materials/0/alphaCutoff' } },
        } as unknown as typeof channel.target;
        json.extensionsRequired = [...(json.extensionsRequired ?? []), 'KHR_animation_pointer'];
      },
      ['KHR_animation_pointer'],
    );
    const json = await write(model);
    const { target } = json.animations![0].channels[0];
    expect(target.path).toBe('pointer');
    expect(target.extensions).toEqual({ KHR_animation_pointer: { pointer: '/materials/0/alphaCutoff' } });
    expect(json.extensionsRequired).toContain('KHR_animation_pointer');
  });

  it('is refused by name on a mesh that changes, unless it may be dropped or the body is excluded', async () => {
    const model = await modelWith(
      (json) => (json.meshes![0].primitives[0].extensions = { ACME_hair: { strands: 3 } }),
      ['ACME_hair'],
    );
    expect(await failureOf(() => check(model))).toMatch(
      /does not list ACME_hair, which test\.glb has on mesh 0, primitive 0, whose vertices change: add it to leave it out, or keep the body unchanged with .* "rich"\.$/,
    );
    expect(check(model, 'ACME_*').lost).toEqual(['extension ACME_hair']);
    const { lost } = checkWritten(model, [], { name: 'a.glb', settings: defaultSettings('limber') });
    expect(lost).toEqual([]);
    expect((await write(model)).meshes![0].primitives[0].extensions).toEqual({ ACME_hair: { strands: 3 } });
  });

  it('is refused if only it has the image of a texture', async () => {
    const model = await modelWith(
      (json) => {
        json.textures = [{ extensions: { MSFT_texture_dds: { source: 0 } } } as GLTF.ITexture];
        json.materials![0].pbrMetallicRoughness!.baseColorTexture = { index: 0 };
      },
      ['MSFT_texture_dds'],
    );
    expect(await failureOf(() => check(model))).toMatch(
      /MSFT_texture_dds, which test\.glb has on texture 0, which has no other image that can be read:/,
    );
    expect(check(model, 'MSFT_*').lost).toEqual(['extension MSFT_texture_dds']);
  });

  it('is refused if it refers to data that is rewritten', async () => {
    const onAccessor = await modelWith(
      (json) => (json.accessors![0].extensions = { ACME_a: {} }),
      ['ACME_a'],
    );
    expect(await failureOf(() => check(onAccessor))).toMatch(/ACME_a, which test\.glb has on accessor 0/);
    const inside = await modelWith(
      (json) => (json.nodes![0].extensions = { ACME_b: { parts: [{ accessor: 2 }] } }),
      ['ACME_b'],
    );
    expect(await failureOf(() => check(inside))).toMatch(
      /ACME_b, .* on node 0, and its "accessor" refers to data/,
    );
    // A format without extensions says that it leaves it out.
    expect(check(inside, '', 'out.ply').lost).toEqual(expect.arrayContaining(['1 skin']));
  });
});

describe('errors of a result', () => {
  it('are those that the input lacks', async () => {
    const document = startDocument();
    addRichMesh(document, 'rich', cube());
    const { bytes } = await glbFile(document);
    const broken = (change: (json: Json) => void) => {
      const json = jsonOf(bytes);
      change(json);
      return validateGlb(withJson(bytes, json));
    };
    const one = await broken((json) => (json.nodes![0].mesh = 99));
    const two = await broken((json) => {
      json.nodes![0].mesh = 99;
      json.scenes![0].nodes = [98];
    });
    expect(one.errors).toBeGreaterThan(0);
    expect(addedErrors(one, one)).toEqual([]);
    expect(addedErrors(two, one)).toHaveLength(two.errors - one.errors);
    expect(addedErrors(one, null)).toHaveLength(one.errors);
  });
});
