/** Names of morph targets in written files. */

import type { GLTF } from '@gltf-transform/core';
import { expect, it } from 'vitest';
import { ownSources } from '../../web/engine/body/attributes';
import { glbParts, withJson } from '../../web/engine/document/glb';
import { openModel } from '../../web/engine/document/open';
import type { SourceFile } from '../../web/engine/document/open';
import { exportFiles } from '../../web/engine/document/write/export_files';
import { filesOf } from '../../web/library/models';
import { addMesh, floats, glbFile, primitiveOf, readGlb, startDocument } from './support/gltf';
import { cube } from './support/shapes';

const jsonOf = ({ name, bytes }: SourceFile): GLTF.IGLTF =>
  JSON.parse(
    new TextDecoder().decode(name.endsWith('.glb') ? glbParts({ name, bytes }).json : bytes),
  ) as GLTF.IGLTF;

/** Meshes of two morph targets, whose extras in the file are these. */
async function fileWith(extras: (object | undefined)[]): Promise<SourceFile> {
  const document = startDocument();
  for (const i of extras.keys()) {
    const mesh = cube();
    const target = (name: string) =>
      document.createPrimitiveTarget(name).setAttribute('POSITION', floats(document, 'VEC3', mesh.positions));
    addMesh(document, `mesh ${i}`, [
      primitiveOf(document, mesh).addTarget(target('a')).addTarget(target('b')),
    ]).setWeights([0, 0]);
  }
  const file = await glbFile(document);
  const json = jsonOf(file);
  json.meshes!.forEach((mesh, i) => {
    delete mesh.extras;
    if (extras[i]) mesh.extras = extras[i] as Record<string, unknown>;
  });
  return { name: file.name, bytes: withJson(file.bytes, json) };
}

const EXTRAS = [
  undefined,
  { mood: 1 },
  { targetNames: ['smile', ''], mood: 1 },
  { targetNames: ['smile'] },
  { targetNames: null },
  { targetNames: ['smile', 'frown'] },
  { targetNames: ['0', '1'] },
];

const extrasOf = (file: SourceFile) => jsonOf(file).meshes!.map((mesh) => mesh.extras);

it.each(['glb', 'gltf'] as const)(
  'of a %s are those of the input, and none where it has none',
  async (format) => {
    const model = await openModel([await fileWith(EXTRAS)]);
    const bodies = model.bodies.map((body, i) => {
      if (i % 2 === 1) return null;
      const mesh = { positions: body.positions, triangles: body.indices };
      const inputOfTriangle = Uint32Array.from({ length: body.indices.length / 3 }, (_, t) => t);
      const first = { body, mesh, inputOfTriangle, sources: ownSources(mesh), hardCosine: null };
      return { first, further: [] };
    });
    const request = {
      name: `out.${format}`,
      form: { format, isZipped: false },
      manner: { compression: 'none', style: 'files', keepsOrder: false },
      fields: false,
    } as const;
    const [written] = await exportFiles(model, bodies, request);
    expect(extrasOf(written)).toEqual(EXTRAS);
  },
);

it('of a document of a caller are those that it was read with', async () => {
  const document = await readGlb((await fileWith(EXTRAS)).bytes);
  document
    .createMesh('named')
    .addPrimitive(
      primitiveOf(document, cube()).addTarget(
        document
          .createPrimitiveTarget('wink')
          .setAttribute('POSITION', floats(document, 'VEC3', cube().positions)),
      ),
    );
  const [file] = await filesOf(document);
  expect(extrasOf(file)).toEqual([...EXTRAS, { targetNames: ['wink'] }]);
});
