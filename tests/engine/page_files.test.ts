/** Files that the page is given: their names, and what is said of those that cannot be read. */

import { beforeEach, expect, it, vi } from 'vitest';
import { openAddress, openDropped } from '../../web/app/files/files';
import { applySettings, entryOf } from '../../web/app/files/settings_file';
import { loadSamples, samples } from '../../web/app/files/samples';
import type { BodySettings } from '../../web/engine/report/settings_file';
import type { SourceFile } from '../../web/engine/document/open';

const page = vi.hoisted(() => {
  vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} }));
  return { opened: [] as string[][], complaints: [] as string[] };
});

vi.mock('../../web/app/files/open_all', () => ({
  openAll: (files: SourceFile[]) => page.opened.push(files.map(({ name }) => name)),
}));
vi.mock('../../web/app/state/runner', () => ({ openFiles: () => Promise.resolve() }));
vi.mock('../../web/app/state/running', () => ({
  complain: ({ message }: Error) => void page.complaints.push(message),
}));

const fileEntry = (name: string, read = () => Promise.resolve(new ArrayBuffer(1))) => ({
  ...{ name, isFile: true, isDirectory: false },
  file: (resolve: (file: object) => void) => resolve({ name, arrayBuffer: read }),
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
  page.opened.length = page.complaints.length = 0;
});

it('files of a folder have paths below it', async () => {
  const inside = [folderEntry('a', fileEntry('skin.png')), folderEntry('b', fileEntry('skin.png'))];
  await drop(folderEntry('chair', fileEntry('chair.gltf'), ...inside));
  expect(page.opened).toEqual([['chair.gltf', 'a/skin.png', 'b/skin.png']]);
});

it('files of several folders are kept apart', async () => {
  const model = () => [fileEntry('scene.gltf'), fileEntry('scene.bin')];
  await drop(folderEntry('a', ...model()), folderEntry('b', ...model()));
  expect(page.opened).toEqual([['a/scene.gltf', 'a/scene.bin', 'b/scene.gltf', 'b/scene.bin']]);
});

it('of several entries with one name, that of the mesh is applied', () => {
  const bodies = [3, 1].map((meshNumber) => ({ name: 'cloth', level: 0, meshNumber }) as BodySettings);
  expect([1, 3, 7].map((mesh) => entryOf({ bodies }, { name: 'cloth', mesh }))).toEqual([
    bodies[1],
    bodies[0],
    bodies[0],
  ]);
  expect(entryOf({ bodies }, { name: 'sail', mesh: 1 })).toBe(null);
  expect(entryOf({ bodies: [bodies[0]] }, { name: 'sail', mesh: 1 })).toBe(bodies[0]);
});

it('a damaged settings file is to be saved again by its button', () => {
  applySettings({ name: 'sheet.settings.json', bytes: new TextEncoder().encode('{') });
  expect(page.complaints).toEqual(['sheet.settings.json is not JSON: save it again with “Save settings”.']);
});

it('a file that cannot be read is reported', async () => {
  await drop(fileEntry('large.glb', () => Promise.reject(new DOMException('', 'NotReadableError'))));
  expect(page.opened).toEqual([]);
  expect(page.complaints).toEqual([
    'large.glb cannot be read: it was moved or changed in the meantime, or is too large for this browser.',
  ]);
});

it('without a network there are no samples, and one that cannot be loaded is reported', async () => {
  vi.stubGlobal('fetch', () => Promise.reject(new TypeError('Failed to fetch')));
  await loadSamples();
  expect(samples.value).toEqual([]);
  await openAddress('./samples/bar.glb', 'bar.glb');
  expect(page.complaints).toEqual(['Failed to fetch']);
});
