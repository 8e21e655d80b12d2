/** Perspective cameras that see infinitely far still do in written files. */

import type { GLTF } from '@gltf-transform/core';
import { expect, it } from 'vitest';
import { glbParts, withJson } from '../../web/engine/document/glb';
import { openModel } from '../../web/engine/document/open';
import type { SourceFile } from '../../web/engine/document/open';
import { exportGlb } from '../../web/engine/document/export';
import { validateFiles } from '../../web/engine/document/validate';
import { exportFiles } from '../../web/engine/document/write/export_files';
import { addMesh, glbFile, primitiveOf, startDocument } from './support/gltf';
import { asResult } from './support/results';
import { cube } from './support/shapes';

const CAMERAS: GLTF.ICamera[] = [
  { type: 'perspective', perspective: { yfov: 1, znear: 200 } },
  { type: 'perspective', perspective: { yfov: 1, znear: 0.5, zfar: 100 } },
  { type: 'orthographic', orthographic: { xmag: 1, ymag: 1, znear: 0.5, zfar: 100 } },
];

const jsonOf = ({ name, bytes }: SourceFile): GLTF.IGLTF =>
  JSON.parse(
    new TextDecoder().decode(name.endsWith('.glb') ? glbParts({ name, bytes }).json : bytes),
  ) as GLTF.IGLTF;

/** A cube with these cameras. */
async function modelOf(cameras: GLTF.ICamera[]) {
  const document = startDocument();
  addMesh(document, 'cube', [primitiveOf(document, cube())]);
  const file = await glbFile(document);
  return openModel([{ ...file, bytes: withJson(file.bytes, { ...jsonOf(file), cameras }) }]);
}

it.each(['glb', 'gltf'] as const)('of a %s have no far plane if the input has none', async (format) => {
  const model = await modelOf(CAMERAS);
  const files = await exportFiles(model, [{ first: asResult(model.bodies[0]), further: [] }], {
    name: `out.${format}`,
    form: { format, isZipped: false },
    manner: { compression: 'none', style: 'files', keepsOrder: false },
    fields: false,
  });
  expect(jsonOf(files[0]).cameras).toEqual(CAMERAS);
  expect((await validateFiles(files))!.errors).toBe(0);
});

it('of a model without changes have none, either', async () => {
  const bytes = await exportGlb(await modelOf(CAMERAS.slice(0, 1)), [null], { fields: false });
  expect(jsonOf({ name: 'out.glb', bytes }).cameras).toEqual(CAMERAS.slice(0, 1));
});
