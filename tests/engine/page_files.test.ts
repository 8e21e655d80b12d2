/** The names of files that the page is given. */

import { beforeEach, expect, it, vi } from 'vitest';
import { openDropped } from '../../web/app/files/files';
import type { SourceFile } from '../../web/engine/document/open';

const page = vi.hoisted(() => ({ opened: [] as string[][] }));

vi.mock('../../web/app/files/open_all', () => ({
  openAll: (files: SourceFile[]) => page.opened.push(files.map(({ name }) => name)),
}));
// The state of the page asks for the colour scheme.
vi.hoisted(() => vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} })));

vi.mock('../../web/app/state/runner', () => ({ openFiles: () => Promise.resolve() }));

const fileEntry = (name: string) => ({
  ...{ name, isFile: true, isDirectory: false },
  file: (resolve: (file: object) => void) =>
    resolve({ name, arrayBuffer: () => Promise.resolve(new ArrayBuffer(1)) }),
});

function folderEntry(name: string, ...children: object[]) {
  const batches = [children, []];
  const createReader = () => ({
    readEntries: (resolve: (found: object[]) => void) => resolve(batches.shift()!),
  });
  return { name, isFile: false, isDirectory: true, createReader };
}

const drop = (...entries: object[]) =>
  openDropped(entries.map((entry) => ({ webkitGetAsEntry: () => entry })) as unknown as DataTransferItemList);

beforeEach(() => {
  page.opened.length = 0;
});

it('files of a folder have their places below it', async () => {
  const inside = [folderEntry('a', fileEntry('skin.png')), folderEntry('b', fileEntry('skin.png'))];
  await drop(folderEntry('chair', fileEntry('chair.gltf'), ...inside));
  expect(page.opened).toEqual([['chair.gltf', 'a/skin.png', 'b/skin.png']]);
});

it('files of several folders keep apart', async () => {
  const model = () => [fileEntry('scene.gltf'), fileEntry('scene.bin')];
  await drop(folderEntry('a', ...model()), folderEntry('b', ...model()));
  expect(page.opened).toEqual([['a/scene.gltf', 'a/scene.bin', 'b/scene.gltf', 'b/scene.bin']]);
});
