/** The names of the files that the worker of the library makes. */

import { expect, it } from 'vitest';
import type { ModelFile, OptimizedGlb, Reported } from '../../web/library/options';
import type { WorkMessage, WorkRequest } from '../../web/library/protocol';
import { Server } from '../../web/library/work/serve';
import { resultName } from '../../web/engine/document/write/output_form';
import { textFile } from '../engine/support/files';
import { addRichMesh, glbFile, startDocument } from '../engine/support/gltf';
import { grid, toObj, torus } from '../engine/support/shapes';

const wasmFolder = new URL('../../public/wasm/', import.meta.url).href;

async function answer<Reply>(request: Omit<WorkRequest, 'core'>): Promise<Reply> {
  const messages: WorkMessage[] = [];
  await new Server((message) => messages.push(message)).answer({ ...request, core: { wasmFolder } });
  const last = messages.at(-1)!;
  if (!('value' in last)) throw new Error(JSON.stringify(last));
  return last.value as unknown as Reply;
}

const optimized = (model: ModelFile[], options: object): Promise<OptimizedGlb> =>
  answer({
    command: 'optimize',
    models: [model],
    options: { threads: 1, wantsBodies: false, validate: false, ...options },
  });

const facesOf = async (files: ModelFile[]): Promise<number> => {
  const { report } = await answer<Reported>({ command: 'inspect', models: [files], options: { threads: 1 } });
  return report.input.faces;
};

/** A sheet with a picture, under this name. */
async function sheet(name: string): Promise<ModelFile[]> {
  const document = startDocument();
  addRichMesh(document, 'sheet', grid(8, 8));
  return [await glbFile(document, name)];
}

it.each([
  ['auto', ['chair.glb'], ['chair_lod1.glb']],
  [
    'gltf',
    ['chair.gltf', 'chair_picture.png', 'chair.bin'],
    ['chair_lod1.gltf', 'chair_lod1_picture.png', 'chair_lod1.bin'],
  ],
  [
    'obj',
    ['chair.obj', 'chair.mtl', 'chair_picture.png'],
    ['chair_lod1.obj', 'chair_lod1.mtl', 'chair_lod1_picture.png'],
  ],
  ['ply', ['chair.ply'], ['chair_lod1.ply']],
  ['gltf.zip', ['chair.gltf.zip'], ['chair_lod1.gltf.zip']],
])('files of %s go into one folder, and come back from it as models', async (format, names, namesOfLevel) => {
  const { files, levels, report } = await optimized(await sheet('parts/chair.glb'), { format, lods: [0.3] });
  expect(files.map(({ name }) => name)).toEqual(names);
  expect(levels[0].files.map(({ name }) => name)).toEqual(namesOfLevel);
  expect(report.levels![0].file).toBe(namesOfLevel[0]);
  expect(await facesOf(files)).toBe(report.output!.faces);
  expect(await facesOf(levels[0].files)).toBe(report.levels![0].output.faces);
});

it('a level that goes into the file of the first has its name and no file', async () => {
  const { levels } = await optimized(await sheet('chair.glb'), { lods: [0.3], lodStyle: 'nodes' });
  expect(levels).toMatchObject([{ glb: null, files: [], report: { file: 'chair.glb' } }]);
});

it('levels of a document, which has no name, are called model', async () => {
  const ring = [textFile('document.obj', toObj(torus()))];
  const { levels } = await optimized(ring, { wantsBodies: true, lods: [0.3] });
  expect(levels[0].files.map(({ name }) => name)).toEqual(['model_lod1.glb']);
});

it('a result is called as its model, without folder and ending', () => {
  const named = (input: string) => resultName(input, 'auto');
  expect(['chair.obj', 'a\\b/chair.v2.STL', 'chair.obj.zip', 'chair'].map(named)).toEqual([
    'chair.glb',
    'chair.v2.glb',
    'chair.glb',
    'chair.glb',
  ]);
  expect(['', '.glb', 'a/.zip'].map(named)).toEqual(['model.glb', 'model.glb', 'model.glb']);
});
