/** What the page's flows decide without a page. */

import { expect, test, vi } from 'vitest';
import { formOfName } from '../../web/engine/document/write/output_form';
import { defaultSettings } from '../../web/engine/settings/options';
import { scrolls } from '../../web/app/controls/scroll_keys';
import {
  firstNoLevel,
  levelAtHeight,
  nextLevel,
  readLevels,
  switchHeights,
} from '../../web/app/panels/export/level_chain';
import type { Client } from '../../web/app/state/client';
import { exportedKey, exportRequest, genericKey, pictureName } from '../../web/app/state/export_request';
import { compareMethods, comparisonKey } from '../../web/app/state/methods';
import { freeName, modelGroups, suffixedName } from '../../web/app/state/queue/model_groups';
import { describeOutcome, describeProgress, summaryCsv } from '../../web/app/state/queue/summary';
import { changeSettings, results } from '../../web/app/state/store';
import { CANCELLED, resultFileKey } from '../../web/app/worker/protocol';
import type { OpenedFile } from '../../web/app/worker/protocol';
import {
  drawnSettings,
  EXPORT_FORMATS,
  exportFormatOf,
  exportSettings,
} from '../../web/app/worker/export_form';

// The state of the page asks for the colour scheme.
vi.hoisted(() => vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} })));

const file = (name: string, length = 1) => ({ name, bytes: new Uint8Array(length) });

test('the ending of every format of the page says the format to the engine', () => {
  for (const { value, ending } of EXPORT_FORMATS) {
    const form = formOfName(`model${ending}`, 'stl')!;
    const word = `${form.format}${form.isZipped ? '.zip' : ''}`;
    expect(word).toBe(value === 'auto' ? 'glb' : value);
  }
});

test.each(['auto', 'ply', 'obj.zip'] as const)('a picture never has the name of a model as %s', (format) => {
  results.file.value = { name: 'in/bar.obj', bodies: [] } as unknown as OpenedFile;
  changeSettings({ format });
  expect(pictureName('figure.png')).toBe('bar-figure.png');
  expect(exportRequest().output).toMatch(/^bar-limber\.(glb|ply|obj\.zip)$/);
});

test('a format of several files that a link names is packed, and what a format cannot have is left out', () => {
  expect(exportFormatOf({ format: 'obj' }).ending).toBe('.obj.zip');
  const asked = { ...defaultSettings(), format: 'ply', compress: 'draco', lodStyle: 'msft' } as const;
  expect(exportSettings({ ...asked })).toMatchObject({
    format: 'ply',
    compress: 'like-input',
    lodStyle: 'files',
  });
});

test('the picture of a result waits for no tuning, and its solver counts where frequencies there limit its faces', () => {
  const own = { ...defaultSettings(), solver: 'blender', tune: 'vertex', engine: 'mass=2' } as const;
  const kept = { faces: null, own: [] };
  expect(drawnSettings({ ...own }).solver).toBe('none');
  expect(resultFileKey({ ...own }, kept)).toBe(resultFileKey(defaultSettings(), kept));
  expect(drawnSettings({ ...own, maxFrequencyError: 1 }).solver).toBe('blender');
});

test.each([{ seconds: 3 }, { scenario: 'sway' }, { friction: 0.1 }] as const)(
  'an export is made again for its report where that alone names %o, and the files for all engines are not',
  (change) => {
    const [exported, generic] = [exportedKey(), genericKey()];
    changeSettings(change);
    expect([exportedKey() === exported, genericKey() === generic]).toEqual([false, true]);
  },
);

test('levels are shares, percents or numbers of faces that the share leads back to', () => {
  expect(readLevels('0.25, 10 %', 1792)).toEqual([0.25, 0.1]);
  for (const faces of [2, 333, 1791]) {
    const [share] = readLevels(String(faces), 1792) as number[];
    expect(Math.floor(share * 1792)).toBe(faces);
  }
  expect(readLevels('much', 1792)).toEqual(['much']);
  expect(firstNoLevel('0.25, 10 %, 500', 1792)).toBeNull();
  expect(firstNoLevel('500, 5000, abc, -3', 1792)).toBe('5000');
  expect(firstNoLevel('500, abc', 1792)).toBe('abc');
  expect(nextLevel([], 0.5)).toBe(0.25);
  expect(nextLevel([0.1], 0.5)).toBe(0.05);
});

