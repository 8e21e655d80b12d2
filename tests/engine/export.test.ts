import { EXTMeshFeatures, KHRDracoMeshCompression, KHRMaterialsVariants } from '@gltf-transform/extensions';
import { WebIO } from '@gltf-transform/core';
import type { Document, Mesh } from '@gltf-transform/core';
import { describe, expect, it } from 'vitest';
import type { TriangleMesh } from '../../web/engine/core/core';
import { ownSources } from '../../web/engine/body/attributes';
import { droppedByExport, exportGlb } from '../../web/engine/document/export';
import type { ExportedBody } from '../../web/engine/document/export';
import { openModel } from '../../web/engine/document/open';
import type { Body } from '../../web/engine/document/open';
import { validateGlb } from '../../web/engine/document/validate';
import { VERSION } from '../../web/engine/core/version';
import { SQUARE_OBJ, textFile } from './support/files';
import { addMesh, addRichMesh, floats, glbFile, primitiveOf, readGlb, startDocument } from './support/gltf';
import { cube, grid, toObj, torus } from './support/shapes';

/** A result with the body's own triangles, or the first `count` of them. */
function asResult(body: Body, count = body.indices.length / 3): ExportedBody {
  const { positions, indices } = body;
  const mesh: TriangleMesh = { positions, triangles: indices.slice(0, 3 * count) };
  const inputOfTriangle = Uint32Array.from({ length: count }, (_, t) => t);
  return { body, mesh, inputOfTriangle, sources: ownSources(mesh), hardCosine: null };
}

async function roundTrip(
  document: Document,
  choose: (body: Body) => ExportedBody | null = (body) => asResult(body),
) {
  const model = await openModel([await glbFile(document)]);
  const bytes = await exportGlb(model, model.bodies.map(choose), { fields: false });
  return { model, bytes, document: await readGlb(bytes), validation: await validateGlb(bytes) };
}

const meshNamed = (document: Document, name: string): Mesh =>
  document
    .getRoot()
    .listMeshes()
    .find((mesh) => mesh.getName() === name)!;

/** Triangles as triples of positions, independent of the numbering of vertices. */
function positionsOfCorners(mesh: Mesh): number[][] {
  return mesh.listPrimitives().flatMap((primitive) => {
    const positions = primitive.getAttribute('POSITION')!;
    return [...primitive.getIndices()!.getArray()!].map((vertex) => positions.getElement(vertex, []));
  });
}

