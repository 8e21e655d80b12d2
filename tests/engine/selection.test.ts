import { beforeAll, describe, expect, it } from 'vitest';
import type { Core } from '../../web/engine/core/core';
import { openModel } from '../../web/engine/document/open';
import type { OpenModel } from '../../web/engine/document/open';
import { defaultSettings } from '../../web/engine/settings/options';
import { FileOutput } from '../../web/engine/stages/file_output';
import { FileRun } from '../../web/engine/stages/file_run';
import { chosenBodies } from '../../web/engine/body/selection';
import { loadTestCore } from './support/core';
import { failureOf } from './support/files';
import { addMesh, addRichMesh, glbFile, primitiveOf, readGlb, startDocument } from './support/gltf';
import { grid, torus } from './support/shapes';

let core: Core;
let model: OpenModel;

const choose = (settings: object) =>
  chosenBodies(model, { mesh: '', materialName: '', exclude: '', ...settings });

beforeAll(async () => {
  core = await loadTestCore(1);
  const document = startDocument();
  const [glass, metal] = ['Glass', 'Metal'].map((name) => document.createMaterial(name));
  addMesh(document, 'pane', [primitiveOf(document, torus()).setMaterial(glass)]);
  addMesh(document, 'frame', [primitiveOf(document, torus()).setMaterial(metal)]);
  addMesh(document, 'window', [
    primitiveOf(document, grid(4, 4)).setMaterial(glass),
    primitiveOf(document, grid(3, 3)).setMaterial(metal),
  ]);
  addMesh(document, 'plain', [primitiveOf(document, grid(4, 4))]);
  addRichMesh(document, 'rich', torus());
  model = await openModel([await glbFile(document)]);
});

describe('the bodies that are chosen', () => {
  it('are all by default', () => {
    expect(choose({})).toEqual([0, 1, 2, 3, 4]);
  });

  it('have a name of --mesh', () => {
    expect(choose({ mesh: 'p*' })).toEqual([0, 3]);
    expect(choose({ mesh: 'frame|window' })).toEqual([1, 2]);
  });

  it('have materials of --material-name alone', () => {
    expect(choose({ materialName: 'Glass' })).toEqual([0]);
    expect(choose({ materialName: 'Glass|Metal' })).toEqual([0, 1, 2]);
    expect(choose({ mesh: 'w*', materialName: '*a*' })).toEqual([2]);
  });

  it('are not excluded by their name or by one of their materials', () => {
    expect(choose({ exclude: 'Glass' })).toEqual([1, 3, 4]);
    expect(choose({ exclude: 'rich|frame' })).toEqual([0, 2, 3]);
    expect(choose({ mesh: 'p*', exclude: 'plain' })).toEqual([0]);
  });

  it('cannot be none: the error lists the existing ones', async () => {
    expect(await failureOf(() => choose({ mesh: 'door' }))).toBe(
      'test.glb has no body "door": it has "pane", "frame", "window", "plain", "rich".',
    );
    expect(await failureOf(() => choose({ mesh: 'window', materialName: 'Glass' }))).toBe(
      'test.glb has no body of material "Glass" alone: it has "Glass", "Metal".',
    );
    expect(await failureOf(() => choose({ mesh: 'plain', materialName: 'Glass' }))).toBe(
      'test.glb has no body of material "Glass" alone: it has faces without a material.',
    );
    expect(await failureOf(() => choose({ exclude: '*' }))).toMatch(/^test\.glb has no body besides "\*": /);
  });
});

describe('bodies that are not chosen', () => {
  it('stay byte for byte, with all of their attributes', async () => {
    const settings = { ...defaultSettings('qem'), mesh: 'p*' };
    const file = new FileRun(core, model, { chosen: chosenBodies(model, settings) });
    const targets = model.bodies.map(() => 10);
    const written = await readGlb(await new FileOutput(file, { settings, fields: false, targets }).glb());
    const [before, after] = [model.document, written].map((document) => document.getRoot().listMeshes());
    before.forEach((mesh, m) => {
      const isChosen = ['pane', 'plain'].includes(mesh.getName());
      mesh.listPrimitives().forEach((primitive, p) => {
        const other = after[m].listPrimitives()[p];
        if (isChosen) {
          expect(other.getIndices()!.getCount()).toBeLessThan(primitive.getIndices()!.getCount());
          return;
        }
        expect(other.listSemantics()).toEqual(primitive.listSemantics());
        const accessorsOf = (one: typeof primitive) => [
          one.getIndices()!,
          ...one.listAttributes(),
          ...one.listTargets().flatMap((target) => target.listAttributes()),
        ];
        accessorsOf(primitive).forEach((accessor, a) => {
          const copy = accessorsOf(other)[a];
          expect(copy.getArray()).toEqual(accessor.getArray());
          expect([copy.getType(), copy.getNormalized()]).toEqual([
            accessor.getType(),
            accessor.getNormalized(),
          ]);
        });
      });
    });
  });
});
