/** What was done to a file comes back when it is opened again: a page whose worker opens files and computes nothing. */

import { afterEach, beforeAll, expect, it, vi } from 'vitest';
import { closeQueue, fillQueue } from '../../web/app/state/queue/queue';
import { openFiles, startRunner } from '../../web/app/state/runner';
import { changeSettings, status, wants } from '../../web/app/state/store';
import { redo, undo } from '../../web/app/state/undo';
import type { SourceFile } from '../../web/engine/document/open';
import { defaultSettings } from '../../web/engine/settings/options';

vi.hoisted(() => {
  // The state of the page asks for the colour scheme.
  vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} }));
  vi.stubGlobal('addEventListener', () => {});
});

vi.mock('../../web/app/state/running', () => ({
  client: {
    canStop: true,
    threads: 1,
    ready: () => Promise.resolve(),
    call: () => Promise.reject(new Error('It computes nothing.')),
    open: ([{ name }]: SourceFile[]) =>
      Promise.resolve({ name, bodies: [{ faces: 9, health: [] }], first: 0 }),
    cancel: () => {},
  },
  complain: () => {},
  replayer: { open: () => {} },
  whileBusy: (_what: string, make: () => Promise<unknown>) => make(),
}));
vi.mock('../../web/app/state/work/kept_work', async (importActual) => ({
  ...(await importActual<object>()),
  contentKey: ([{ name }]: SourceFile[]) => Promise.resolve(name),
}));
vi.mock('../../web/app/state/saved_session', () => ({ saveFiles: () => {}, startSaving: () => {} }));
vi.mock('../../web/app/state/replay', () => ({ isReplayed: { value: true }, startReplay: () => {} }));

const openNamed = (name: string): Promise<void> => openFiles([{ name, bytes: new Uint8Array() }]);
const store = new Map<string, string>();

beforeAll(() => {
  startRunner();
  vi.stubGlobal('localStorage', {
    get length() {
      return store.size;
    },
    key: (i: number) => [...store.keys()][i],
    getItem: (key: string) => store.get(key) ?? null,
    setItem: (key: string, text: string) => void store.set(key, text),
    removeItem: (key: string) => void store.delete(key),
  });
});
afterEach(() => store.clear());

it('what was done to a file comes back with it, in the format that is chosen now', async () => {
  await openNamed('a');
  changeSettings({ pins: 'low:6', paint: '0:5x3', method: 'qem', format: 'ply' });
  wants.faces.value = 7;
  await openNamed('b');
  expect([wants.settings.value.pins, wants.faces.value, status.notice.value]).toEqual(['', null, null]);
  changeSettings({ format: 'obj.zip', method: 'limber' });
  await openNamed('a');
  const done = { pins: 'low:6', paint: '0:5x3', method: 'qem', format: 'obj.zip' };
  expect(wants.settings.value).toMatchObject(done);
  expect([wants.faces.value, status.notice.value?.action?.label]).toEqual([7, 'Start anew']);
});

it('it is left behind by a start anew, which is a step of Undo and is not told again', async () => {
  await openNamed('a');
  changeSettings({ pins: 'low:6' });
  await openNamed('b');
  await openNamed('a');
  status.notice.value!.action!.run();
  expect([wants.settings.value.pins, status.notice.value]).toEqual(['', null]);
  undo();
  expect(wants.settings.value.pins).toBe('low:6');
  redo();
  await openNamed('b');
  await openNamed('a');
  expect([wants.settings.value.pins, status.notice.value, store.size]).toEqual(['', null, 0]);
});

it('nothing was done where another format alone was chosen, or all of it was taken back', async () => {
  await openNamed('a');
  changeSettings({ compress: 'draco', pins: 'low:6' });
  changeSettings({ pins: '' });
  await openNamed('b');
  expect(store.size).toBe(0);
});

it('it gives way to what a link asks of it', async () => {
  await openNamed('a');
  changeSettings({ pins: 'low:6' });
  const settings = { ...defaultSettings(), pins: 'high:3' };
  const asked = { settings, faces: null, own: new Map(), body: 0, file: null };
  await openFiles([{ name: 'a', bytes: new Uint8Array() }], { asked });
  expect([wants.settings.value.pins, status.notice.value]).toEqual(['high:3', null]);
});

it('what was done to a file comes back in a queue as far as it names parts of the file', async () => {
  await openNamed('a');
  changeSettings({ pins: 'low:6', method: 'qem' });
  wants.faces.value = 7;
  await openNamed('b');
  changeSettings({ method: 'limber' });
  const files = [{ name: 'a', bytes: new Uint8Array() }];
  fillQueue([{ name: 'a', files }]);
  await openFiles(files);
  expect([wants.settings.value.pins, wants.settings.value.method, wants.faces.value]).toEqual([
    'low:6',
    'limber',
    null,
  ]);
  closeQueue();
});