describe('an exported GLB', () => {
  it('with nothing but positions needs no sources of its corners', async () => {
    const source = startDocument();
    addMesh(source, 'torus', [primitiveOf(source, torus())]);
    const files = [await glbFile(source), textFile('torus.obj', toObj(torus()))];
    for (const file of files) {
      const model = await openModel([file]);
      const written = (sources: 'own' | 'none') =>
        exportGlb(
          model,
          model.bodies.map((body) =>
            sources === 'own' ? asResult(body) : { ...asResult(body), sources: null },
          ),
          { fields: false },
        );
      expect(await written('none')).toEqual(await written('own'));
    }
  });

  it('from every format has no errors, no warnings and bit-equal positions', async () => {
    const shape = torus();
    shape.positions.forEach((value, i) => (shape.positions[i] = value / 3));
    const model = await openModel([textFile('torus.obj', toObj(shape))]);
    const bytes = await exportGlb(
      model,
      model.bodies.map((body) => asResult(body)),
      { fields: false },
    );
    expect(await validateGlb(bytes)).toEqual({ errors: 0, warnings: 0, messages: [] });
    const document = await readGlb(bytes);
    const expected = [...shape.triangles].map((v) => [...shape.positions.slice(3 * v, 3 * v + 3)]);
    expect(positionsOfCorners(meshNamed(document, 'torus'))).toEqual(expected);
    expect(new TextDecoder().decode(bytes)).toContain(`"generator":"Limber ${VERSION}"`);
  });

  it('is the same each time, and the model stays unchanged', async () => {
    const document = startDocument();
    addRichMesh(document, 'rich', cube());
    const model = await openModel([await glbFile(document)]);
    const write = () =>
      exportGlb(
        model,
        model.bodies.map((body) => asResult(body, 6)),
        { fields: false },
      );
    const before = droppedByExport(model);
    expect(await write()).toEqual(await write());
    expect(droppedByExport(model)).toEqual(before);
    const whole = await exportGlb(model, [null], { fields: false });
    expect((await readGlb(whole)).getRoot().listTextures()).toHaveLength(1);
  });

  it('drops nothing that glTF can carry', async () => {
    const source = startDocument();
    addRichMesh(source, 'rich', cube());
    const { model, document, validation } = await roundTrip(source);
    expect(droppedByExport(model)).toEqual([]);
    expect(validation).toEqual({ errors: 0, warnings: 0, messages: [] });
    const root = document.getRoot();
    const [primitive] = root.listMeshes()[0].listPrimitives();
    const expected = [
      'COLOR_0',
      'JOINTS_0',
      'NORMAL',
      'POSITION',
      'TANGENT',
      'TEXCOORD_0',
      'WEIGHTS_0',
      '_HEAT',
    ];
    expect(primitive.listSemantics().sort()).toEqual(expected);
    const left = [root.listTextures(), root.listSkins(), root.listAnimations(), primitive.listTargets()];
    expect(left.map((list) => list.length)).toEqual([1, 1, 1, 1]);
    expect(root.listMeshes()[0].getWeights()).toEqual([0.5]);
    expect(primitive.listTargets()[0].getName()).toBe('fat');
    const info = primitive.getMaterial()!.getBaseColorTextureInfo()!;
    expect(info.getExtension('KHR_texture_transform')).not.toBeNull();
  });

  it('lists what shapes replace, and the extensions that are valid only for the old vertices', async () => {
    const source = startDocument();
    const features = source.createExtension(EXTMeshFeatures);
    const implicit = features.createFeatures().addFeatureID(features.createFeatureID().setFeatureCount(8));
    addRichMesh(source, 'rich', cube()).listPrimitives()[0].setExtension('EXT_mesh_features', implicit);
    const { model, document } = await roundTrip(source);
    expect(droppedByExport(model)).toEqual(['extension EXT_mesh_features']);
    expect(droppedByExport(model, true)).toEqual(['1 morph target', 'extension EXT_mesh_features']);
    expect(
      document
        .getRoot()
        .listExtensionsUsed()
        .map((one) => one.extensionName),
    ).toEqual(['KHR_texture_transform']);
  });

  it('keeps hierarchy, names and extras', async () => {
    const source = startDocument();
    const mesh = addMesh(source, 'cube', [primitiveOf(source, cube()).setExtras({ part: 1 })]).setExtras({
      a: [1],
    });
    const parent = source.createNode('parent').setExtras({ b: 2 }).setTranslation([1, 2, 3]);
    parent.addChild(source.createNode('child').setMesh(mesh)).addChild(source.createNode('empty'));
    source.getRoot().getDefaultScene()!.addChild(parent).setExtras({ c: 3 });
    source.getRoot().getAsset().copyright = 'somebody';
    const { document } = await roundTrip(source);
    const root = document.getRoot();
    expect(root.listNodes().map((node) => node.getName())).toEqual(['cube node', 'parent', 'child', 'empty']);
    const found = root.listNodes()[1];
    expect([found.getTranslation(), found.getExtras()]).toEqual([[1, 2, 3], { b: 2 }]);
    expect(found.listChildren()[0].getMesh()).toBe(root.listMeshes()[0]);
    expect(root.listMeshes()[0].getExtras()).toEqual({ a: [1] });
    expect(root.listMeshes()[0].listPrimitives()[0].getExtras()).toEqual({ part: 1 });
    expect(root.getDefaultScene()!.getExtras()).toEqual({ c: 3 });
    expect(root.getAsset().copyright).toBe('somebody');
  });

  it('keeps every face with its material, and drops a primitive that has lost all its faces', async () => {
    const source = startDocument();
    const [red, green, blue] = ['red', 'green', 'blue'].map((name) =>
      primitiveOf(source, cube()).setMaterial(source.createMaterial(name)),
    );
    const lines = primitiveOf(source, cube()).setMode(1);
    addMesh(source, 'cube', [red, lines, green, blue]);
    const onlyGreenAndBlue = (body: Body): ExportedBody => {
      const kept = [35, 12, 34];
      const triangles = kept.flatMap((t) => [...body.indices.slice(3 * t, 3 * t + 3)]);
      const mesh = { positions: body.positions, triangles: Uint32Array.from(triangles) };
      const sources = ownSources(mesh);
      sources.triangle = sources.triangle.map((t) => kept[t]);
      return { body, mesh, inputOfTriangle: Uint32Array.from(kept), sources, hardCosine: null };
    };
    const { document, validation } = await roundTrip(source, onlyGreenAndBlue);
    const primitives = document.getRoot().listMeshes()[0].listPrimitives();
    const described = primitives.map((one) => [
      one.getMaterial()?.getName(),
      one.getMode(),
      one.getIndices()!.getCount(),
    ]);
    expect(described).toEqual([
      [undefined, 1, 36],
      ['green', 4, 3],
      ['blue', 4, 6],
    ]);
    expect(validation.errors).toBe(0);
  });

  it('keeps everything of a body that is not replaced', async () => {
    const source = startDocument();
    const rich = addRichMesh(source, 'rich', cube());
    const shared = rich.listPrimitives()[0].getMaterial();
    const uv = floats(source, 'VEC2', new Float32Array(18));
    const plain = primitiveOf(source, grid(2, 2)).setMaterial(shared).setAttribute('TEXCOORD_0', uv);
    addMesh(source, 'plain', [plain]);
    const { document, validation } = await roundTrip(source, ({ name, ...body }) =>
      name === 'plain' ? asResult({ name, ...body }) : null,
    );
    expect(validation).toEqual({ errors: 0, warnings: 0, messages: [] });
    const kept = meshNamed(document, 'rich').listPrimitives()[0];
    expect(kept.listSemantics()).toHaveLength(8);
    expect(kept.getMaterial()!.getBaseColorTexture()!.getName()).toBe('picture');
    const info = kept.getMaterial()!.getBaseColorTextureInfo()!;
    expect(info.getExtension('KHR_texture_transform')).not.toBeNull();
    expect(kept.listTargets()).toHaveLength(1);
    expect(meshNamed(document, 'plain').listPrimitives()[0].getMaterial()).toBe(kept.getMaterial());
    expect(document.getRoot().listSkins()).toHaveLength(1);
  });

  it('keeps the joint weights of a Draco file adding up to 1', async () => {
    const source = startDocument();
    const rich = addRichMesh(source, 'rich', cube());
    rich.listPrimitives()[0].getAttribute('WEIGHTS_0')!.setElement(0, [1.01, 0, 0, 0]);
    const model = await openModel([await glbFile(source)]);
    const errors = async () => (await validateGlb(await exportGlb(model, [null], { fields: false }))).errors;
    expect(await errors()).toBe(1);
    model.document.createExtension(KHRDracoMeshCompression);
    expect(await errors()).toBe(0);
  });

  it('keeps material variants, also one that no primitive names', async () => {
    const source = startDocument();
    const variants = source.createExtension(KHRMaterialsVariants);
    variants.createVariant('day');
    const mapping = variants
      .createMapping()
      .setMaterial(source.createMaterial('other'))
      .addVariant(variants.createVariant('night'));
    const primitive = primitiveOf(source, cube()).setMaterial(source.createMaterial('day'));
    primitive.setExtension('KHR_materials_variants', variants.createMappingList().addMapping(mapping));
    addMesh(source, 'cube', [primitive]);
    const { model, document, validation } = await roundTrip(source);
    expect(droppedByExport(model)).toEqual([]);
    expect(validation.errors).toBe(0);
    expect(
      document.getRoot().listMeshes()[0].listPrimitives()[0].getExtension('KHR_materials_variants'),
    ).not.toBeNull();
    const [extension] = document.getRoot().listExtensionsUsed() as KHRMaterialsVariants[];
    expect(extension.listVariants().map((variant) => variant.getName())).toEqual(['day', 'night']);
  });

  it('keeps the version that a file needs, extras of variants, and names and extras of their materials', async () => {
    const source = startDocument();
    source.getRoot().getAsset().minVersion = '2.0';
    const variants = source.createExtension(KHRMaterialsVariants);
    const day = variants.createVariant('day').setExtras({ light: 'sun' });
    const mapping = variants
      .createMapping()
      .setName('at day')
      .setExtras({ from: 6 })
      .setMaterial(source.createMaterial('bright'))
      .addVariant(day);
    const primitive = primitiveOf(source, cube()).setMaterial(source.createMaterial('plain'));
    primitive.setExtension('KHR_materials_variants', variants.createMappingList().addMapping(mapping));
    addMesh(source, 'cube', [primitive]);
    const model = await openModel([await glbFile(source)]);
    const bytes = await exportGlb(model, [asResult(model.bodies[0])], { fields: false });
    const { json } = await new WebIO().binaryToJSON(bytes as Uint8Array<ArrayBuffer>);
    expect(json.asset.minVersion).toBe('2.0');
    expect(json.extensions).toEqual({
      KHR_materials_variants: { variants: [{ name: 'day', extras: { light: 'sun' } }] },
    });
    expect(json.meshes![0].primitives[0].extensions!.KHR_materials_variants).toEqual({
      mappings: [{ name: 'at day', extras: { from: 6 }, material: 0, variants: [0] }],
    });
  });

  it('has unit normals if the format prescribes none, split at sharp edges and shared where smooth', async () => {
    const models = { cube: cube(), torus: torus() };
    const counts = { cube: 24, torus: torus().positions.length / 3 };
    for (const name of ['cube', 'torus'] as const) {
      const model = await openModel([textFile(`${name}.obj`, toObj(models[name]))]);
      const document = await readGlb(await exportGlb(model, [asResult(model.bodies[0])], { fields: false }));
      const normals = document.getRoot().listMeshes()[0].listPrimitives()[0].getAttribute('NORMAL')!;
      expect(normals.getCount()).toBe(counts[name]);
      for (let v = 0; v < normals.getCount(); ++v)
        expect(Math.hypot(...normals.getElement(v, []))).toBeCloseTo(1, 6);
    }
  });

  it('has no normals if the glTF has none, so that it is shaded flat as before', async () => {
    const source = startDocument();
    addMesh(source, 'cube', [primitiveOf(source, cube())]);
    const { document, validation } = await roundTrip(source);
    const [primitive] = document.getRoot().listMeshes()[0].listPrimitives();
    expect(primitive.listSemantics()).toEqual(['POSITION']);
    expect(primitive.getAttribute('POSITION')!.getCount()).toBe(8);
    expect(validation.errors).toBe(0);
  });

  it('carries fields per vertex if requested', async () => {
    const model = await openModel([textFile('square.obj', SQUARE_OBJ)]);
    const fields = { strain: Float32Array.from([0, 1, 2, 3]), curvature: Float32Array.from([4, 5, 6, 7]) };
    const body = { ...asResult(model.bodies[0]), fields };
    const attribute = async (asked: boolean, name: string) => {
      const bytes = await exportGlb(model, [body], { fields: asked });
      expect((await validateGlb(bytes)).errors).toBe(0);
      const [primitive] = (await readGlb(bytes)).getRoot().listMeshes()[0].listPrimitives();
      return primitive.getAttribute(name)?.getArray();
    };
    expect([...(await attribute(true, '_STRAIN'))!]).toEqual([0, 1, 2, 3]);
    expect([...(await attribute(true, '_CURVATURE'))!]).toEqual([4, 5, 6, 7]);
    expect(await attribute(false, '_STRAIN')).toBeUndefined();
  });

  it('drops what an earlier run wrote about a replaced mesh, and keeps it for others', async () => {
    const source = startDocument();
    const earlier = ['_STRAIN', '_CURVATURE', '_LIMBER_MASS', '_LIMBER_BEND'];
    const extras = { limberSettings: { solver: 'newton' }, limberCalibration: 2, mood: 1 };
    for (const [name, semantics] of Object.entries({ kept: earlier, new: earlier, own: ['_STRAIN'] })) {
      const primitive = primitiveOf(source, cube());
      const values = () => floats(source, 'SCALAR', Array(8).fill(0.5));
      for (const semantic of semantics) primitive.setAttribute(semantic, values());
      addMesh(source, name, [primitive]).setExtras(extras);
    }
    const { document } = await roundTrip(source, (body) => (body.name === 'kept' ? null : asResult(body)));
    const semanticsOf = (name: string) => meshNamed(document, name).listPrimitives()[0].listSemantics();
    expect(semanticsOf('kept')).toEqual(['POSITION', ...earlier]);
    expect(semanticsOf('new')).toEqual(['POSITION']);
    expect(semanticsOf('own').sort()).toEqual(['POSITION', '_STRAIN']);
    expect(meshNamed(document, 'kept').getExtras()).toEqual(extras);
    expect(meshNamed(document, 'new').getExtras()).toEqual({ mood: 1 });
    const model = await openModel([await glbFile(source)]);
    const settings = {
      extras: { solver: 'jolt' },
      attributes: { _LIMBER_MASS: new Float32Array(8).fill(3) },
    };
    const tuned = model.bodies.map((body) => ({ ...asResult(body), settings }));
    const again = await readGlb(await exportGlb(model, tuned, { fields: false }));
    const [primitive] = meshNamed(again, 'new').listPrimitives();
    expect(primitive.listSemantics().sort()).toEqual(['POSITION', '_LIMBER_MASS']);
    expect(primitive.getAttribute('_LIMBER_MASS')!.getScalar(0)).toBe(3);
    expect(meshNamed(again, 'new').getExtras()).toEqual({ limberSettings: settings.extras, mood: 1 });
  });

  it('writes shapes as morph targets, each with an animation', async () => {
    const model = await openModel([textFile('square.obj', SQUARE_OBJ)]);
    const displacements = Float32Array.from({ length: 12 }, (_, i) => i);
    const targets = [
      { name: 'mode 1', displacements },
      { name: 'mode 2', displacements },
    ];
    const bytes = await exportGlb(model, [{ ...asResult(model.bodies[0]), targets }], { fields: false });
    expect(await validateGlb(bytes)).toEqual({ errors: 0, warnings: 0, messages: [] });
    const root = (await readGlb(bytes)).getRoot();
    expect(root.listAnimations().map((animation) => animation.getName())).toEqual(['mode 1', 'mode 2']);
    expect(root.listMeshes()[0].getExtras()).toEqual({ targetNames: ['mode 1', 'mode 2'] });
    const [primitive] = root.listMeshes()[0].listPrimitives();
    expect([...primitive.listTargets()[1].getAttribute('POSITION')!.getArray()!]).toEqual([...displacements]);
  });
  it('writes shapes of a mesh that has lines beside its triangles', async () => {
    const source = startDocument();
    const lines = primitiveOf(source, cube()).setMode(1);
    addMesh(source, 'cube', [primitiveOf(source, cube()), lines]);
    const model = await openModel([await glbFile(source)]);
    const displacements = new Float32Array(model.bodies[0].positions.length).fill(1);
    const body = { ...asResult(model.bodies[0]), targets: [{ name: 'mode 1', displacements }] };
    const bytes = await exportGlb(model, [body], { fields: false });
    expect((await validateGlb(bytes)).messages).toEqual([]);
    const written = (await readGlb(bytes)).getRoot().listMeshes()[0].listPrimitives();
    const moved = written.map((primitive) => primitive.listTargets()[0].getAttribute('POSITION')!.getMax([]));
    expect(moved).toEqual([
      [1, 1, 1],
      [0, 0, 0],
    ]);
  });
});