test('a level takes over where its error is one pixel, and never before the one above it', () => {
  const heights = switchHeights([0.5, 2, 1]);
  expect(heights.map(Math.round)).toEqual([200, 50, 50]);
  expect([400, 199, 51, 49].map((height) => levelAtHeight(heights, height))).toEqual([0, 1, 1, 3]);
});

test('each of several models has the companions of its own folder', () => {
  const files = [file('b/b.gltf'), file('b/b.bin'), file('a.stl'), file('read.png'), file('b/in/c.obj')];
  const groups = modelGroups(files).map(({ name, files: own }) => [
    name,
    ...own.slice(1).map((one) => one.name),
  ]);
  expect(groups).toEqual([['a.stl'], ['b/b.gltf', 'b/b.bin'], ['b/in/c.obj']]);
});

test('models of one name become files of different names', () => {
  const taken = new Set<string>();
  expect(['d/a.obj', 'd/a.stl', 'a.obj'].map((name) => freeName(name, '.glb', taken))).toEqual([
    'd/a-limber.glb',
    'd/a-limber-2.glb',
    'a-limber.glb',
  ]);
});

test('the result of a result has a number in place of another suffix', () => {
  const names = ['alien', 'alien-limber', 'alien-limber-2', 'limber'].map(suffixedName);
  expect(names).toEqual(['alien-limber', 'alien-limber-2', 'alien-limber-3', 'limber-limber']);
});

test('the time left goes by the bytes that are done', () => {
  const items = [
    { state: 'done', files: [file('a', 100)] },
    { state: 'failed', files: [file('b', 100)] },
    { state: 'running', files: [file('c', 600)] },
  ] as const;
  expect(describeProgress(items, 10)).toBe('3 of 3, 30 s left');
  expect(describeProgress(items, 0.1)).toBe('3 of 3');
  expect(describeProgress([items[2], items[2]], 10)).toBe('1 of 2');
  expect(describeOutcome(items.slice(0, 2))).toBe('1 done and 1 failed');
});

test('the table of a queue quotes what would break its cells', () => {
  const failed = {
    name: 'a,b.obj',
    state: 'failed',
    files: [],
    sentence: 'It says "no".',
    finished: null,
  } as const;
  expect(summaryCsv([failed]).split('\r\n')[1]).toBe('"a,b.obj",failed,,,,,,,"It says ""no""."');
});

test('a region scrolls by the keys of the direction in which it has more', () => {
  const keysOf = (scrollWidth: number, scrollHeight: number): string[] =>
    ['ArrowLeft', 'ArrowUp', 'Home', 'PageDown', 'f'].filter((key) =>
      scrolls({ scrollWidth, scrollHeight, clientWidth: 10, clientHeight: 10 }, key),
    );
  expect(keysOf(10, 10)).toEqual([]);
  expect(keysOf(11, 10)).toEqual(['ArrowLeft']);
  expect(keysOf(10, 11)).toEqual(['ArrowUp', 'Home', 'PageDown']);
});

test.each([
  [{ pins: 'low:5' }, false],
  [{ young: 2e6 }, false],
  [{ seams: 'cross' }, false],
  [{ scenario: 'sway' }, true],
  [{ compress: 'draco' }, true],
] as const)('whether methods compared before are those of %o too: %s', (change, isSame) => {
  changeSettings(defaultSettings());
  const before = comparisonKey();
  changeSettings(change);
  expect(comparisonKey() === before).toBe(isSame);
});

test('methods are compared no further once the inputs have changed', async () => {
  const call = vi.fn(() => {
    changeSettings({ strainWeight: 2 });
    return Promise.resolve({});
  });
  await expect(compareMethods({ call } as unknown as Client)).rejects.toThrow(CANCELLED);
  expect(call).toHaveBeenCalledOnce();
});
