import type { GLTF } from '@gltf-transform/core';
import { expect, it } from 'vitest';
import { exportGlb } from '../../web/engine/document/export';
import { exportFiles } from '../../web/engine/document/write/export_files';
import { outputForm } from '../../web/engine/document/write/output_form';
import { glbParts, withJson } from '../../web/engine/document/glb';
import { openModel } from '../../web/engine/document/open';
import type { OpenModel } from '../../web/engine/document/open';
import { validateGlb } from '../../web/engine/document/validate';
import { addRichMesh, glbFile, startDocument } from './support/gltf';
import { cube } from './support/shapes';

const jsonOf = (bytes: Uint8Array): GLTF.IGLTF =>
  JSON.parse(new TextDecoder().decode(glbParts({ name: '', bytes }).json)) as GLTF.IGLTF;

/** A rich model whose material shows its image three times: by two textures that differ only in their texts, and by a third one. */
async function namedModel(): Promise<OpenModel> {
  const document = startDocument();
  addRichMesh(document, 'rich', cube());
  const { bytes } = await glbFile(document);
  const json = jsonOf(bytes);
  json.samplers = [
    { wrapS: 33071, name: 'clamped', extras: { id: 1 } },
    { wrapS: 33071, name: 'again' },
  ];
  json.textures = [
    { source: 0, sampler: 1, name: 'unused' },
    { source: 0, sampler: 0, name: 'paint', extras: { author: 'Ada' } },
    { source: 0, sampler: 1, name: 'dirt' },
    { source: 0, sampler: 0 },
  ];
  const [material] = json.materials!;
  material.pbrMetallicRoughness!.baseColorTexture!.index = 1;
  material.emissiveTexture = { index: 2 };
  material.occlusionTexture = { index: 3 };
  material.extensions = {
    ...material.extensions,
    KHR_materials_clearcoat: { clearcoatTexture: { index: 2 } },
  };
  json.extensionsUsed = [...(json.extensionsUsed ?? []), 'KHR_materials_clearcoat'];
  return openModel([{ name: 'test.glb', bytes: withJson(bytes, json) }]);
}

function expectTexts({ materials, textures, samplers }: GLTF.IGLTF): void {
  const [material] = materials!;
  const textureAt = (info: GLTF.ITextureInfo) => textures![info.index];
  const paint = textureAt(material.pbrMetallicRoughness!.baseColorTexture!);
  const dirt = textureAt(material.emissiveTexture!);
  const plain = textureAt(material.occlusionTexture!);
  const { clearcoatTexture } = material.extensions!.KHR_materials_clearcoat as {
    clearcoatTexture: GLTF.ITextureInfo;
  };
  expect(paint).toMatchObject({ source: 0, name: 'paint', extras: { author: 'Ada' } });
  expect(dirt).toMatchObject({ source: 0, name: 'dirt' });
  expect(dirt).not.toHaveProperty('extras');
  expect(plain).not.toHaveProperty('name');
  expect(textureAt(clearcoatTexture)).toBe(dirt);
  expect(textures).toHaveLength(3);
  expect(samplers![paint.sampler!]).toMatchObject({ wrapS: 33071, name: 'clamped', extras: { id: 1 } });
  expect(samplers![dirt.sampler!]).toMatchObject({ wrapS: 33071, name: 'again' });
  expect(plain.sampler).toBe(paint.sampler);
}

it('names and extras of textures and samplers are those that each material had', async () => {
  const bytes = await exportGlb(await namedModel(), [null], { fields: false });
  expectTexts(jsonOf(bytes));
  expect(await validateGlb(bytes)).toMatchObject({ errors: 0 });
});

it('they are in a glTF with companions, too', async () => {
  const [main] = await exportFiles(await namedModel(), [null], {
    name: 'a.gltf',
    form: outputForm('a.gltf', 'auto', 'glb'),
    manner: { compression: 'like-input', style: 'files', keepsOrder: false },
    fields: false,
  });
  expectTexts(JSON.parse(new TextDecoder().decode(main.bytes)) as GLTF.IGLTF);
});
