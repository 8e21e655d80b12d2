/** Results with integers as positions: their meshes have other units, and their nodes make up for that. */

import { KHRMaterialsVariants, KHRMaterialsVolume, KHRMeshQuantization } from '@gltf-transform/extensions';
import type { MappingList, Volume } from '@gltf-transform/extensions';
import type { Document, Material, Mesh, Node } from '@gltf-transform/core';
import { getBounds } from '@gltf-transform/functions';
import { expect, it } from 'vitest';
import type { TriangleMesh } from '../../web/engine/core/core';
import type { Compression } from '../../web/engine/core/output_choices';
import type { ExportedBody } from '../../web/engine/document/export';
import { openModel } from '../../web/engine/document/open';
import type { OpenModel } from '../../web/engine/document/open';
import { validateFiles } from '../../web/engine/document/validate';
import { exportFiles } from '../../web/engine/document/write/export_files';
import { addMesh, floats, glbFile, primitiveOf, startDocument } from './support/gltf';
import { asResult } from './support/results';
import { torus } from './support/shapes';

function glass(document: Document, name: string, thickness: number): Material {
  const volume = document.createExtension(KHRMaterialsVolume).createVolume().setThicknessFactor(thickness);
  return document.createMaterial(name).setExtension('KHR_materials_volume', volume);
}

function variantOf(document: Document, material: Material): MappingList {
  const variants = document.createExtension(KHRMaterialsVariants);
  const mapping = variants.createMapping().setMaterial(material).addVariant(variants.createVariant('clear'));
  return variants.createMappingList().addMapping(mapping);
}

const enlarged = ({ positions, triangles }: TriangleMesh, factor: number): TriangleMesh => ({
  positions: positions.map((value) => factor * value),
  triangles,
});

async function written(document: Document, compression: Compression, isKept = false): Promise<Document> {
  const model = await openModel([await glbFile(document)]);
  return exported(
    model,
    compression,
    model.bodies.map((body) => (isKept ? null : asResult(body))),
  );
}

async function exported(
  model: OpenModel,
  compression: Compression,
  results: (ExportedBody | null)[],
): Promise<Document> {
  const bodies = results.map((first) => first && { first, further: [] });
  const files = await exportFiles(model, bodies, {
    name: 'a.glb',
    form: { format: 'glb', isZipped: false },
    manner: { compression, style: 'files', keepsOrder: false },
    fields: false,
  });
  expect((await validateFiles(files))!.errors).toBe(0);
  return (await openModel(files)).document;
}

const quantized = (document: Document) => written(document, 'quantized');

/** Name and thickness in the space of the node, for all materials of its mesh: first those by default, then those of variants. */
function thicknessOf(node: Node): [string, number][] {
  const primitives = node.getMesh()!.listPrimitives();
  const variants = primitives.flatMap(
    (primitive) => primitive.getExtension<MappingList>('KHR_materials_variants')?.listMappings() ?? [],
  );
  return [...primitives, ...variants].flatMap((holder) => {
    const material = holder.getMaterial();
    const factor = material?.getExtension<Volume>('KHR_materials_volume')?.getThicknessFactor();
    return factor === undefined ? [] : [[material!.getName(), Math.fround(factor * node.getScale()[0])]];
  });
}

it('have the thickness of materials of variants in their units, also where meshes share the list of these', async () => {
  const document = startDocument();
  const plain = document.createMaterial('plain');
  const variant = variantOf(document, glass(document, 'clear', 0.5));
  for (const factor of [1, 10]) {
    const primitive = primitiveOf(document, enlarged(torus(), factor)).setMaterial(plain);
    addMesh(document, `ring ${factor}`, [primitive.setExtension('KHR_materials_variants', variant)]);
  }
  const root = (await quantized(document)).getRoot();
  expect(root.listNodes().map(thicknessOf)).toEqual([[['clear', 0.5]], [['clear', 0.5]]]);
  const names = root.listMaterials().map((material) => material.getName());
  expect(names.sort()).toEqual(['clear', 'clear', 'plain']);
});

