/** Pins that a body does not have: the earlier ones come back without a step of Undo, and those of another body stay. */

import { beforeAll, beforeEach, expect, it, vi } from 'vitest';
import { WorkerLost } from '../../web/app/state/client';
import type { Client } from '../../web/app/state/client';
import { findPins } from '../../web/app/state/find_pins';
import { refusedLock, setLock } from '../../web/app/state/locks';
import { setPins } from '../../web/app/state/pins';
import { changeSettings, results, status, wants } from '../../web/app/state/store';
import { forgetUndo, readUndo, startUndo, undo, withoutUndo } from '../../web/app/state/undo';
import { CANCELLED } from '../../web/app/worker/protocol';

// The state of the page asks for the colour scheme.
vi.hoisted(() => vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} })));

const why = 'The body has no such vertex.';
const refusing = { call: () => Promise.reject(new Error(why)) } as unknown as Client;
const pins = () => wants.settings.value.pins;

beforeAll(() => startUndo(() => {}));

beforeEach(() => {
  changeSettings({ pins: '', keep: '' });
  results.pins.value = status.refusedPins.value = null;
  forgetUndo();
});

it('refused pins leave no step of Undo', async () => {
  changeSettings({ pins: 'vertices:1' });
  results.pins.value = { text: 'vertices:1', vertices: Uint32Array.of(1) };
  changeSettings({ pins: 'vertices:9' });
  expect(await findPins(refusing, 0)).toBe(results.pins.value);
  expect([pins(), status.refusedPins.value]).toEqual(['vertices:1', { text: 'vertices:9', why }]);
  expect(readUndo().past).toHaveLength(1);
  undo();
  expect(pins()).toBe('');
});

it('Undo and Redo take the sentence on a refused text away, unless it is of the pins that are shown', async () => {
  changeSettings({ pins: 'vertices:1' });
  setPins('nothing');
  setLock('nothing');
  expect([status.refusedPins.value?.text, refusedLock.value?.text]).toEqual(['nothing', 'nothing']);
  undo();
  expect([pins(), status.refusedPins.value, refusedLock.value]).toEqual(['', null, null]);
  changeSettings({ pins: 'vertices:9' });
  await findPins(refusing, 0);
  changeSettings({ keep: 'low:5' });
  undo();
  expect([pins(), status.refusedPins.value?.text]).toEqual(['vertices:9', 'vertices:9']);
});

it('pins of another body stay with a sentence', async () => {
  changeSettings({ pins: 'vertices:9' });
  expect(await findPins(refusing, 1)).toBeNull();
  expect([pins(), status.refusedPins.value]).toEqual(['vertices:9', { text: 'vertices:9', why }]);
});

it('what the page itself changes is a part of the change before it', () => {
  changeSettings({ pins: 'vertices:1' });
  withoutUndo(() => changeSettings({ keep: 'low:5' }));
  expect(readUndo().past).toHaveLength(1);
  undo();
  expect([pins(), wants.settings.value.keep]).toEqual(['', '']);
});

it('an answer on a text that has changed meanwhile changes nothing', async () => {
  const earlier = { text: 'vertices:1', vertices: Uint32Array.of(1) };
  const answer = (reply: () => Promise<unknown>) => {
    results.pins.value = earlier;
    changeSettings({ pins: 'vertices:9' });
    const found = findPins({ call: reply } as unknown as Client, 0);
    changeSettings({ pins: 'vertices:2' });
    return found;
  };
  await expect(answer(() => Promise.reject(new Error(why)))).rejects.toThrow(CANCELLED);
  await expect(answer(() => Promise.resolve({ text: 'vertices:9' }))).rejects.toThrow(CANCELLED);
  expect([pins(), status.refusedPins.value]).toEqual(['vertices:2', null]);
});

it('a worker that has ended refuses no pins', async () => {
  results.pins.value = { text: 'vertices:1', vertices: Uint32Array.of(1) };
  changeSettings({ pins: 'vertices:2' });
  const lost = { call: () => Promise.reject(new WorkerLost('no memory')) } as unknown as Client;
  await expect(findPins(lost, 0)).rejects.toThrow(WorkerLost);
  expect([pins(), status.refusedPins.value]).toEqual(['vertices:2', null]);
});
