// Runs the recipes for three.js and Babylon.js on levels that limber writes. Needs `npm run build`; installs babylonjs into a folder of its own.
//
//   node tests/bench/recipes/run_web.mjs
//
// The distances at which levels change are compared with where one pixel shows the deviation of the level.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { writeAssets } from '../batch_assets.mjs';

const root = resolve(import.meta.dirname, '..', '..', '..');
const folder = mkdtempSync(join(tmpdir(), 'limber-recipes-'));
const PACKAGES = ['@babylonjs/core@9.28.0', '@babylonjs/loaders@9.28.0'];
const [HEIGHT, DEGREES] = [1080, 50];

writeAssets(folder, { count: 1, faces: 1000, seed: 1 });
const report = JSON.parse(
  execFileSync(process.execPath, [
    ...[join(root, 'dist', 'cli', 'limber.mjs'), 'optimize', join(folder, 'sheet', 'sheet_0.obj')],
    ...[join(folder, 'lod0.glb'), '--ratio', '0.5', '--lods', '0.2,0.08', '--soft', '--report', '-'],
  ]),
);
const deviations = [report, ...report.levels].map(({ surface }) => surface.hausdorff);
const faces = [report, ...report.levels].map(({ output }) => output.faces);
const files = ['lod0.glb', 'lod0_lod1.glb', 'lod0_lod2.glb'].map((name) => readFileSync(join(folder, name)));
/** Where one pixel of the screen shows the deviation of the level. */
const distanceOf = (i, diagonal) =>
  ((deviations[i] / 100) * diagonal) / ((2 * Math.tan((DEGREES * Math.PI) / 360)) / HEIGHT);
const close = (a, b) => assert.ok(Math.abs(a - b) <= 1e-3 * Math.abs(b), `${a} is not ${b}`);

async function runThree() {
  const { PerspectiveCamera, Box3, Vector3 } = await import('three');
  // The loader of three.js asks for these of the page.
  globalThis.self ??= globalThis;
  const { GLTFLoader } = await import('three/examples/jsm/loaders/GLTFLoader.js');
  const { levelsOf } = await import(pathToFileURL(join(root, 'docs', 'recipes', 'three_levels.mjs')).href);
  const load = (bytes) =>
    new Promise((done, fail) => new GLTFLoader().parse(new Uint8Array(bytes).buffer, '', done, fail));
  const scenes = (await Promise.all(files.map(load))).map(({ scene }) => scene);
  const diagonal = new Box3().setFromObject(scenes[0]).getSize(new Vector3()).length();
  const camera = new PerspectiveCamera(DEGREES, 16 / 9);
  const lod = levelsOf(scenes, { deviations, camera, height: HEIGHT });
  for (const [i, level] of lod.levels.entries()) {
    if (i > 0) close(level.distance, distanceOf(i, diagonal));
    camera.position.set(0, 0, 0);
    camera.position.z = i === 0 ? 1e-6 : level.distance * 1.01;
    camera.updateMatrixWorld();
    lod.update(camera);
    assert.equal(lod.getCurrentLevel(), i);
    let shown = 0;
    lod.levels[i].object.traverse((one) => (shown += one.isMesh ? one.geometry.index.count / 3 : 0));
    assert.equal(shown, faces[i]);
  }
  console.log(
    `three.js: ${lod.levels.map(({ distance }, i) => `${faces[i]} faces from ${distance.toFixed(1)}`).join(', ')}`,
  );
}

async function runBabylon() {
  writeFileSync(join(folder, 'package.json'), '{ "private": true, "type": "module" }');
  execFileSync('npm', ['install', '--prefer-offline', '--no-audit', '--no-fund', ...PACKAGES], {
    cwd: folder,
    stdio: 'ignore',
  });
  copyFileSync(join(root, 'docs', 'recipes', 'babylon_levels.mjs'), join(folder, 'babylon_levels.mjs'));
  const program = join(folder, 'babylon.mjs');
  writeFileSync(
    program,
    `import { NullEngine, Scene, FreeCamera, Vector3, ImportMeshAsync } from '@babylonjs/core';
import '@babylonjs/loaders/glTF/index.js';
import { readFileSync } from 'node:fs';
import { addLevels } from './babylon_levels.mjs';
const { deviations, height, degrees } = JSON.parse(process.argv[2]);
const scene = new Scene(new NullEngine());
const camera = new FreeCamera('camera', new Vector3(0, 0, -1), scene);
camera.fov = (degrees * Math.PI) / 180;
const load = async (name) => {
  const data = 'data:model/gltf-binary;base64,' + readFileSync(name).toString('base64');
  const { meshes } = await ImportMeshAsync(data, scene, { pluginExtension: '.glb' });
  const mesh = meshes.find((one) => one.getTotalVertices() > 0);
  mesh.computeWorldMatrix(true);
  return mesh;
};
const meshes = [];
for (const name of ['lod0.glb', 'lod0_lod1.glb', 'lod0_lod2.glb']) meshes.push(await load(name));
const first = addLevels(meshes, { deviations, camera, height });
const { boundingSphere } = first.getBoundingInfo();
const shown = meshes.map((_, i) => {
  const distance = i === 0 ? 1e-3 : first.getLODLevels().find(({ mesh }) => mesh === meshes[i]).distanceOrScreenCoverage;
  camera.position = boundingSphere.centerWorld.add(new Vector3(0, 0, -1.01 * distance));
  camera.computeWorldMatrix(true);
  return { distance, faces: first.getLOD(camera).getTotalIndices() / 3 };
});
console.log(JSON.stringify({ shown, diagonal: 2 * boundingSphere.radiusWorld }));
process.exit(0);
`,
  );
  const words = JSON.stringify({ deviations, height: HEIGHT, degrees: DEGREES });
  const output = execFileSync(process.execPath, [program, words], { cwd: folder, encoding: 'utf8' });
  const { shown, diagonal } = JSON.parse(output.trim().split('\n').at(-1));
  assert.deepEqual(
    shown.map((one) => one.faces),
    faces,
  );
  for (const i of [1, 2]) close(shown[i].distance, distanceOf(i, diagonal));
  console.log(
    `Babylon.js: ${shown.map((one) => `${one.faces} faces from ${one.distance.toFixed(1)}`).join(', ')}`,
  );
}

try {
  await runThree();
  await runBabylon();
} finally {
  rmSync(folder, { recursive: true, force: true });
}