it('have a material of several primitives and of a variant once', async () => {
  const document = startDocument();
  const [clear, tinted] = [glass(document, 'clear', 0.5), glass(document, 'tinted', 2)];
  const [first, second] = [torus(), torus()].map((mesh) => primitiveOf(document, mesh).setMaterial(clear));
  second.setExtension('KHR_materials_variants', variantOf(document, tinted));
  addMesh(document, 'rings', [first, second, primitiveOf(document, torus()).setMaterial(tinted)]);
  const root = (await quantized(document)).getRoot();
  expect(thicknessOf(root.listNodes()[0])).toEqual([
    ['clear', 0.5],
    ['clear', 0.5],
    ['tinted', 2],
    ['tinted', 2],
  ]);
  expect(root.listMaterials()).toHaveLength(2);
  expect(root.listMeshes()[0].listPrimitives()).toHaveLength(3);
});

it.each(['quantized', 'meshopt'] as const)('in %s keep the position of a quantized body', async (kind) => {
  const document = startDocument();
  const primitive = primitiveOf(document, torus());
  const integers = Int16Array.from(torus().positions, (value) => Math.round(3000 * value) + 5000);
  primitive.getAttribute('POSITION')!.setArray(integers);
  document.createExtension(KHRMeshQuantization).setRequired(true);
  addMesh(document, 'ring', [primitive]);
  document.getRoot().listNodes()[0].setScale([1e-3, 1e-3, 1e-3]);
  const cornersOf = (one: Document) => {
    const { min, max } = getBounds(one.getRoot().getDefaultScene()!);
    return [...min, ...max].map((value) => Number(value.toFixed(3)));
  };
  expect(cornersOf(await written(document, kind, true))).toEqual(cornersOf(document));
});

it.each(['quantized', 'meshopt'] as const)('in %s can have a mesh without any positions', async (kind) => {
  const document = startDocument();
  addMesh(document, 'ring', [primitiveOf(document, torus())]);
  const bare = document.createPrimitive().setAttribute('_HEAT', floats(document, 'SCALAR', [1, 2, 3]));
  addMesh(document, 'bare', [bare]);
  document.getRoot().listNodes()[1].setTranslation([1, 2, 3]);
  const root = (await written(document, kind)).getRoot();
  const [node] = root.listNodes().filter((one) => one.getMesh()?.getName() === 'bare');
  expect(node.getTranslation()).toEqual([1, 2, 3]);
  const semantics = node
    .getMesh()!
    .listPrimitives()
    .map((one) => one.listSemantics());
  expect(semantics).toEqual([['_HEAT']]);
  expect(root.listAccessors()).toHaveLength(3);
});

it('that move out of the range of the integers are floats, in all primitives of their mesh and in no other mesh', async () => {
  const document = startDocument();
  document.createExtension(KHRMeshQuantization).setRequired(true);
  const largest = Math.max(...torus().positions);
  for (const [name, count] of [
    ['moved', 2],
    ['still', 1],
  ] as const) {
    const primitives = Array.from({ length: count }, () => primitiveOf(document, torus()));
    for (const primitive of primitives) {
      const integers = Int16Array.from(torus().positions, (value) => Math.round((32767 / largest) * value));
      primitive.getAttribute('POSITION')!.setArray(integers).setNormalized(true);
    }
    addMesh(document, name, primitives);
  }
  const model = await openModel([await glbFile(document)]);
  const [moved, still] = model.bodies.map(asResult);
  const positions = moved.mesh.positions.map((value) => 1.004 * value);
  const results = [{ ...moved, mesh: { ...moved.mesh, positions } }, still];
  const root = (await exported(model, 'like-input', results)).getRoot();
  const placesOf = (mesh: Mesh) =>
    mesh.listPrimitives().map((primitive) => primitive.getAttribute('POSITION')!.getArray()!);
  const [floating, stored] = root.listMeshes().map(placesOf);
  expect(floating.map((one) => one.constructor)).toEqual([Float32Array, Float32Array]);
  expect(Math.max(...floating[0])).toBeCloseTo(1.004, 6);
  expect(stored[0]).toBeInstanceOf(Int16Array);
  const extensions = async (bodies: ExportedBody[]) =>
    (await exported(model, 'like-input', bodies))
      .getRoot()
      .listExtensionsUsed()
      .map(({ extensionName }) => extensionName);
  expect(await extensions(results)).toEqual(['KHR_mesh_quantization']);
  const bothMoved = results.map((one) => ({ ...one, mesh: { ...one.mesh, positions } }));
  expect(await extensions(bothMoved)).toEqual([]);
});
