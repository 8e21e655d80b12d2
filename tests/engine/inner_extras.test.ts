import type { GLTF } from '@gltf-transform/core';
import { expect, it } from 'vitest';
import { exportGlb } from '../../web/engine/document/export';
import { innerExtrasOf } from '../../web/engine/document/extensions/inner_extras';
import { glbParts, withJson } from '../../web/engine/document/glb';
import { openModel } from '../../web/engine/document/open';
import { addRichMesh, glbFile, startDocument } from './support/gltf';
import { cube } from './support/shapes';

const jsonOf = (bytes: Uint8Array): GLTF.IGLTF =>
  JSON.parse(new TextDecoder().decode(glbParts({ name: '', bytes }).json)) as GLTF.IGLTF;

it('extras of objects inside cameras, animations, materials and extensions stay where they are', async () => {
  const document = startDocument();
  addRichMesh(document, 'rich', cube());
  document.getRoot().listNodes()[0].setCamera(document.createCamera().setType('perspective').setYFov(1));
  const { bytes } = await glbFile(document);
  const json = jsonOf(bytes);
  const { pbrMetallicRoughness } = json.materials![0];
  const info = pbrMetallicRoughness!.baseColorTexture!;
  const holders: { extras?: unknown }[] = [
    pbrMetallicRoughness!,
    info,
    info.extensions!.KHR_texture_transform as object,
    json.cameras![0].perspective!,
    json.animations![0].channels[0],
    json.animations![0].channels[0].target,
  ];
  holders.forEach((holder, i) => (holder.extras = { kept: i }));
  const model = await openModel([{ name: 'test.glb', bytes: withJson(bytes, json) }]);
  expect(innerExtrasOf(jsonOf(await exportGlb(model, [null], { fields: false })))).toEqual(
    expect.arrayContaining(innerExtrasOf(json)),
  );
  expect(innerExtrasOf(json)).toHaveLength(6);
});
