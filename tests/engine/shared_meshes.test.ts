/**
 * Tests on real meshes from a folder outside of the project: LIMBER_SHARED, or ../shared next to the repository. They are
 * skipped if that is absent.
 */

import type { Document, Mesh, Primitive } from '@gltf-transform/core';
import { existsSync, readFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { beforeAll, describe, expect, it } from 'vitest';
import type { Core } from '../../web/engine/core/core';
import { droppedByExport, exportGlb } from '../../web/engine/document/export';
import { companionNames } from '../../web/engine/document/gltf';
import { openModel } from '../../web/engine/document/open';
import type { OpenModel } from '../../web/engine/document/open';
import { validateGlb } from '../../web/engine/document/validate';
import { defaultSettings } from '../../web/engine/settings/options';
import { STAGES } from '../../web/engine/stages/stages';
import { exportedBody } from '../../web/engine/stages/written';
import { loadTestCore } from './support/core';
import { failureOf } from './support/files';
import { readGlb } from './support/gltf';
import { optimized as optimizedBy, runOfModel } from './support/runs';
import type { Optimized } from './support/runs';

const repository = new URL('../../', import.meta.url).pathname;
const meshes = join(process.env.LIMBER_SHARED ?? join(repository, '..', 'shared'), 'meshes');
const isAbsent = !existsSync(meshes);

const MODELS = [
  'derived_eiffel_6156.obj',
  'spot_uv.obj',
  'skirt_4k.obj',
  'pyramid_frame_genus4.obj',
  'bob_genus1.obj',
  'pirate.obj',
  'spot_quads_control.obj',
  'dirty/derived_bar_dirty.obj',
  'dirty/draco_mat_test.obj',
  'dirty/draco_octagon.obj',
  'dirty/draco_test_nm.obj',
  'dirty/gc_dodecahedron_poly.obj',
  'dirty/gc_hourglass_ico.obj',
  'dirty/gc_platonic_shelf.obj',
  'gltf/AnimatedMorphCube/AnimatedMorphCube.gltf',
  'gltf/BoxTextured_meshopt.glb',
  'gltf/Box_Draco.glb',
  'gltf/Fox.glb',
  'gltf/GolfBall.glb',
  'gltf/MorphStressTest.gltf',
  'gltf/SheenCloth.glb',
  'gltf/terrain.glb',
  'gltf/alien.glb',
  'gltf/derived_Fox_draco.glb',
  'gltf/derived_Fox_meshopt.glb',
  'gltf/derived_spot.glb',
  'gltf/derived_spot_draco.glb',
  'gltf/derived_spot_meshopt.glb',
  'gltf/derived_spot_quantized.glb',
  'gltf/derived_spot_separate/spot.gltf',
  'gltf/gltf_primitives.glb',
  'gltf/quad_skin.glb',
  'gltf/three_meshes_two_materials_one_no_material/three_meshes_two_materials_one_no_material.gltf',
];

function open(name: string): Promise<OpenModel> {
  const path = join(meshes, name);
  const read = (file: string) => new Uint8Array(readFileSync(file));
  const main = { name: basename(path), bytes: read(path) };
  const companions = companionNames(main).map((one) => ({
    name: one,
    bytes: read(join(dirname(path), one)),
  }));
  return openModel([main, ...companions]);
}

let core: Core;
beforeAll(async () => {
  core = await loadTestCore(2);
});

function optimize(model: OpenModel): Optimized[] {
  const settings = defaultSettings();
  return model.bodies.map((_, i) => {
    const run = runOfModel(core, model, i);
    const { mesh } = run.get(STAGES.prepared, settings);
    return optimizedBy(run, settings, Math.floor(mesh.triangles.length / 6));
  });
}

/** Validator messages about the exported file that would be absent if no body had been replaced. */
async function addedMessages(model: OpenModel, bytes: Uint8Array): Promise<string[]> {
  const codeOf = (message: string) => message.split(' ')[0];
  const before = await validateGlb(
    await exportGlb(
      model,
      model.bodies.map(() => null),
      { fields: false },
    ),
  );
  const known = new Set(before.messages.map(codeOf));
  return (await validateGlb(bytes)).messages.filter((message) => !known.has(codeOf(message)));
}

/** Everything that has to exist before and after; normals and fields may have been added. */
function inventory(document: Document) {
  const root = document.getRoot();
  return {
    materials: root.listMaterials().map((material) => material.getName()),
    images: root.listTextures().map((texture) => texture.getImage()?.length),
    skins: root.listSkins().map((skin) => skin.listJoints().length),
    animations: root.listAnimations().map((animation) => animation.listChannels().length),
    nodes: root
      .listNodes()
      .map((node) => [
        node.getName(),
        node.getMatrix().map((value) => Number(value.toFixed(5)) + 0),
        node.getExtras(),
      ]),
    // Names of morph targets are written even if they are the default ones.
    meshes: root
      .listMeshes()
      .map((mesh) => [mesh.getName(), mesh.getWeights(), { ...mesh.getExtras(), targetNames: null }]),
  };
}

const describePrimitives = (mesh: Mesh) => mesh.listPrimitives().map(describePrimitive);

function describePrimitive(primitive: Primitive) {
  const isAdded = (name: string) => ['NORMAL', 'POSITION', '_STRAIN', '_CURVATURE'].includes(name);
  const describe = (name: string) => {
    const accessor = primitive.getAttribute(name)!;
    return [name, accessor.getType(), accessor.getComponentType(), accessor.getNormalized()];
  };
  return {
    material: primitive.getMaterial()?.getName(),
    targets: primitive.listTargets().map((target) => [target.getName(), ...target.listSemantics()]),
    attributes: primitive
      .listSemantics()
      .filter((name) => !isAdded(name))
      .map(describe)
      .sort(),
  };
}

describe.skipIf(isAbsent)('a real mesh', () => {
  it.each(MODELS)(
    '%s is halved with its topology, or says why not, and exports without an error',
    async (name) => {
      const model = await open(name);
      const optimized = optimize(model);
      for (const { result, targetFaces, history, measured, modes } of optimized) {
        const { topology, flip, lock } = history.refused;
        if (result.mesh.triangles.length / 3 > targetFaces) expect(topology + flip + lock).toBeGreaterThan(0);
        expect(measured.certificate.kept).toBe(true);
        for (const { zeroModesFound, zeroModesExpected } of modes!.components)
          expect(zeroModesFound).toBe(zeroModesExpected);
        // A coarse solve is refined until its frequencies converge, not its residuals.
        for (const { residual, component } of modes!.modes)
          expect(residual).toBeLessThanOrEqual(modes!.components[component].coarseVertices > 0 ? 1e-2 : 1e-7);
      }
      const bodies = optimized.map((one) => exportedBody(core, one.prepared, one.result, one));
      const bytes = await exportGlb(model, bodies, { fields: true });
      expect(await addedMessages(model, bytes)).toEqual([]);
      expect(droppedByExport(model)).toEqual(model.unread);
      const written = await readGlb(bytes);
      expect(inventory(written)).toEqual(inventory(model.document));
      const before = model.document.getRoot().listMeshes().map(describePrimitives);
      written
        .getRoot()
        .listMeshes()
        .map(describePrimitives)
        .forEach((primitives, mesh) => expect(before[mesh]).toEqual(expect.arrayContaining(primitives)));
    },
  );

  it.each([
    ['dirty/draco_inf_nan.obj', 'draco_inf_nan.obj, line 1: x is inf, not a finite number.'],
    [
      'gltf/bad/BoxWithInfinites.glb',
      /^BoxWithInfinites\.glb, mesh "Mesh", primitive 0: vertex 0 is at \(-Infinity/,
    ],
    ['gltf/bad/IndexOutOfRange/IndexOutOfRange.gltf', /mesh "Mesh", primitive 0: index 255 is out of range/],
    [
      'gltf/bad/IndexOutOfRange/AllIndicesOutOfRange.gltf',
      /mesh "Mesh", primitive 0: index 65535 is out of range/,
    ],
  ])('%s is refused with one sentence', async (name, message) => {
    expect(await failureOf(() => open(name))).toMatch(message);
  });
});
