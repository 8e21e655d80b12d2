// Files that cannot be opened are refused in Japanese, too.

import { afterEach, beforeEach, expect, test } from 'vitest';
import { JAPANESE } from '../../web/app/language/japanese/table';
import { shown } from '../../web/app/language/language';
import { sentence } from '../../web/app/language/say';
import { openModel } from '../../web/engine/document/open';

beforeEach(() => {
  shown.value = { language: 'ja', table: JAPANESE };
});
afterEach(() => {
  shown.value = { language: 'en', table: {} };
});

const OTHER = ['blend', 'fbx', 'usdz', 'max', 'ma', 'c4d', 'skp', 'ztl', 'hip', 'step', 'vrm', '7z', 'zip'];

const TRIANGLE = 'v 0 0 0\nv 1 0 0\nv 0 1 0\n';
const asset = { version: '2.0' };

const REFUSED: [name: string, text: string][] = [
  ...OTHER.map((ending): [string, string] => [`a.${ending}`, 'something']),
  ['a.txt', 'something'],
  ['a.obj', ''],
  ['a.obj', 'v 0 0 0\n'],
  ['a.obj', `${TRIANGLE}f 1 2 4\n`],
  ['a.obj', `${TRIANGLE}f 0 1 2\n`],
  ['a.obj', `${TRIANGLE}f 1 2 x\n`],
  ['a.obj', 'v 0 0 1e99\n'],
  ['a.obj', 'something\n'],
  ['a.stl', 'solid a\nendsolid a\n'],
  ['a.off', 'something'],
  ['a.off', 'OFF\n3 1 0\n0 0 0\n'],
  ['a.ply', 'ply\nformat ascii 1.0\nelement vertex 0\nend_header\n'],
  ['a.gltf', 'something'],
  ['a.gltf', '{}'],
  ['a.gltf', JSON.stringify({ asset: { version: '1.0' } })],
  ['a.gltf', JSON.stringify({ asset, extensionsRequired: ['EXT_other'] })],
  ['a.gltf', JSON.stringify({ asset, buffers: [{ uri: 'a.bin', byteLength: 4 }] })],
  ['a.gltf', JSON.stringify({ asset })],
];

/** Words that stay as they are: names of programs, formats and their parts. */
const NAMES =
  /a\.\w+|"\w+"|Blender|glTF|glb|GLB|gltf-pipeline|OBJ|STL|PLY|OFF|JSON|ZIP|FBX|USD|Universal Scene Description|3ds Max|Maya|Cinema 4D|SketchUp|ZBrush|Houdini|ROP|CAD|MeshLab|EXT_\w+/g;

test.each(REFUSED)('%s: %s', async (name, text) => {
  const bytes = new TextEncoder().encode(text);
  const error: unknown = await openModel([{ name, bytes }]).catch((one: unknown) => one);
  expect(error).toBeInstanceOf(Error);
  const { message } = error as Error;
  expect(sentence(message).replaceAll(NAMES, '')).not.toMatch(/[A-Za-z]{2}/);
});
