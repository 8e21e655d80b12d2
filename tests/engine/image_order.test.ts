/** Images of written GLBs, whichever of them have bytes. */

import type { Document } from '@gltf-transform/core';
import { expect, it } from 'vitest';
import { exportGlb } from '../../web/engine/document/export';
import { SILENT } from '../../web/engine/document/gltf_io';
import { openModel } from '../../web/engine/document/open';
import { validateGlb } from '../../web/engine/document/validate';
import { writeGltf, NO_ADDITIONS } from '../../web/engine/document/write/gltf_files';
import { addMesh, primitiveOf, startDocument } from './support/gltf';
import { cube } from './support/shapes';

/** A cube with a material for each picture: its bytes, or null where its file is missing. */
function withPictures(pictures: (number[] | null)[]): Document {
  const document = startDocument().setLogger(SILENT);
  const primitives = pictures.map((bytes, i) => {
    const texture = document.createTexture(`picture ${i}`).setURI(`${i}.png`).setMimeType('image/png');
    if (bytes) texture.setImage(Uint8Array.from(bytes));
    const material = document.createMaterial(`material ${i}`).setBaseColorTexture(texture);
    return primitiveOf(document, cube()).setMaterial(material);
  });
  addMesh(document, 'cube', primitives);
  return document;
}

const [A, B, C] = [[1], [2, 2, 2], [3, 3, 3, 3, 3, 3, 3, 3, 3]];

it.each([
  [[A, A, B]],
  [[null, A, B]],
  [[A, null, B, null, B, C, A]],
  [[null, null]],
  [[A, B, C]],
  [[A, B, A]],
])('keep their bytes and places: %j', async (pictures) => {
  const model = await openModel(await writeGltf(withPictures(pictures), 'a.gltf', NO_ADDITIONS));
  const bytes = await exportGlb(model, [null], { fields: false });
  expect(
    (await validateGlb(bytes)).messages.filter(
      (message) => !/^(IMAGE_|MESH_PRIMITIVE_TOO_FEW)/.test(message),
    ),
  ).toEqual([]);
  const { document } = await openModel([{ name: 'a.glb', bytes }]);
  const found = document
    .getRoot()
    .listMaterials()
    .map((material) => material.getBaseColorTexture()!)
    .map((texture) => ({
      name: texture.getName(),
      bytes: texture.getImage() ? [...texture.getImage()!] : null,
    }));
  expect(found).toEqual(pictures.map((bytes, i) => ({ name: `picture ${i}`, bytes })));
  const used = document.getRoot().listExtensionsUsed();
  expect(used).toEqual([]);
  expect(model.document.getRoot().listExtensionsUsed()).toEqual([]);
});
